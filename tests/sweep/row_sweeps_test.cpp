// Rows, targets and sides, without a kernel: the pairs that sweeps compare, by the rules of
// sweep.hpp, are all pairs within the reach, as often as required.
#include "sweep/row_sweeps.hpp"

#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cpu {
namespace {

using IdPairs = std::map<std::pair<PointId, PointId>, int>;  // how often each was asked for

using Around = RowSweeps::Around;

// Calls visit(asked, other) for all pairs that a sweep compares. Pairs of a row are compared once,
// or from both points where all rows around are targets.
template <class Visit>
void for_each_asked(const Sweep& sweep, Around around, Visit&& visit) {
  const std::int32_t last = (1 << sweep.row_shift) - 1;
  const auto sides = [&](std::int32_t position, unsigned low, unsigned high) {
    const std::int32_t cell = position >> sweep.fraction_bits & last;
    return (cell == 0 ? low : 0U) | (cell == last ? high : 0U);
  };
  for (std::uint32_t i = sweep.points.begin; i < sweep.points.end; ++i) {
    const std::uint32_t first = around == Around::kAllRows ? sweep.own.begin : i + 1;
    for (std::uint32_t j = first; j < sweep.own.end; ++j) {
      if (j != i) visit(i, j);
    }
    const unsigned at =
        sides(sweep.asked.y[i], kLowY, kHighY) | sides(sweep.asked.z[i], kLowZ, kHighZ);
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      const Target& target = sweep.targets[k];
      if ((at & target.sides) != target.sides) continue;
      for (std::uint32_t j = target.points.begin; j < target.points.end; ++j) visit(i, j);
    }
  }
}

// The sides that a target is beyond, by where its points are.
void expect_true_sides(const Sweep& sweep) {
  const unsigned bits = sweep.fraction_bits + sweep.row_shift;
  const std::uint32_t own = sweep.points.begin;
  for (unsigned k = 0; k < sweep.target_count; ++k) {
    const std::uint32_t there = sweep.targets[k].points.begin;
    const int in_y = (sweep.others.y[there] >> bits) - (sweep.asked.y[own] >> bits);
    const int in_z = (sweep.others.z[there] >> bits) - (sweep.asked.z[own] >> bits);
    const unsigned sides = (in_y < 0 ? kLowY : 0U) | (in_y > 0 ? kHighY : 0U) |
                           (in_z < 0 ? kLowZ : 0U) | (in_z > 0 ? kHighZ : 0U);
    EXPECT_EQ(sweep.targets[k].sides, sides);
  }
}

class Sweeps : public testing::TestWithParam<unsigned> {
 protected:
  // All pairs that all workers together compare.
  IdPairs asked_for(const Swarm& asked, const Swarm& others, Around around) {
    const SweepQuery question{asked, others, closer_, {1.0F, 1.0F}, kernels_, false};
    IdPairs found;
    for (unsigned worker = 0; worker < own_.crew.size(); ++worker) {
      const auto share = own_.crew.share(asked.grid.size, worker);
      const auto begin = static_cast<std::uint32_t>(share.first);
      const auto end = static_cast<std::uint32_t>(share.second);
      RowSweeps sweeps(question, {nullptr, nullptr}, around);
      const Range reach = sweeps.reach(begin, end);
      EXPECT_LE(reach.end, others.grid.size);
      std::uint32_t next = begin;
      sweeps.for_each(begin, end, [&](const Sweep& sweep) {
        EXPECT_GE(sweep.points.begin, next);
        EXPECT_LE(sweep.points.end, end);
        EXPECT_LE(sweep.target_count, 9U);
        next = sweep.points.end;
        expect_true_sides(sweep);
        for_each_asked(sweep, around, [&](std::uint32_t i, std::uint32_t j) {
          EXPECT_TRUE(reach.begin <= j && j < reach.end) << j;
          ++found[{asked.grid.id[i], others.grid.id[j]}];
        });
        return true;
      });
    }
    return found;
  }

  template <class Check>
  void for_each_scene(Check&& check) {
    for (const test::SearchScene& scene : scenes()) {
      for (const unsigned row_shift : {0U, 1U, 3U}) {
        SCOPED_TRACE(scene.name + ", row shift " + std::to_string(row_shift));
        check(scene, row_shift);
        if (HasFatalFailure()) return;
      }
    }
  }

  test::OwnResources own_{GetParam()};
  core::ProximityTest closer_{1.0, false};
  const Kernels& kernels_ = kernels(InstructionSet::kBaseline);

 private:
  // From one full box to a handful of points in rows and layers far apart.
  static std::vector<test::SearchScene> scenes() {
    test::SceneMaker make(5);
    std::vector<test::SearchScene> all;
    for (const double side : {2.0, 5.0, 9.0, 14.0, 40.0}) {
      all.push_back(
          {"Box of " + std::to_string(side), make.box(130, {0, 0, 0}, {3, side, side}), 1.0});
      all.push_back({"Flat box of " + std::to_string(side),
                     make.box(130, {0, 0, 0}, {9, 0.3 * side, side}), 1.0});
    }
    std::vector<Point> layers = make.box(140, {0, 0, 0}, {4, 9, 9});
    for (Point& p : layers) {
      if (make.below(3) == 0) p.z += 30.0;
      if (make.below(3) == 0) p.y += 20.0;
    }
    all.push_back({"Layers far apart", layers, 1.0});
    all.push_back({"Empty", {}, 1.0});
    return all;
  }
};

