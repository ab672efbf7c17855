// Every kernel of this processor, row by row, against plain double arithmetic on the same
// positions.
#include "kernels/sweep.hpp"

#include "tests/kernels/kernel_scenes.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace beespace::cpu {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

class EveryKernel : public KernelScenes {};

TEST_P(EveryKernel, MarksBothOfEveryNearPair) {
  std::size_t near = 0;
  std::size_t unsure = 0;
  for_each_scene(true, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const Found expected = expected_of(scene, limits);
    const std::uint32_t first = scene.points.begin;
    std::vector<std::uint8_t> marks(scene.others().size() - first, 0);
    Open open;
    kernels().mark(scene.sweep(limits, open.unsure()), {marks.data(), marks.data(), first, first});
    std::vector<std::uint8_t> truly(marks.size(), 0);
    for (const auto& [i, j] : expected.all_near()) truly[i - first] = truly[j - first] = 1;
    for (std::size_t i = 0; i < marks.size(); ++i) ASSERT_EQ(marks[i] != 0, truly[i] != 0) << i;
    ASSERT_EQ(open.sorted(), expected.unsure);
    near += expected.near.size();
    unsure += expected.unsure.size();
  });
  EXPECT_GT(near, 10'000U);
  EXPECT_GT(unsure, 10'000U);
}

TEST_P(EveryKernel, MarksTheQueriesAndSkipsThemOnceMarked) {
  for_each_scene(false, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const Found expected = expected_of(scene, limits);
    const auto [first, end] = scene.points;
    std::vector<std::uint8_t> marks(end - first, 0);
    std::vector<std::uint8_t> truly(end - first, 0);
    for (const auto& [i, j] : expected.all_near()) truly[i - first] = 1;
    for (std::size_t i = 0; i < marks.size(); i += 5) marks[i] = truly[i] = 1;  // marked before
    Open open;
    kernels().mark_asked(scene.sweep(limits, open.unsure()), {marks.data(), nullptr, first, 0});
    ASSERT_EQ(marks, truly);
    PlacePairs of_unmarked;
    for (const auto& pair : expected.unsure) {
      if (truly[pair.first - first] == 0) of_unmarked.push_back(pair);
    }
    const PlacePairs& reported = open.sorted();
    ASSERT_TRUE(
        std::includes(reported.begin(), reported.end(), of_unmarked.begin(), of_unmarked.end()));
    ASSERT_TRUE(std::includes(expected.unsure.begin(), expected.unsure.end(), reported.begin(),
                              reported.end()));
    for (const auto& [i, j] : reported) ASSERT_NE((i - first) % 5, 0U) << "was marked before";
  });
}

TEST_P(EveryKernel, CountsForBothAndInItsRowForTheQueries) {
  for_each_scene(true, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const Found expected = expected_of(scene, limits, true);
    const std::uint32_t first = scene.points.begin;
    std::vector<std::uint32_t> counts(scene.others().size() - first, 5);
    std::vector<std::uint32_t> truly = counts;
    Open open;
    kernels().count(scene.sweep(limits, open.unsure()),
                    {counts.data(), counts.data(), first, first});
    for (const auto& [i, j] : expected.all_near()) {
      ++truly[i - first];
      if (j >= scene.own.end) ++truly[j - first];
    }
    ASSERT_EQ(counts, truly);
    ASSERT_EQ(open.sorted(), expected.unsure);
  });
}

TEST_P(EveryKernel, CountsForTheQueries) {
  for_each_scene(false, [&](const SweepScene& scene) {
    const Limits limits = limits_of(scene.shape);
    const Found expected = expected_of(scene, limits);
    const auto [first, end] = scene.points;
    std::vector<std::uint32_t> counts(end - first, 5);
    std::vector<std::uint32_t> truly = counts;
    Open open;
    kernels().count_asked(scene.sweep(limits, open.unsure()), {counts.data(), nullptr, first, 0});
    for (const auto& [i, j] : expected.all_near()) ++truly[i - first];
    ASSERT_EQ(counts, truly);
    ASSERT_EQ(open.sorted(), expected.unsure);
  });
}

// A buffer of pairs that is emptied when it is full, so many times and no more.
class Collected {
 public:
  Collected(std::uint32_t capacity, std::size_t rounds)
      : first_(capacity + kBeyond, kUntouched),
        second_(capacity + kBeyond, kUntouched),
        rounds_left_(rounds) {
    const auto make_room = [](void* self) { return static_cast<Collected*>(self)->empty(); };
    sink = {first_.data(), second_.data(), 0, capacity, make_room, this};
  }
  Collected(const Collected&) = delete;
  Collected& operator=(const Collected&) = delete;

