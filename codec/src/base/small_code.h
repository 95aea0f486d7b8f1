// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Differences of small builds (DELTAMESH_SMALL: the WebAssembly modules, which are compiled while they load).
#pragma once

#include <algorithm>
#include <cstdint>

#ifdef DELTAMESH_SMALL
inline constexpr bool kSmallCode = true;
/// Called in a loop for every vertex: engines of WebAssembly compile a function well while it is used, and go
/// on with that at its next call, so that a loop without calls stays slow to its end.
#define DELTAMESH_LOOP_BODY [[gnu::noinline]]
/// For what many streams do without: engines compile a function when it is first called, and all that is
/// inlined into it.
#define DELTAMESH_APART [[gnu::noinline]]
/// For functions that fill a table: here when a module starts, elsewhere when it is compiled.
#define DELTAMESH_TABULATE inline
#else
inline constexpr bool kSmallCode = false;
#define DELTAMESH_LOOP_BODY
#define DELTAMESH_APART
#define DELTAMESH_TABULATE constexpr
#endif

namespace deltamesh {

/// `body` is a copy, which nothing else can change: what it holds stays in registers.
template <class Body>
DELTAMESH_LOOP_BODY void take_turn(Body body, std::uint32_t begin, std::uint32_t end) {
  body(begin, end);
}

/// `body(begin, end)` for 0 .. `count`: here for some at a time, like a loop's body, elsewhere for all at
/// once.
template <class Body>
void in_turns(std::uint32_t count, const Body& body) {
  constexpr std::uint32_t kTurn = 256;
  if constexpr (kSmallCode) {
    for (std::uint32_t begin = 0; begin < count; begin += kTurn)
      take_turn(body, begin, begin + std::min(kTurn, count - begin));
  } else {
    body(0, count);
  }
}

}  // namespace deltamesh