TEST_P(Sweeps, OfASwarmByItselfAskForEveryPairOnce) {
  std::size_t close = 0;
  for_each_scene([&](const test::SearchScene& scene, unsigned row_shift) {
    const PointsView points(scene.points);
    const core::Lattice lattice({&points, 1}, *core::measure(points, own_.with), 1.0, own_.memory);
    const core::SortedGrid grid = core::sort_into_grid({points}, lattice, row_shift, own_.with);
    const Swarm swarm{grid, points};
    const IdPairs found = asked_for(swarm, swarm, Around::kLaterRows);
    for (const auto& [pair, times] : found) {
      ASSERT_NE(pair.first, pair.second);
      ASSERT_EQ(times, 1);
      ASSERT_EQ(found.count({pair.second, pair.first}), 0U) << "met from both sides";
    }
    for (PointId i = 0; i < points.size(); ++i) {
      for (PointId j = i + 1; j < points.size(); ++j) {
        if (!closer_(points[i], points[j])) continue;
        ASSERT_EQ(found.count({i, j}) + found.count({j, i}), 1U) << i << " " << j;
        ++close;
      }
    }
  });
  EXPECT_GT(close, 1000U);
}

TEST_P(Sweeps, IntoAllRowsAskForEveryPairFromBothSides) {
  for_each_scene([&](const test::SearchScene& scene, unsigned row_shift) {
    const PointsView points(scene.points);
    const core::Lattice lattice({&points, 1}, *core::measure(points, own_.with), 1.0, own_.memory);
    const core::SortedGrid grid = core::sort_into_grid({points}, lattice, row_shift, own_.with);
    const Swarm swarm{grid, points};
    const IdPairs found = asked_for(swarm, swarm, Around::kAllRows);
    for (const auto& [pair, times] : found) ASSERT_EQ(times, 1);
    for (PointId i = 0; i < points.size(); ++i) {
      for (PointId j = 0; j < points.size(); ++j) {
        if (i == j || !closer_(points[i], points[j])) continue;
        ASSERT_EQ(found.count({i, j}), 1U) << i << " " << j;
      }
    }
  });
}

TEST_P(Sweeps, BetweenTwoSwarmsAskForEveryPairOnce) {
  std::size_t close = 0;
  for_each_scene([&](const test::SearchScene& scene, unsigned row_shift) {
    std::vector<Point> others = scene.points;
    for (Point& p : others) std::swap(p.y, p.z);
    const std::size_t kept = others.size() / 3;
    others.resize(others.size() - kept);
    const PointsView sets[] = {scene.points, others};
    core::Bounds bounds = *core::measure(sets[0], own_.with);
    const core::Bounds second = *core::measure(sets[1], own_.with);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.low[axis] = std::min(bounds.low[axis], second.low[axis]);
      bounds.high[axis] = std::max(bounds.high[axis], second.high[axis]);
    }
    const core::Lattice lattice(sets, bounds, 1.0, own_.memory);
    const core::SortedGrid asked = core::sort_into_grid({sets[0]}, lattice, row_shift, own_.with);
    const core::SortedGrid around = core::sort_into_grid({sets[1]}, lattice, row_shift, own_.with);
    const IdPairs found = asked_for({asked, sets[0]}, {around, sets[1]}, Around::kAllRows);
    for (const auto& [pair, times] : found) ASSERT_EQ(times, 1);
    for (PointId i = 0; i < sets[0].size(); ++i) {
      for (PointId j = 0; j < sets[1].size(); ++j) {
        if (!closer_(sets[0][i], sets[1][j])) continue;
        ASSERT_EQ(found.count({i, j}), 1U) << i << " " << j;
        ++close;
      }
    }
  });
  EXPECT_GT(close, 1000U);
}

TEST_P(Sweeps, EndWhenTheirVisitorReturnsFalse) {
  const std::vector<Point> points = test::SceneMaker(1).box(300, {0, 0, 0}, {5, 5, 5});
  const PointsView view(points);
  const core::Lattice lattice({&view, 1}, *core::measure(view, own_.with), 1.0, own_.memory);
  const core::SortedGrid grid = core::sort_into_grid({view}, lattice, 0, own_.with);
  const SweepQuery question{
      {grid, view}, {grid, view}, closer_, {1.0F, 1.0F}, kernels(InstructionSet::kBaseline), true};
  int calls = 0;
  RowSweeps(question, {nullptr, nullptr}).for_each(0, 300, [&](const Sweep&) {
    return ++calls < 3;
  });
  EXPECT_EQ(calls, 3);
}

INSTANTIATE_TEST_SUITE_P(Workers, Sweeps, testing::Values(1U, 2U, 7U));

}  // namespace
}  // namespace beespace::cpu
