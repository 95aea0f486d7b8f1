// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "exit_codes.h"

namespace deltamesh::cli {

ExitCode exit_code_of(ErrorCode code) noexcept {
  switch (code) {
    case ErrorCode::kTruncated:
    case ErrorCode::kBadMagic:
    case ErrorCode::kUnsupportedVersion:
    case ErrorCode::kCorrupt:
    case ErrorCode::kInvalidStream:
    case ErrorCode::kUnsupportedFeature:
      return kBadStream;
    case ErrorCode::kInvalidArgument:
    case ErrorCode::kUnknownFormat:
      return kUsage;
    case ErrorCode::kInvalidMesh:
    case ErrorCode::kNotFinite:
    case ErrorCode::kFileOpen:
    case ErrorCode::kFileRead:
    case ErrorCode::kInvalidFile:
      return kBadInput;
    case ErrorCode::kFileWrite:
      return kCannotWrite;
    case ErrorCode::kUnmetRequest:
      return kUnmetRequest;
    case ErrorCode::kLimitExceeded:
    case ErrorCode::kOutOfMemory:
      return kTooLarge;
    case ErrorCode::kInternal:
      break;
  }
  return kInternal;
}

}  // namespace deltamesh::cli
