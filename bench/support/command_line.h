// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The options that programs share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "support/corpus.h"

namespace deltamesh::bench {

/// Which sources of the corpus a run takes.
struct Choice {
  std::string corpus = default_corpus();
  std::string names = ".";  ///< regular expression
  bool quick = false;
};

/// --corpus, --quick, and `option` (--meshes) for the names. `quick`: what is in a quick run.
void add_choice(CLI::App& app, Choice& choice, const std::string& option, const std::string& quick);

/// Takes out of `sources` what was not chosen. `is_quick`: whether a name is in quick runs.
template <class T, class IsQuick>
void keep_chosen(std::vector<Source<T>>& sources, const Choice& choice, IsQuick is_quick) {
  const std::regex wanted(choice.names);
  std::erase_if(sources, [&](const Source<T>& source) {
    return !std::regex_search(source.name, wanted) || (choice.quick && !is_quick(source.name));
  });
}

/// The corpus' chosen meshes; says so on stderr where there are none.
template <class IsQuick>
std::vector<MeshSource> chosen_meshes(const Choice& choice, IsQuick is_quick) {
  std::vector<MeshSource> sources = corpus_meshes(choice.corpus);
  keep_chosen(sources, choice, is_quick);
  if (sources.empty())
    std::fprintf(stderr, "%s: no mesh whose name matches %s\n", choice.corpus.c_str(), choice.names.c_str());
  return sources;
}

/// Parses and runs. Returns the program's exit status: `run`'s, or 2 for a wrong command line.
int parse_and_run(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

}  // namespace deltamesh::bench
