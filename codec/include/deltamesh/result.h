// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The one result type of the library: a value, or an Error that says what is wrong, where, and which rule it
// breaks.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace deltamesh {

/// Error codes. Numbers are grouped; a released number is never reused.
enum class ErrorCode : std::uint16_t {
  // 1xx: the stream is bad.
  kTruncated = 100,           ///< bytes end before the structure does
  kBadMagic = 101,            ///< not a deltamesh stream
  kUnsupportedVersion = 102,  ///< a stream of another format version
  kCorrupt = 103,             ///< a checksum does not match
  kInvalidStream = 104,       ///< a rule of the specification (spec/) is broken
  kUnsupportedFeature = 105,  ///< a chunk or codec that this build does not know and may not skip
  // 2xx: the caller's argument or mesh is bad.
  kInvalidArgument = 200,  ///< an option outside its range, or two that contradict each other
  kInvalidMesh = 201,      ///< index out of range, mismatching sizes
  kLimitExceeded = 202,    ///< larger than DecodeLimits or the format allows
  kUnmetRequest = 203,     ///< a quality request that cannot be met
  kNotFinite = 204,        ///< a mesh with a coordinate that is NaN or infinite
  // 3xx: files.
  kFileOpen = 300,
  kFileRead = 301,
  kFileWrite = 302,
  kUnknownFormat = 303,  ///< file suffix or content that no importer or exporter knows
  kInvalidFile = 304,    ///< a mesh file that breaks its own format
  // 9xx: us.
  kOutOfMemory = 900,
  kInternal = 901,  ///< a bug of ours; please report
};

/// The kind of place that `Error::where` gives.
enum class WhereKind : std::uint8_t {
  kNone,
  kByte,
  kLine,
  kVertex,
  kTriangle,
  kAttribute,
  kElement,
  kAccessor,
  kPrimitive  ///< of glTF, counted over all meshes; `found` has its mesh and its place there
};

/// An error value. No allocation: `message` and `rule` point to static strings.
struct Error {
  ErrorCode code = ErrorCode::kInternal;
  const char* message = "";  ///< one sentence without a final stop
  const char* rule = "";     ///< tag of the spec rule that is broken, such as "DIR-4"; may be empty
  WhereKind where_kind = WhereKind::kNone;
  std::uint64_t where = 0;      ///< position, as `where_kind` counts it
  std::uint32_t chunk_tag = 0;  ///< four-character tag of the chunk concerned, first letter lowest; 0 if none
  double best_value = 0;        ///< kUnmetRequest: the best figure that can be had, model units; 0 if none
  std::uint64_t best_bytes = 0;  ///< kUnmetRequest: the size of the stream that has it; 0 if none
  /// Text, or the name of a place, at fault, cut to 47 bytes and a 0; may be empty.
  std::array<char, 48> found{};
};

/// One line for people: "what, where, chunk [rule]".
std::string describe(const Error& error);

/// The part of a result that does not depend on its type: whether it has a value, else its error.
class ResultState {
 public:
  bool has_value() const noexcept { return has_value_; }
  explicit operator bool() const noexcept { return has_value_; }
  /// Precondition: not has_value().
  const Error& error() const noexcept { return error_; }

 protected:
  ResultState() noexcept : has_value_(true) {}
  /// One function for all, as results are everywhere and errors are rare.
  [[gnu::noinline]] ResultState(const Error& error) noexcept : has_value_(false), error_(error) {}
  // Protected, so that nobody copies the state of a result without its value.
  ResultState(const ResultState&) noexcept = default;
  ResultState& operator=(const ResultState&) noexcept = default;
  ~ResultState() = default;

 private:
  bool has_value_;
  union {
    Error error_;
  };
};

/// A `T` or an `Error`, moved but not copied; else like std::expected, which the supported compilers lack.
template <class T>
class [[nodiscard]] Result : public ResultState {
 public:
  using value_type = T;
  Result(T&& value) : value_(std::move(value)) {}              // NOLINT(google-explicit-constructor)
  Result(const T& value) : value_(value) {}                    // NOLINT(google-explicit-constructor)
  Result(const Error& error) noexcept : ResultState(error) {}  // NOLINT(google-explicit-constructor)
  Result(Result&& other) noexcept(std::is_nothrow_move_constructible_v<T>) : ResultState(other) {
    if (has_value()) std::construct_at(&value_, std::move(other.value_));
  }
  Result& operator=(Result&& other) noexcept {
    static_assert(std::is_nothrow_move_constructible_v<T>,
                  "assignment destroys the old value before it moves the new one");
    if (this != &other) {
      std::destroy_at(this);
      std::construct_at(this, std::move(other));
    }
    return *this;
  }
  ~Result() {
    if (has_value()) std::destroy_at(&value_);
  }

  /// Precondition of all: has_value().
  T& operator*() & noexcept { return value_; }
  const T& operator*() const& noexcept { return value_; }
  T&& operator*() && noexcept { return std::move(value_); }
  T* operator->() noexcept { return &value_; }
  const T* operator->() const noexcept { return &value_; }

 private:
  union {
    T value_;
  };
};

template <>
class [[nodiscard]] Result<void> : public ResultState {
 public:
  Result() noexcept {}  // NOLINT(modernize-use-equals-default): which would write zeros
  Result(const Error& error) noexcept : ResultState(error) {}  // NOLINT(google-explicit-constructor)
};

}  // namespace deltamesh
