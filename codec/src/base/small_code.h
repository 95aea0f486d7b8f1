// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Differences of small builds (DELTAMESH_SMALL: the WebAssembly modules, which are compiled while they load).
#pragma once

#ifdef DELTAMESH_SMALL
inline constexpr bool kSmallCode = true;
/// Called in a loop for every vertex: engines of WebAssembly compile a function well while it is used, and go
/// on with that at its next call, so that a loop without calls stays slow to its end.
#define DELTAMESH_LOOP_BODY [[gnu::noinline]]
/// For functions that fill a table: here when a module starts, elsewhere when it is compiled.
#define DELTAMESH_TABULATE inline
#else
inline constexpr bool kSmallCode = false;
#define DELTAMESH_LOOP_BODY
#define DELTAMESH_TABULATE constexpr
#endif
