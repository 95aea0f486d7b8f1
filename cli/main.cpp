// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The program `deltamesh`.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "deltamesh/version.h"
#include "exit_codes.h"
#include "report/console.h"

namespace deltamesh::cli {
namespace {

std::string version_text() {
  std::string text = std::string("deltamesh ") + kLibraryVersion + "\nstream format " +
                     std::to_string(kFormatMajor) + '.' + std::to_string(kFormatMinor);
  if (kFormatDraft != 0) text += " (draft " + std::to_string(kFormatDraft) + ", not frozen)";
  return text;
}

int parse_and_run(CLI::App& app, int argc, char** argv, int& status) {
  try {
    app.parse(argc, argv);
    return status;
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> words = app.remaining(true);
    const auto is_option = [](const std::string& word) { return word.starts_with('-') && word != "--"; };
    const auto option = std::find_if(words.begin(), words.end(), is_option);
    if (option != words.end())
      print_error(*option, "no such option; --help lists them");
    else
      print_error(words.empty() ? "" : words.front(), "one word too many; --help shows what goes where");
    return kUsage;
  } catch (const CLI::ParseError& wrong) {
    if (wrong.get_exit_code() == 0) return app.exit(wrong);  // --help and --version
    std::cerr << "deltamesh: " << wrong.what() << "\nRun with --help for more information.\n";
    return kUsage;
  }
}

int run(int argc, char** argv) {
  CLI::App app{"Triangle meshes in few bytes, at the quality you ask for.", "deltamesh"};
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  int status = kOk;
  add_encode_command(app, status);
  add_decode_command(app, status);
  add_info_command(app, status);
  add_verify_command(app, status);
  add_compare_command(app, status);
  add_generate_command(app, status);
  add_gltf_command(app, status);
  add_map_command(app, status);
  add_tiles_command(app, status);
  // Last, as commands take over what their parent has when they are added.
  app.footer(std::string("Examples:\n"
                         "  deltamesh encode bunny.ply bunny.dmsh\n"
                         "  deltamesh decode bunny.dmsh bunny_again.ply\n"
                         "  deltamesh generate rooms map.ply --vertices 50000\n"
                         "`deltamesh COMMAND --help` tells more.\n\n") +
             kExitCodesHelp);
  if (argc < 2) {
    std::cerr << app.help();
    return kUsage;
  }
  const std::string first = argv[1];
  const auto is_first = [&first](const CLI::App* command) { return command->get_name() == first; };
  if (!first.starts_with('-') && app.get_subcommands(is_first).empty()) {
    print_error(first, "no such command; `deltamesh --help` lists them");
    return kUsage;
  }
  return parse_and_run(app, argc, argv, status);
}

}  // namespace
}  // namespace deltamesh::cli

int main(int argc, char** argv) try {
  const int status = deltamesh::cli::run(argc, argv);
  std::cout.flush();
  if (std::cout) return status;
  deltamesh::cli::print_error("standard output", "cannot be written");
  return deltamesh::cli::kCannotWrite;
} catch (const std::bad_alloc&) {
  deltamesh::cli::print_error("memory", "there is not enough");
  return deltamesh::cli::kTooLarge;
}
