// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the program tells the shell. Documented in --help; numbers never change their meaning.
#pragma once

#include "deltamesh/result.h"

namespace deltamesh::cli {

enum ExitCode : int {
  kOk = 0,
  kBadStream = 1,     ///< a .dmsh stream or a map is damaged or lacks parts, or `compare --order` found other
                      ///< triangles
  kUsage = 2,         ///< the command line is wrong
  kBadInput = 3,      ///< an input file is missing, unreadable or not what its suffix says
  kCannotWrite = 4,   ///< an output cannot be written
  kUnmetRequest = 5,  ///< the asked quality cannot be had
  kTooLarge = 6,      ///< out of memory, or larger than the format holds
  kInternal = 7,      ///< a bug of the program
};

/// Text of the section "Exit codes" of --help.
inline constexpr const char* kExitCodesHelp =
    "Exit codes:\n"
    "  0  done\n"
    "  1  a .dmsh stream or a map is damaged or lacks parts, or compare --order found other triangles\n"
    "  2  wrong command line (an unknown file suffix too)\n"
    "  3  an input file is missing, unreadable or invalid\n"
    "  4  an output cannot be written\n"
    "  5  the asked quality cannot be had\n"
    "  6  out of memory, or larger than the format holds\n"
    "  7  a fault of the program itself; please report it\n"
    "  130, 143  stopped by Ctrl-C or TERM; no file is half-written\n";

ExitCode exit_code_of(ErrorCode code) noexcept;

}  // namespace deltamesh::cli
