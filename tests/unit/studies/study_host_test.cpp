// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/studies/study_host.hpp"

#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

namespace echoarc::studies {
namespace {

/// Runs tasks from the last to the first: an order that no result may depend on.
class BackwardExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t concurrency() const override { return 2; }
  void run(std::size_t count, const std::function<void(std::size_t)>& task) override {
    for (std::size_t k = count; k-- > 0;) task(k);
  }
};

StudyHost host_on(Executor& executor) {
  StudyHost host;
  host.executor = &executor;
  return host;
}

TEST(StudyTasks, ResultsComeInTheOrderOfTheIndex) {
  BackwardExecutor executor;
  StudyHost host = host_on(executor);
  std::vector<double> told;
  host.progress = [&](double fraction) { told.push_back(fraction); };
  StudyProgress progress(host, 4);
  const auto results =
      run_tasks<std::size_t>(host, 4, progress, [](std::size_t k) -> Result<std::size_t> { return 10 * k; });
  ASSERT_TRUE(results);
  EXPECT_EQ(*results, (std::vector<std::size_t>{0, 10, 20, 30}));
  EXPECT_EQ(told, (std::vector{0.25, 0.5, 0.75, 1.0}));
}

TEST(StudyTasks, AnErrorStopsWhatHasNotBegun) {
  InlineExecutor executor;
  const StudyHost host = host_on(executor);
  StudyProgress progress(host, 4);
  std::size_t begun = 0;
  const auto results = run_tasks<int>(host, 4, progress, [&](std::size_t k) -> Result<int> {
    ++begun;
    if (k == 1) return Error{ErrorCode::bad_value, "task 1", "", ""};
    return 0;
  });
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().message, "task 1");
  EXPECT_EQ(begun, 2u);
}

TEST(StudyTasks, CancellingIsAnErrorOfItsOwn) {
  InlineExecutor executor;
  StudyHost host = host_on(executor);
  int asked = 0;
  host.cancelled = [&] { return ++asked > 1; };
  StudyProgress progress(host, 3);
  const auto results = run_tasks<int>(host, 3, progress, [](std::size_t) -> Result<int> { return 1; });
  ASSERT_FALSE(results);
  EXPECT_EQ(results.error().code, ErrorCode::interrupted);
}

}  // namespace
}  // namespace echoarc::studies
