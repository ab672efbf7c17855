// The kernels of rows of every instruction set of this processor, against plain double arithmetic.
#include "kernels/sweep.hpp"

#include "tests/kernels/kernel_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace beespace::cpu {
namespace {

using test::PlacedPoints;
using test::Spot;

class EveryRowKernel : public KernelScenes {};

PositionBox box_of(const SweepScene& scene) {
  PositionBox box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto* const at = scene.asked().at[axis].data();
    const auto [low, high] = std::minmax_element(at + scene.points.begin, at + scene.points.end);
    box.low[axis] = *low;
    box.high[axis] = *high;
  }
  return box;
}

double squared_between(const PositionBox& box, const PlacedPoints& set, std::uint32_t j) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = set.at[axis][j];
    const double beside = std::max({box.low[axis] - at, at - box.high[axis], 0.0});
    sum += beside * beside;
  }
  return sum;
}

TEST_P(EveryRowKernel, PicksWhatIsAroundABoxInItsOrder) {
  std::size_t picked = 0;
  std::size_t left_out = 0;
  for_each_scene(false, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const PlacedPoints& others = scene.others();
    if (scene.points.begin == scene.points.end) return;
    const PositionBox box = box_of(scene);
    PlacedPoints out;
    for (std::vector<std::int32_t>& axis : out.at) axis.resize(others.size());  // with padding
    out.id.resize(others.size());
    const std::uint32_t size = kernels().pick_around(
        others.positions(), scene.size(), box, limits,
        {out.at[0].data(), out.at[1].data(), out.at[2].data(), out.id.data()});
    std::uint32_t next = 0;
    for (std::uint32_t j = 0; j < scene.size(); ++j) {
      const double squared = squared_between(box, others, j);
      const auto far = static_cast<double>(limits.far);
      const bool is_picked = next < size && out.id[next] == others.id[j];
      // By floats, as the pairs themselves.
      ASSERT_TRUE(is_picked || squared > far * (1.0 - 0x1p-20));
      ASSERT_TRUE(!is_picked || squared < far * (1.0 + 0x1p-20));
      if (!is_picked) {
        ++left_out;
        continue;
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(out.at[axis][next], others.at[axis][j]);
      }
      ++next;
    }
    ASSERT_EQ(next, size);
    picked += size;
  });
  EXPECT_GT(picked, 1000U);
  EXPECT_GT(left_out, 1000U);
}

// A point that is as far off as the limit says, by rounded arithmetic, is picked for every box that
// the other one lies in.
TEST_P(EveryRowKernel, PicksAllThatAreAtMostSoFarFromAPointOfTheBox) {
  std::mt19937 random(7);
  const auto below = [&](std::uint32_t limit) {
    return static_cast<std::int32_t>(random() % limit);
  };
  for (int round = 0; round < 10'000; ++round) {
    const Spot asked{below(1U << 30), below(1U << 30), below(1U << 30)};
    PlacedPoints other;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int32_t at = asked[axis] + below(1U << 23) - (1 << 22);
      other.at[axis].assign(1 + core::kPadding, std::clamp(at, 0, (1 << 30) - 1));
    }
    other.id.assign(1 + core::kPadding, 0);
    // The very distance that the kernel computes: the least limit for which the pair is open.
    float limit = 0.0F;
    for (float step = 0x1p60F; step > 0.0F; step /= 2.0F) {
      Open open;
      const RowQuery query{
          asked[0],     asked[1], asked[2], 0, other.positions(), {0, 1}, {-1.0F, limit + step},
          open.unsure()};
      (void)kernels().count_row(query);
      if (open.pairs.empty()) limit += step;
    }
    limit = std::nextafter(limit, std::numeric_limits<float>::infinity());
    PositionBox box{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = asked[axis] - below(1U << 22);
      box.high[axis] = asked[axis] + below(1U << 22);
    }
    PlacedPoints out = other;
    ASSERT_EQ(kernels().pick_around(
                  other.positions(), 1, box, {-1.0F, limit},
                  {out.at[0].data(), out.at[1].data(), out.at[2].data(), out.id.data()}),
              1U);
  }
}

TEST_P(EveryRowKernel, CountsAndWritesTheRowOfOnePoint) {
  std::size_t found = 0;
  for_each_scene(false, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const PlacedPoints& asked = scene.asked();
    const PlacedPoints& others = scene.others();
    std::vector<PointId> row(scene.size() + core::kPadding);
    for (std::uint32_t i = scene.points.begin; i < scene.points.end; ++i) {
      // All of the others, then parts that begin and end anywhere.
      for (const Range range : {Range{0, scene.size()}, Range{scene.size() / 3, scene.size()},
                                Range{1, scene.size() - scene.size() / 2}}) {
        if (range.begin > range.end) continue;
        std::vector<PointId> expected;
        PlacePairs unsure;
        for (std::uint32_t j = range.begin; j < range.end; ++j) {
          const double squared = scene.squared(i, j);
          bool is_near = squared < static_cast<double>(limits.near);
          if (!is_near && squared <= static_cast<double>(limits.far)) {
            unsure.emplace_back(i, j);
            is_near = decided_near(i, j);
          }
          if (is_near) expected.push_back(others.id[j]);
        }
        Open open;
        const RowQuery query{asked.at[0][i],     asked.at[1][i], asked.at[2][i], i,
                             others.positions(), range,          limits,         open.unsure()};
        ASSERT_EQ(kernels().count_row(query), expected.size());
        ASSERT_EQ(open.sorted(), unsure);
        const std::uint32_t size = kernels().write_row(query, row.data());
        ASSERT_EQ(std::vector<PointId>(row.begin(), row.begin() + size), expected);
        found += size;
      }
    }
  });
  EXPECT_GT(found, 1000U);
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, EveryRowKernel, testing::ValuesIn(available()),
                         [](const auto& test_case) { return name_of(test_case.param); });

}  // namespace
}  // namespace beespace::cpu