  // All pairs so far, in order.
  PlacePairs take_all() {
    take();
    std::sort(ids_.begin(), ids_.end());
    return ids_;
  }
  [[nodiscard]] bool kept_inside() const {
    const auto untouched_beyond = [this](const std::vector<PointId>& ids) {
      return std::count(ids.begin() + sink.capacity, ids.end(), kUntouched) == kBeyond;
    };
    return untouched_beyond(first_) && untouched_beyond(second_);
  }

  PairSink sink{};
  std::size_t calls = 0;

 private:
  static constexpr PointId kUntouched = 0xABCD'EF01U;
  static constexpr std::ptrdiff_t kBeyond = 1000;

  void take() {
    for (std::uint32_t k = 0; k < sink.size; ++k) ids_.emplace_back(first_[k], second_[k]);
    sink.size = 0;
  }
  bool empty() {
    ++calls;
    EXPECT_LE(sink.size, sink.capacity);
    EXPECT_LT(sink.capacity - sink.size, PairSink::kMostAtOnce) << "there was room";
    take();
    return --rounds_left_ > 0;
  }

  std::vector<PointId> first_;
  std::vector<PointId> second_;
  std::size_t rounds_left_;
  PlacePairs ids_;
};

PlacePairs by_ids(const SweepScene& scene, PlacePairs pairs) {
  for (auto& [i, j] : pairs) {
    i = scene.asked().id[i];
    j = scene.others().id[j];
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST_P(EveryKernel, CollectsEveryNearPairOnceInBuffersOfAnySize) {
  for (const bool by_itself : {true, false}) {
    for_each_scene(by_itself, [&](const SweepScene& scene) {
      const Limits limits = limits_of(scene.shape);
      const Found expected = expected_of(scene, limits);
      for (const std::uint32_t capacity : {16U, 17U, 40U, 100'000U}) {
        Collected collected(capacity, std::numeric_limits<std::size_t>::max());
        Open open;
        ASSERT_TRUE(collect(by_itself)(scene.sweep(limits, open.unsure()), collected.sink));
        ASSERT_TRUE(collected.kept_inside());
        ASSERT_EQ(collected.take_all(), by_ids(scene, expected.all_near()));
        ASSERT_EQ(open.sorted(), expected.unsure);
      }
    });
  }
}

TEST_P(EveryKernel, StopsCollectingWhenThereIsNoMoreRoom) {
  std::size_t stopped = 0;
  for (const bool by_itself : {true, false}) {
    for_each_scene(by_itself, [&](const SweepScene& scene) {
      const Limits limits = limits_of(scene.shape);
      const PlacePairs all = by_ids(scene, expected_of(scene, limits).all_near());
      for (const std::size_t rounds : {1U, 3U}) {
        Collected collected(20, rounds);
        Open open;
        const bool went_on = collect(by_itself)(scene.sweep(limits, open.unsure()), collected.sink);
        ASSERT_EQ(went_on, collected.calls < rounds);
        ASSERT_LE(collected.calls, rounds);
        ASSERT_TRUE(collected.kept_inside());
        const PlacePairs some = collected.take_all();
        ASSERT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end()));
        stopped += went_on ? 0U : 1U;
      }
    });
  }
  EXPECT_GT(stopped, 100U);
}

// Balls around the points of a scene, whose radii are up to what is promised: two together are no
// larger than the reach.
class Balls {
 public:
  Balls(const SweepScene& scene, std::uint32_t seed)
      : radius_(scene.asked().size(), static_cast<float>(reach_of(scene))) {
    test::SceneMaker make(seed);
    const double reach = reach_of(scene);
    // All up to half of the reach, or one of nearly all of it, or one of all of it among points.
    constexpr double kShares[] = {0.5, 0.125, 0.0};
    const double share = kShares[make.below(3)];
    const std::size_t points = scene.size();
    const std::size_t giant = make.below(points);
    for (std::size_t i = 0; i < points; ++i) {
      const double largest = i == giant ? (1.0 - share) * reach : share * reach;
      const std::size_t kind = make.below(4);
      const double radius = kind == 0 ? 0.0 : kind == 1 ? largest : make.between(0.0, largest);
      radius_[i] =
          static_cast<float>(scene.shape.fraction_bits > 1 ? radius : std::floor(radius * 8) / 8);
    }
    // Eighths of few units are exact in a float, and so are their squares.
    band_ = scene.shape.fraction_bits > 1 ? 0x1p-20 : 0.0;
  }

  [[nodiscard]] const float* data() const { return radius_.data(); }

  // The pairs that meet: `near` surely, `unsure` within a few roundings of the limit.
  [[nodiscard]] Found meeting(const SweepScene& scene) const {
    Found found;
    scene.for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
      const double both = double{radius_[i]} + double{radius_[j]};
      if (squared <= both * both * (1.0 - band_)) {
        found.near.emplace_back(i, j);
      } else if (squared <= both * both * (1.0 + band_)) {
        found.unsure.emplace_back(i, j);
      }
    });
    std::sort(found.near.begin(), found.near.end());
    std::sort(found.unsure.begin(), found.unsure.end());
    return found;
  }

 private:
  static double reach_of(const SweepScene& scene) { return std::sqrt(scene.shape.squared_reach()); }

  std::vector<float> radius_;  // behind the last point: as large as can be
  double band_;
};

