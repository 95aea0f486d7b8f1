// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/checked.h"
#include "base/numbers/short_float.h"
#include "base/numbers/zigzag.h"
#include "entropy/planes.h"

namespace deltamesh {
namespace {

TEST(ByteReader, CON1RoundTripsNumbersAndRejectsTruncation) {
  ByteWriter out;
  out.write(std::uint16_t{0x1234});
  out.write(-1.5);
  out.write(std::int32_t{-7});
  ByteReader in(out.bytes());
  EXPECT_EQ(*in.read<std::uint16_t>(), 0x1234);
  EXPECT_EQ(*in.read<double>(), -1.5);
  EXPECT_EQ(*in.read<std::int32_t>(), -7);
  EXPECT_TRUE(in.finish());
  const auto past = in.read<std::uint8_t>();
  ASSERT_FALSE(past);
  EXPECT_EQ(past.error().code, ErrorCode::kTruncated);
  EXPECT_STREQ(past.error().rule, "CON-1");
  EXPECT_EQ(past.error().where, 14U);
}

TEST(ByteReader, CON2RoundTripsVarints) {
  for (const std::uint64_t value : {0ULL, 1ULL, 127ULL, 128ULL, 16384ULL, ~0ULL}) {
    ByteWriter out;
    out.write_varint(value);
    ByteReader in(out.bytes());
    EXPECT_EQ(*in.read_varint(), value);
    EXPECT_TRUE(in.finish());
  }
}

TEST(ByteReader, CON2RejectsLongAndPaddedVarints) {
  const std::byte padded[] = {std::byte{0x80}, std::byte{0}};
  EXPECT_EQ(ByteReader(padded).read_varint().error().code, ErrorCode::kInvalidStream);
  std::vector<std::byte> overlong(11, std::byte{0xff});
  EXPECT_EQ(ByteReader(overlong).read_varint().error().code, ErrorCode::kInvalidStream);
  const std::byte small[] = {std::byte{9}};
  EXPECT_FALSE(ByteReader(small).read_varint(8));
}

TEST(ByteReader, CON1RejectsAVarintThatTheBytesEndWithin) {
  const std::byte open[] = {std::byte{0x80}};
  for (const std::size_t size : {0U, 1U})
    EXPECT_STREQ(ByteReader(std::span(open).first(size)).read_varint().error().rule, "CON-1");
}

TEST(ByteReader, CON3RejectsBytesLeftOver) {
  const std::byte one[] = {std::byte{1}};
  const auto result = ByteReader(one).finish();
  ASSERT_FALSE(result);
  EXPECT_STREQ(result.error().rule, "CON-3");
}

TEST(ShortFloat, CON6TakesThreeBytes) {
  for (const float value : {0.0F, 1.0F, -2.5F, short_float_above(0.1), short_float_above(1e-30)}) {
    ByteWriter out;
    out.write_short_float(value);
    EXPECT_EQ(out.size(), 3U);
    ByteReader in(out.bytes());
    EXPECT_EQ(*in.read_short_float(), value);
    ByteReader shorter(out.bytes().first(2));
    EXPECT_STREQ(shorter.read_short_float().error().rule, "CON-1");
  }
}

TEST(ShortFloat, CON6RoundsUpOrDown) {
  constexpr double kStep = 0x1p-15;  // between short floats around 1
  EXPECT_EQ(short_float_above(1), 1);
  EXPECT_EQ(short_float_below(1), 1);
  EXPECT_EQ(short_float_above(1 + 1e-12), 1 + kStep);
  EXPECT_EQ(short_float_below(1 + 1.9 * kStep), 1 + kStep);
  EXPECT_EQ(short_float_above(0), 0);
  EXPECT_GT(short_float_above(1e-300), 0);
  EXPECT_EQ(short_float_below(1e-300), 1e-300) << "no step is 0";
  EXPECT_TRUE(std::isinf(short_float_above(3.4028234e38)));
  EXPECT_TRUE(std::isfinite(short_float_below(1e300)));
  EXPECT_TRUE(is_short_float(1 + kStep));
  EXPECT_FALSE(is_short_float(1 + kStep / 2));
  EXPECT_FALSE(is_short_float(1e300));
  EXPECT_FALSE(is_short_float(std::nan("")));
}

TEST(Zigzag, CON4RoundTrips) {
  for (const std::int32_t value : {0, -1, 1, -2, 1000, std::numeric_limits<std::int32_t>::max(),
                                   std::numeric_limits<std::int32_t>::min()})
    EXPECT_EQ(unzigzag(zigzag(value)), value);
  for (const std::int64_t value :
       {std::int64_t{-3}, std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()})
    EXPECT_EQ(unzigzag(zigzag(value)), value);
  EXPECT_EQ(zigzag(-1), 1U);
  EXPECT_EQ(zigzag(1), 2U);
}

TEST(Planes, CON5RoundTripsWithAsFewPlanesAsNeeded) {
  for (const std::uint32_t top : {0U, 200U, 70000U, 0xffffffffU}) {
    const std::vector<std::uint32_t> symbols{0, top, top / 3};
    ByteWriter out;
    write_planes(out, symbols);
    ByteReader in(out.bytes());
    EXPECT_EQ(*read_planes(in, symbols.size()), symbols);
    EXPECT_TRUE(in.finish());
  }
}

TEST(Planes, CON5RejectsACountBeyondTheBytes) {
  const std::byte bytes[] = {std::byte{1}, std::byte{7}};
  ByteReader in(bytes);
  const auto read = read_planes(in, std::uint64_t{1} << 60);
  EXPECT_EQ(read.error().code, ErrorCode::kTruncated);
  EXPECT_STREQ(read.error().rule, "CON-1");
}

TEST(Checked, Saturates) {
  EXPECT_EQ(saturating_mul(1ULL << 40, 1ULL << 40), ~0ULL);
  EXPECT_EQ(saturating_add(~0ULL, 1), ~0ULL);
  EXPECT_EQ(saturating_mul(3, 4), 12U);
}

}  // namespace
}  // namespace deltamesh
