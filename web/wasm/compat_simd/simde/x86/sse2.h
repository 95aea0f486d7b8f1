// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// In place of SIMDe's header, which has few of its functions for WebAssembly in vectors: emscripten has those
// of SSE2.
#pragma once

#include <emmintrin.h>

#define simde_mm_add_epi32 _mm_add_epi32
#define simde_mm_and_si128 _mm_and_si128
#define simde_mm_andnot_si128 _mm_andnot_si128
#define simde_mm_castsi128_ps _mm_castsi128_ps
#define simde_mm_cvtepi32_pd _mm_cvtepi32_pd
#define simde_mm_cvtps_epi32 _mm_cvtps_epi32
#define simde_mm_cvtsi128_si64 _mm_cvtsi128_si64
#define simde_mm_cvtsi32_si128 _mm_cvtsi32_si128
#define simde_mm_loadh_pi _mm_loadh_pi
#define simde_mm_loadl_epi64 _mm_loadl_epi64
#define simde_mm_madd_epi16 _mm_madd_epi16
#define simde_mm_movemask_epi8 _mm_movemask_epi8
#define simde_mm_movemask_ps _mm_movemask_ps
#define simde_mm_mul_epu32 _mm_mul_epu32
#define simde_mm_or_si128 _mm_or_si128
#define simde_mm_packs_epi16 _mm_packs_epi16
#define simde_mm_packs_epi32 _mm_packs_epi32
#define simde_mm_set1_epi32 _mm_set1_epi32
#define simde_mm_set_epi32 _mm_set_epi32
#define simde_mm_shuffle_epi32 _mm_shuffle_epi32
#define simde_mm_slli_epi64 _mm_slli_epi64
#define simde_mm_sqrt_pd _mm_sqrt_pd
#define simde_mm_sqrt_ps _mm_sqrt_ps
#define simde_mm_srai_epi32 _mm_srai_epi32
#define simde_mm_srli_epi64 _mm_srli_epi64
#define simde_mm_storel_epi64 _mm_storel_epi64
#define simde_mm_unpackhi_epi16 _mm_unpackhi_epi16
#define simde_mm_unpacklo_epi16 _mm_unpacklo_epi16
#define simde_mm_unpacklo_epi64 _mm_unpacklo_epi64
using simde__m128 = __m128;
using simde__m128d = __m128d;
using simde__m128i = __m128i;
using simde__m64 = __m64;
