// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/core/bytes.hpp"

#include <gtest/gtest.h>

namespace echoarc {
namespace {

TEST(Bytes, ReadsBackWhatWasWritten) {
  ByteWriter writer;
  writer.put(std::int32_t{-7});
  writer.put_vector(std::vector<double>{1.5, -2.5});
  const std::vector<std::byte> bytes = std::move(writer).take();
  ByteReader reader(bytes);
  EXPECT_EQ(reader.get<std::int32_t>(), -7);
  EXPECT_EQ(reader.get_vector<double>(), (std::vector<double>{1.5, -2.5}));
  EXPECT_TRUE(reader.done());
}

TEST(Bytes, ShortAndHostileBuffersFailWithoutAllocating) {
  ByteWriter writer;
  writer.put(std::uint64_t{1} << 60);  // an element count no buffer can hold
  const std::vector<std::byte> bytes = std::move(writer).take();
  ByteReader reader(bytes);
  EXPECT_TRUE(reader.get_vector<double>().empty());
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(reader.get<int>(), 0) << "after a failure every read fails";
}

}  // namespace
}  // namespace echoarc
