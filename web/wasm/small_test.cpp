// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tests small/vector, which no native build has.
#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "base/memory/large_vector.h"
#include "runtime.h"

namespace {

int live = 0;  ///< elements that are not destroyed yet

/// Counts itself; is moved and copied by functions.
struct Counted {
  explicit Counted(int n) : number(std::make_unique<int>(n)) { ++live; }
  Counted() : Counted(7) {}
  Counted(const Counted& other) : Counted(*other.number) {}
  Counted(Counted&& other) noexcept : number(std::move(other.number)) { ++live; }
  Counted& operator=(const Counted& other) {
    number = std::make_unique<int>(*other.number);
    return *this;
  }
  Counted& operator=(Counted&&) noexcept = default;
  ~Counted() { --live; }
  friend bool operator==(const Counted& a, const Counted& b) { return *a.number == *b.number; }
  std::unique_ptr<int> number;
};

struct Three {
  int three = 3;
  friend bool operator==(const Three&, const Three&) = default;
};

#define CHECK(condition) \
  if (!(condition)) return __LINE__

int test_numbers() {
  CHECK(std::vector<int>().empty() && std::vector<int>().data() == nullptr);
  CHECK((std::vector<int>(3) == std::vector<int>{0, 0, 0}));
  CHECK((std::vector<int>(2, 5) == std::vector<int>{5, 5}));
  CHECK((std::vector<Three>(2) == std::vector<Three>(2, Three{3})));
  std::vector<int> v;
  for (int i = 0; i < 100; ++i) v.push_back(i);
  CHECK(v.size() == 100 && v.capacity() >= 100 && v.front() == 0 && v.back() == 99 && v[50] == 50);
  v.resize(3);
  for (int i = 0; i < 100; ++i) v.push_back(v[1]);  // of itself, while it grows
  CHECK(v.size() == 103 && v[2] == 2 && v[3] == 1 && v[102] == 1);
  v.resize(2);
  v.resize(4);
  v.resize(6, v[1]);
  CHECK((v == std::vector<int>{0, 1, 0, 0, 1, 1}));
  v.insert(v.begin() + 1, v[5]);
  const std::array<long, 2> more{8, 9};
  v.insert(v.end(), more.begin(), more.end());
  CHECK((v == std::vector<int>{0, 1, 1, 0, 0, 1, 1, 8, 9}));
  v.insert(v.begin(), 2, v[8]);
  CHECK((v == std::vector<int>{9, 9, 0, 1, 1, 0, 0, 1, 1, 8, 9}));
  CHECK(*v.erase(v.begin() + 9) == 9 && v.size() == 10);
  CHECK(*v.erase(v.begin(), v.begin() + 2) == 0 && v.size() == 8);
  CHECK(std::erase(v, 1) == 4 && std::erase_if(v, [](int i) { return i == 9; }) == 1);
  CHECK((v == std::vector<int>{0, 0, 0}));
  v.shrink_to_fit();
  CHECK(v.capacity() == 3);
  v.assign(2, v[0]);
  CHECK((v == std::vector<int>{0, 0}));
  const std::list<int> list{4, 5, 6};
  v.assign(list.begin(), list.end());
  CHECK((v == std::vector<int>{4, 5, 6}) && v < (std::vector<int>{4, 6}) && (std::vector<int>{4} < v));
  CHECK(*v.rbegin() == 6 && v.rend() - v.rbegin() == 3);
  v = {};
  CHECK(v.empty());
  return 0;
}

int test_objects() {
  {
    std::vector<Counted> v(2);
    for (int i = 0; i < 20; ++i) v.emplace_back(i);
    for (int i = 0; i < 20; ++i) v.push_back(v[2 + i]);
    CHECK(live == 42 && *v[0].number == 7 && *v[21].number == 19 && *v[41].number == 19);
    std::vector<Counted> copy = v;
    CHECK(live == 84 && copy == v);
    copy.insert(copy.begin() + 1, copy[41]);
    copy.erase(copy.begin());
    CHECK(live == 84 && *copy[0].number == 19 && *copy[1].number == 7);
    copy = std::move(v);
    CHECK(live == 42 && v.empty() && copy.size() == 42);
    copy.resize(50);
    copy.resize(1);
    v = copy;
    v.swap(copy);
    copy.pop_back();
    CHECK(live == 1 && v.size() == 1);
  }
  CHECK(live == 0);
  std::vector<std::vector<std::string>> nested(3, {"a string that does not fit into its object", "b"});
  nested.push_back(nested[1]);
  nested.erase(nested.begin());
  CHECK(nested.size() == 3 && nested[2][0].size() == 42 && nested[2][1] == "b");
  return 0;
}

int test_alignment() {
  struct alignas(32) Wide {
    std::uint8_t byte = 1;
  };
  for (std::size_t n = 1; n < 20; ++n) {
    std::vector<Wide> v(n);
    CHECK(reinterpret_cast<std::uintptr_t>(v.data()) % 32 == 0 && v.back().byte == 1);
  }
  deltamesh::LargeVector<int> v(3, 1);
  v.resize(5, 2);
  CHECK(v.size() == 5 && v[2] == 1 && v[4] == 2);
  return 0;
}

}  // namespace

extern "C" {
/// 0, or the line of the first check that fails.
DELTAMESH_EXPORT(test) int test() {
  if (const int line = test_numbers(); line != 0) return line;
  if (const int line = test_objects(); line != 0) return line;
  return test_alignment();
}

/// The sum of as many zeros.
DELTAMESH_EXPORT(sum_of_zeros) double sum_of_zeros(std::size_t count) {
  static std::vector<double> zeros;
  zeros = std::vector<double>(count);
  double sum = 0;
  for (const double zero : zeros) sum += zero;
  return sum;
}
}
