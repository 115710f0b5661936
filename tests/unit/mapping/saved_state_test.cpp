// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "echoarc/mapping/bayes_update.hpp"
#include "echoarc/mapping/centerline.hpp"
#include "echoarc/mapping/directional_maximum.hpp"
#include "echoarc/mapping/voting.hpp"
#include "support/random_readings.hpp"

namespace echoarc {
namespace {

template <class Method>
class SavedState : public testing::Test {};
using Methods = testing::Types<Centerline, Voting, DirectionalMaximum, BayesUpdate>;
TYPED_TEST_SUITE(SavedState, Methods);

template <class Method>
std::vector<std::byte> saved() {
  Rng rng(5);
  typename Method::Options options;
  options.cell_m = 0.05;
  Method method(options);
  InlineExecutor executor;
  method.insert(test::random_readings(rng, 12), executor);
  method.finish(executor);
  return method.save();
}

TYPED_TEST(SavedState, DamageIsAnErrorNotACrash) {
  const std::vector<std::byte> good = saved<TypeParam>();
  ASSERT_TRUE(TypeParam::restore(good));
  EXPECT_FALSE(TypeParam::restore({}));
  for (std::size_t size : {std::size_t{3}, std::size_t{20}, good.size() / 2, good.size() - 1})
    EXPECT_FALSE(TypeParam::restore(std::span(good).first(size))) << size;
  std::vector<std::byte> longer = good;
  longer.push_back(std::byte{0});
  EXPECT_FALSE(TypeParam::restore(longer));

  Rng rng(11);
  for (int k = 0; k < 300; ++k) {  // anything may come out, but nothing may break
    std::vector<std::byte> damaged = good;
    for (int flips = 0; flips < 3; ++flips)
      damaged[rng.below(std::min<std::size_t>(damaged.size(), 400))] = std::byte(rng.below(256));
    const Result<TypeParam> restored = TypeParam::restore(damaged);
    if (restored) {
      EXPECT_TRUE(validate(restored->options()));
    }
  }
}

TYPED_TEST(SavedState, OfAnotherMethodIsRefused) {
  const std::vector<std::byte> other = TypeParam::name == Voting::name ? saved<Centerline>() : saved<Voting>();
  const Result<TypeParam> restored = TypeParam::restore(other);
  ASSERT_FALSE(restored);
  EXPECT_EQ(restored.error().code, ErrorCode::bad_format);
  EXPECT_FALSE(restored.error().remedy.empty());
}

}  // namespace
}  // namespace echoarc
