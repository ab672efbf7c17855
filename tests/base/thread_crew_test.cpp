#include "base/crew_size.hpp"

#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <vector>

namespace beespace::cpu {
namespace {

TEST(ThreadCrew, CallsEveryWorkerOnceARound) {
  ThreadCrew crew(4);
  std::vector<std::atomic<int>> calls(crew.size());
  for (int round = 0; round < 200; ++round) {
    crew.run([&](unsigned worker) { ++calls[worker]; });
  }
  for (const auto& count : calls) EXPECT_EQ(count, 200);
}

TEST(ThreadCrew, SharesCoverEverythingOnce) {
  ThreadCrew crew(3);
  for (const std::size_t count : {0U, 1U, 2U, 3U, 1000U}) {
    std::vector<std::atomic<int>> touched(count);
    crew.split(count, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) ++touched[i];
    });
    for (const auto& times : touched) EXPECT_EQ(times, 1);
  }
}

TEST(ThreadCrew, ARunningOutOfMemoryReachesTheCallerAndTheCrewLivesOn) {
  ThreadCrew crew(3);
  EXPECT_THROW(crew.run([](unsigned worker) {
    if (worker == 2) throw std::bad_alloc();
  }),
               std::bad_alloc);
  std::atomic<int> calls = 0;
  crew.run([&](unsigned) { ++calls; });
  EXPECT_EQ(calls, 3);
}

TEST(CrewSize, IsSmallForSmallSearches) {
  EXPECT_EQ(crew_size(8, 10), 1U);
  EXPECT_EQ(crew_size(8, 10'000'000), 8U);
  EXPECT_GE(crew_size(0, 10'000'000), 1U);
  EXPECT_EQ(crew_size(1, 10'000'000), 1U);
}

}  // namespace
}  // namespace beespace::cpu