// By their places, whatever the verdict on distances.
TEST_P(EveryKernel, CollectsEveryPairOfBallsThatMeetOnceInBuffersOfAnySize) {
  std::size_t near = 0;
  std::size_t unsure = 0;
  std::size_t apart = 0;
  std::uint32_t seed = 0;
  for_each_scene(true, [&](const SweepScene& scene) {
    const Balls balls(scene, ++seed);
    const Found expected = balls.meeting(scene);
    for (const std::uint32_t capacity : {16U, 17U, 40U, 100'000U}) {
      Collected collected(capacity, std::numeric_limits<std::size_t>::max());
      Open open;
      ASSERT_TRUE(kernels().collect_meeting(scene.sweep(limits_of(scene.shape), open.unsure()),
                                            {balls.data(), collected.sink}));
      ASSERT_TRUE(collected.kept_inside());
      const PlacePairs found = collected.take_all();
      ASSERT_EQ(std::adjacent_find(found.begin(), found.end()), found.end()) << "one twice";
      PlacePairs beyond;
      std::set_difference(found.begin(), found.end(), expected.near.begin(), expected.near.end(),
                          std::back_inserter(beyond));
      ASSERT_EQ(found.size() - beyond.size(), expected.near.size()) << "one is missing";
      ASSERT_TRUE(std::includes(expected.unsure.begin(), expected.unsure.end(), beyond.begin(),
                                beyond.end()))
          << "one too many";
    }
    near += expected.near.size();
    unsure += expected.unsure.size();
    scene.for_each_pair([&](std::uint32_t, std::uint32_t, double) { ++apart; });
  });
  EXPECT_GT(near, 10'000U);
  EXPECT_LT(unsure, near / 20);
  EXPECT_GT(apart, 10 * near);
}

TEST_P(EveryKernel, StopsCollectingBallsThatMeetWhenThereIsNoMoreRoom) {
  std::size_t stopped = 0;
  std::uint32_t seed = 0;
  for_each_scene(true, [&](const SweepScene& scene) {
    const Balls balls(scene, ++seed);
    Open open;
    const Sweep sweep = scene.sweep(limits_of(scene.shape), open.unsure());
    Collected all(100'000, std::numeric_limits<std::size_t>::max());
    ASSERT_TRUE(kernels().collect_meeting(sweep, {balls.data(), all.sink}));
    const PlacePairs all_pairs = all.take_all();
    for (const std::size_t rounds : {1U, 3U}) {
      Collected collected(20, rounds);
      const bool went_on = kernels().collect_meeting(sweep, {balls.data(), collected.sink});
      ASSERT_EQ(went_on, collected.calls < rounds);
      ASSERT_LE(collected.calls, rounds);
      ASSERT_TRUE(collected.kept_inside());
      const PlacePairs some = collected.take_all();
      ASSERT_TRUE(std::includes(all_pairs.begin(), all_pairs.end(), some.begin(), some.end()));
      ASSERT_TRUE(!went_on || some == all_pairs);
      stopped += went_on ? 0U : 1U;
    }
  });
  EXPECT_GT(stopped, 100U);
}

// The nearest two of each point, and which distances are known: all within the reach, and some
// beyond.
struct NearestTwo {
  double best = std::numeric_limits<double>::infinity();
  double second = std::numeric_limits<double>::infinity();

  void add(double squared) {
    if (squared < best) std::swap(squared, best);
    second = std::min(second, squared);
  }
};

struct Table {
  explicit Table(std::size_t size) : best(size, kInfinity), second(size, kInfinity), who(size, 0) {}

  void expect(std::size_t place, const NearestTwo& truly, double reach, double to_who) const {
    const auto rounded = [](double squared) { return static_cast<float>(squared); };
    if (truly.best <= reach) {
      ASSERT_FLOAT_EQ(best[place], rounded(truly.best)) << place;
    } else {
      ASSERT_GT(best[place], rounded(reach)) << place;
    }
    if (truly.second <= reach) {
      ASSERT_FLOAT_EQ(second[place], rounded(truly.second)) << place;
    } else {
      ASSERT_GT(second[place], rounded(reach)) << place;
    }
    if (best[place] < kInfinity) {
      ASSERT_FLOAT_EQ(best[place], rounded(to_who)) << place;
    }
  }

  std::vector<float> best;
  std::vector<float> second;
  std::vector<std::uint32_t> who;
};

TEST_P(EveryKernel, FindsTheNearestTwo) {
  enum class Case { kByItself, kOfTheSameSet, kBetweenTwo };
  for (const Case asking : {Case::kByItself, Case::kOfTheSameSet, Case::kBetweenTwo}) {
    const bool by_itself = asking == Case::kByItself;
    const bool same_set = asking != Case::kBetweenTwo;
    const auto kernel = by_itself ? kernels().nearest : kernels().nearest_asked;
    for_each_scene(by_itself, by_itself, [&](SweepScene& scene) {
      scene.same_set = same_set;
      const std::uint32_t first = scene.points.begin;
      const std::uint32_t end = scene.points.end;
      Table table(end - first);
      const NearestTable into{table.best.data(), table.second.data(), table.who.data(), first};
      kernel(scene.sweep({kInfinity, kInfinity}, {nullptr, nullptr}), into);
      std::vector<NearestTwo> truly(end - first);
      scene.for_each_pair_of_asked([&](std::uint32_t i, std::uint32_t j, double squared) {
        if (same_set && scene.asked().id[i] == scene.others().id[j]) return;
        truly[i - first].add(squared);
      });
      const double reach = scene.shape.squared_reach();
      for (std::uint32_t i = first; i < end; ++i) {
        const std::uint32_t who = table.who[i - first];
        table.expect(i - first, truly[i - first], reach, scene.squared(i, who));
        if (same_set && table.best[i - first] < kInfinity) {
          ASSERT_NE(scene.others().id[who], scene.asked().id[i]);
        }
      }
    });
  }
}

// Rounding may bring two points that are within the reach a unit farther apart than a cell: one
// with others to both sides, at the very edge of the row, for every place in a slice. Some ask
// twice: the first time must not move the window too far for the second.
TEST_P(EveryKernel, SeesAUnitBeyondACellAlongX) {
  for (const bool by_itself : {true, false}) {
    const SweepShape shape{by_itself, false, 6, 1, 12, 0};
    const std::int32_t cell = shape.cell();
    const std::int32_t edge = 2 * shape.row_width() - 1;
    for (std::int32_t x = 5 * cell; x < 6 * cell; ++x) {
      std::vector<test::Spot> own;
      std::vector<test::Spot> beyond;
      for (const std::int32_t apart :
           {-cell - 2, -cell - 1, -cell, -1, 0, 0, cell, cell + 1, cell + 2}) {
        own.push_back({x + apart, edge, edge});
        beyond.push_back({x + apart, edge + 1, edge});
        for (int k = 0; k < 9; ++k) beyond.push_back({x + apart + 4 * cell, edge + 1, edge});
      }
      SweepScene scene(shape);
      scene.ask(own);
      scene.add_target(2, 1, beyond, 1000);
      scene.pad();
      const auto squared = [](std::int32_t along, std::int32_t across) {
        return static_cast<float>(along * along + across * across);
      };
      const Limits limits{squared(cell, 1) + 0.5F, squared(cell + 1, 1)};
      const Found expected = expected_of(scene, limits);
      Collected collected(64, std::numeric_limits<std::size_t>::max());
      Open open;
      ASSERT_TRUE(collect(by_itself)(scene.sweep(limits, open.unsure()), collected.sink));
      ASSERT_EQ(collected.take_all(), by_ids(scene, expected.all_near())) << x;
      ASSERT_EQ(open.sorted(), expected.unsure) << x;
      ASSERT_FALSE(expected.near.empty() || expected.unsure.empty());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, EveryKernel, testing::ValuesIn(available()),
                         [](const auto& test_case) { return name_of(test_case.param); });

}  // namespace
}  // namespace beespace::cpu
