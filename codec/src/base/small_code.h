// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What becomes a function of its own where code has to be small and a compiler works while it runs
// (DELTAMESH_SMALL: the modules in WebAssembly), and is inlined elsewhere.
#pragma once

#ifdef DELTAMESH_SMALL
namespace deltamesh {
inline constexpr bool kDecisionsAreFunctions = true;  ///< of the compact coder
}
/// Called in many places: there is one copy.
#define DELTAMESH_INLINE_UNLESS_SMALL [[gnu::noinline]]
/// Called in a loop for every vertex: engines of WebAssembly compile a function well while it is used, and go
/// on with that at its next call, so that a loop without calls stays slow to its end.
#define DELTAMESH_LOOP_BODY [[gnu::noinline]]
/// For functions that fill a table: here when a module starts, elsewhere when it is compiled.
#define DELTAMESH_TABULATE inline
#else
namespace deltamesh {
inline constexpr bool kDecisionsAreFunctions = false;
}
#define DELTAMESH_INLINE_UNLESS_SMALL [[gnu::always_inline]]
#define DELTAMESH_LOOP_BODY
#define DELTAMESH_TABULATE constexpr
#endif
