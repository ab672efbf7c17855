// Every kernel that looks for passes, row by row: it leaves out nobody who comes closer than the
// clearance within the step, and hardly anybody else who keeps well away.
#include "cpu/passing.hpp"

#include "tests/core/sweep_scene.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace beespace::cpu {
namespace {

using test::SweepScene;
using test::SweepShape;
using IdPairs = std::multiset<std::pair<PointId, PointId>>;  // asked, other

// What points move in half a step, how far around them is theirs, and how far they get with both.
struct Moving {
  std::array<std::vector<float>, 5> values;  // x, y, z, radius, reach

  // Together with the clearance, two moves and two radii stay within the reach.
  Moving(test::SceneMaker& make, std::size_t size, double longest, double largest_radius) {
    for (auto& each : values) each.resize(size + core::kPadding, 0.0F);
    for (std::size_t i = 0; i < size; ++i) {
      double length = make.below(4) == 0 ? 0.0 : make.between(0.0, longest);
      std::array<double, 3> way{make.between(-1, 1), make.between(-1, 1), make.between(-1, 1)};
      if (make.below(3) == 0) {  // as far along an axis as can be
        length = longest;
        const double sign = make.below(2) == 0 ? -1.0 : 1.0;
        way = {};
        way[make.below(3)] = sign;
      }
      const double norm = std::sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]) + 1e-9;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        values[axis][i] = static_cast<float>(way[axis] / norm * length);
      }
      values[3][i] = static_cast<float>(make.between(0.0, largest_radius));
      values[4][i] = static_cast<float>(length) + values[3][i];
    }
  }

  [[nodiscard]] Moves moves() const {
    return {values[0].data(), values[1].data(), values[2].data(), values[3].data(),
            values[4].data()};
  }
  [[nodiscard]] float farthest() const {
    return *std::max_element(values[4].begin(), values[4].end());
  }
};

// The least distance of two points from one half step before to one after, in doubles.
double closest(const test::PlacedPoints& asked, const Moving& asked_moves, std::uint32_t i,
               const test::PlacedPoints& others, const Moving& other_moves, std::uint32_t j) {
  std::array<double, 3> r{};
  std::array<double, 3> w{};
  double rw = 0.0;
  double ww = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    r[axis] = static_cast<double>(others.at[axis][j]) - asked.at[axis][i];
    w[axis] = double{other_moves.values[axis][j]} - double{asked_moves.values[axis][i]};
    rw += r[axis] * w[axis];
    ww += w[axis] * w[axis];
  }
  const double time = ww > 0.0 ? std::clamp(-rw / ww, -1.0, 1.0) : 0.0;
  double squared = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = r[axis] + w[axis] * time;
    squared += at * at;
  }
  return std::sqrt(squared);
}

// A buffer that is emptied when it is full, so many times and no more.
class Collected {
 public:
  Collected(std::uint32_t capacity, std::size_t rounds)
      : first_(capacity), second_(capacity), rounds_left_(rounds) {
    const auto make_room = [](void* self) { return static_cast<Collected*>(self)->empty(); };
    sink = {first_.data(), second_.data(), 0, capacity, make_room, this};
  }
  Collected(const Collected&) = delete;
  Collected& operator=(const Collected&) = delete;

  const IdPairs& take() {
    for (std::uint32_t k = 0; k < sink.size; ++k) pairs_.emplace(first_[k], second_[k]);
    sink.size = 0;
    return pairs_;
  }

  PairSink sink{};

 private:
  bool empty() {
    EXPECT_LE(sink.size, sink.capacity);
    take();
    return --rounds_left_ > 0;
  }

  std::vector<PointId> first_;
  std::vector<PointId> second_;
  std::size_t rounds_left_;
  IdPairs pairs_;
};

class EveryPassingKernel : public testing::TestWithParam<InstructionSet> {
 protected:
  struct Scene {
    SweepScene points;
    Moving asked;
    Moving others;
    float clearance;

    [[nodiscard]] bool collect(Collected& into) const {
      const Sweep sweep = points.sweep({0.0F, 0.0F}, {nullptr, nullptr});
      const Moving& theirs = points.shape.by_itself ? asked : others;
      return collect_passing(GetParam())(sweep, asked.moves(), theirs.moves(),
                                         {clearance, theirs.farthest()}, into.sink);
    }
    // What they come within of each other, less what is theirs.
    [[nodiscard]] double gap(std::uint32_t i, std::uint32_t j) const {
      const Moving& theirs = points.shape.by_itself ? asked : others;
      return closest(points.asked(), asked, i, points.others(), theirs, j) -
             double{asked.values[3][i]} - double{theirs.values[3][j]};
    }
    [[nodiscard]] std::pair<PointId, PointId> ids(std::uint32_t i, std::uint32_t j) const {
      return {points.asked().id[i], points.others().id[j]};
    }
  };

