// Every item is worked on once, by one worker at a time, and what goes wrong reaches the caller.
#include "run/executor.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace carom {
namespace {

class OfThreads : public testing::TestWithParam<unsigned> {};

TEST_P(OfThreads, WorkOnEveryItemOnce) {
  const auto executor = make_executor(GetParam());
  EXPECT_EQ(executor->workers(), GetParam());
  for (const std::size_t count : {0, 1, 2, 1000}) {
    std::vector<std::atomic<int>> done(count);
    std::vector<std::atomic<int>> busy(executor->workers());
    executor->for_each(count, [&](std::size_t item, std::size_t worker) {
      EXPECT_EQ(busy.at(worker).fetch_add(1), 0) << "two threads work as worker " << worker;
      ++done[item];
      --busy[worker];
    });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  }
}

TEST_P(OfThreads, HandOnWhatAnItemThrowsAndGoOnWorking) {
  const auto executor = make_executor(GetParam());
  for (int round = 0; round < 20; ++round) {
    const auto fail = [](std::size_t item, std::size_t) {
      if (item == 7) throw std::runtime_error("item 7");
    };
    EXPECT_THROW(executor->for_each(50, fail), std::runtime_error);
    std::atomic<int> done = 0;
    executor->for_each(50, [&](std::size_t, std::size_t) { ++done; });
    EXPECT_EQ(done, 50);
  }
}

INSTANTIATE_TEST_SUITE_P(Count, OfThreads, testing::Values(1U, 2U, 8U));

}  // namespace
}  // namespace carom
