// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "report/table.h"

#include <cstdio>

namespace deltamesh::bench {

std::string table_head(const Cells& names, std::size_t texts) {
  std::string text = table_row(names) + '|';
  for (std::size_t i = 0; i < names.size(); ++i) text += i < texts ? "---|" : "---:|";
  return text + '\n';
}

std::string table_row(const Cells& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += cell.empty() ? " |" : " " + cell + " |";
  return text + '\n';
}

std::string csv_row(const Cells& cells) {
  std::string text;
  for (const std::string& cell : cells) text += (&cell == cells.data() ? "" : ",") + cell;
  return text + "\r\n";
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result.append(c == '"' ? 2 : 1, c);
  return result + '"';
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace deltamesh::bench
