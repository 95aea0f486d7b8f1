// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/command_line.h"

namespace deltamesh::bench {
namespace {

std::string check_regex(const std::string& pattern) try {
  const std::regex compiled(pattern);
  return {};
} catch (const std::regex_error&) {
  return "not a regular expression: " + pattern;
}

}  // namespace

void add_choice(CLI::App& app, Choice& choice, const std::string& option, const std::string& quick) {
  app.add_option("--corpus", choice.corpus, "Folder of the corpus (default: $DELTAMESH_CORPUS)")
      ->capture_default_str();
  app.add_option(option, choice.names, "Only those whose name has a match of this regular expression")
      ->check(check_regex);
  app.add_flag("--quick", choice.quick, quick);
}

int parse_and_run(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  return run();
}

}  // namespace deltamesh::bench