  // Of all shapes; moves that take up most of the reach, or hardly any of it. Rows of many points,
  // so that windows end anywhere among the lanes.
  template <class Check>
  static void for_each_scene(Check&& check) {
    std::uint32_t seed = 0;
    for (const bool by_itself : {true, false}) {
      for (const unsigned row_shift : {0U, 1U, 3U}) {
        for (const unsigned fraction_bits : {4U, 10U, 22U}) {
          for (const std::uint32_t row_size : {1U, 2U, 15U, 16U, 17U, 33U, 150U, 151U}) {
            if (HasFatalFailure()) return;
            if (test::kSanitized && row_size > 40) continue;
            SweepShape shape{by_itself, false, fraction_bits, row_shift, 12, row_size, 1};
            if (++seed % 3 == 0) shape.reach_cells = 1 << row_shift;
            std::ostringstream shown;
            shown << shape;
            SCOPED_TRACE(shown.str());
            check(scene_of(shape, seed));
          }
        }
      }
    }
  }

 private:
  static Scene scene_of(const SweepShape& shape, std::uint32_t seed) {
    test::SceneMaker make(seed);
    const double reach = std::sqrt(shape.squared_reach());
    // Of the reach: the clearance, the longest move and the largest radius. The last are a search
    // for who is near, as good as at rest, up to the very end of the reach.
    constexpr double kShares[][3] = {{0.1, 0.4, 0.05}, {0.5, 0.2, 0.0}, {0.98, 0.01, 0.0}};
    const auto& [clearance, move, radius] = kShares[make.below(3)];
    SweepScene points = test::random_sweep_scene(shape, seed);
    const std::size_t asked = points.asked().size();
    const std::size_t others = points.others().size();
    return {std::move(points), Moving(make, asked, move * reach, radius * reach),
            Moving(make, others, move * reach, radius * reach),
            static_cast<float>(clearance * reach)};
  }
};

// The kernel works in floats: to whom it matters by less than 2^-17 of a cell, its caller adds that
// to the clearance.
TEST_P(EveryPassingKernel, LeavesOutNobodyWhoPassesWithinTheClearance) {
  std::size_t within = 0;
  std::size_t far = 0;
  std::size_t far_and_collected = 0;
  for_each_scene([&](const Scene& scene) {
    Collected collected(100'000, std::numeric_limits<std::size_t>::max());
    ASSERT_TRUE(scene.collect(collected));
    const IdPairs& pairs = collected.take();
    const double slack = std::ldexp(1.0, static_cast<int>(scene.points.shape.fraction_bits) - 17);
    const double clearance{scene.clearance};
    std::size_t asked_about = 0;
    scene.points.for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
      const std::size_t times = pairs.count(scene.ids(i, j));
      ASSERT_LE(times, 1U);
      asked_about += times;
      const double gap = scene.gap(i, j);
      if (gap < clearance - slack) {
        ASSERT_EQ(times, 1U) << i << " " << j << " come within " << gap << " of " << clearance;
        ++within;
      } else if (gap > clearance + slack) {
        ++far;
        far_and_collected += times;
      }
    });
    ASSERT_EQ(asked_about, pairs.size()) << "pairs that nobody asked about";
  });
  EXPECT_GT(within, 1000U);
  EXPECT_GT(far, 10'000U);
  EXPECT_EQ(far_and_collected, 0U);
}

TEST_P(EveryPassingKernel, FindsTheSameInBuffersOfAnySize) {
  for_each_scene([&](const Scene& scene) {
    if (scene.points.shape.row_size > 40) return;
    Collected large(100'000, std::numeric_limits<std::size_t>::max());
    ASSERT_TRUE(scene.collect(large));
    for (const std::uint32_t capacity : {16U, 17U, 40U}) {
      Collected small(capacity, std::numeric_limits<std::size_t>::max());
      ASSERT_TRUE(scene.collect(small));
      ASSERT_EQ(small.take(), large.take());
    }
  });
}

TEST_P(EveryPassingKernel, StopsWhenThereIsNoMoreRoom) {
  std::size_t stopped = 0;
  for_each_scene([&](const Scene& scene) {
    Collected all(100'000, std::numeric_limits<std::size_t>::max());
    ASSERT_TRUE(scene.collect(all));
    Collected some(20, 2);
    const bool went_on = scene.collect(some);
    const IdPairs& found = some.take();
    if (!went_on) ++stopped;
    ASSERT_TRUE(!went_on || found == all.take());
    ASSERT_TRUE(std::includes(all.take().begin(), all.take().end(), found.begin(), found.end()));
    ASSERT_LE(found.size(), 40U);
  });
  EXPECT_GT(stopped, 10U);
}

std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : kInstructionSets) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, EveryPassingKernel, testing::ValuesIn(available_sets()),
                         [](const auto& instance) { return name_of(instance.param); });

}  // namespace
}  // namespace beespace::cpu
