// A search out of core keeps to its memory, however unlike its cells are.
#include <beespace/out_of_core.hpp>

#include "scenes/random_stream.hpp"
#include "tests/support/process_memory.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <utility>
#include <vector>

namespace beespace {
namespace {

constexpr std::uint64_t kMemory = std::uint64_t{64} << 20U;
constexpr std::size_t kPoints = 6'000'000;

// A tenth lies in balls of 200,000, which are a million times as dense as the rest.
void add_clusters(OutOfCore& search) {
  scenes::RandomStream random(7);
  const double side = std::cbrt(2.0 * kPoints);
  constexpr std::size_t kInBall = 200'000;
  const double ball = std::cbrt(2e-6 * kInBall);
  Point corner;
  std::size_t left = 0;
  std::vector<Point> points(60'000);
  for (std::size_t added = 0; added < kPoints; added += points.size()) {
    for (Point& point : points) {
      point = {random.uniform(0.0, side), random.uniform(0.0, side), random.uniform(0.0, side)};
      if (random.index(10) != 0) continue;
      if (left == 0) {
        corner = point;
        left = kInBall;
      }
      --left;
      point = {corner.x + random.uniform(0.0, ball), corner.y + random.uniform(0.0, ball),
               corner.z + random.uniform(0.0, ball)};
    }
    ASSERT_TRUE(search.add(points));
  }
}

TEST(OutOfCoreMemory, IsKeptToWithinATenth) {
  if (test::kSanitized) GTEST_SKIP() << "sanitizers have memory of their own";
  if (!test::reset_peak()) GTEST_SKIP() << "this system does not tell the most memory";
  const auto folder = std::filesystem::temp_directory_path().string();
  OutOfCore search({.memory_bytes = kMemory, .folder = folder, .threads = 2});
  add_clusters(search);
  const std::uint64_t before = *test::status_bytes("RssFile:");
  std::uint64_t found = 0;
  const auto tally = [&](auto some) { found += some.size(); };
  const std::vector<std::pair<const char*, std::function<Status()>>> questions = {
      {"at risk", [&] { return search.find_at_risk({.threshold_m = 0.5}, tally); }},
      {"counts", [&] {
         return search.count_neighbors({.threshold_m = 0.05},
                                       [&](auto ids, auto /*counts*/) { found += ids.size(); });
       }}};
  for (const auto& [name, ask] : questions) {
    ASSERT_TRUE(test::reset_peak());
    ASSERT_TRUE(ask());
    EXPECT_GT(search.facts().cells, 15U) << name;
    const std::uint64_t peak = *test::status_bytes("VmHWM:") - before;
    EXPECT_LT(static_cast<double>(peak), 1.1 * static_cast<double>(kMemory)) << name;
  }
  EXPECT_GT(found, kPoints);
}

}  // namespace
}  // namespace beespace
