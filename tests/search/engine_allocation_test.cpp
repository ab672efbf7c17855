// Once an Engine has seen two frames as large as those that follow, a call allocates nothing.
// Counted in all of this program: every operator new, on every thread.
#include "tests/support/allocation_count.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/engine.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr std::size_t kSize = 16'400;  // enough that two threads share the work

struct Frames {
  const char* name;
  std::vector<Point> points;
  std::vector<Point> others;
  double threshold_m;
  std::vector<Point> velocities = {};

  // The next frame: all points have moved a little.
  void move(test::SceneMaker& make) {
    for (std::vector<Point>* set : {&points, &others}) {
      for (Point& p : *set) {
        p.x += 0.05 * threshold_m * make.between(-1.0, 1.0);
        p.y += 0.05 * threshold_m * make.between(-1.0, 1.0);
        p.z += 0.05 * threshold_m * make.between(-1.0, 1.0);
      }
    }
  }
};

std::vector<Frames> swarms() {
  test::SceneMaker make(12);
  const auto boxes = [&](const char* name, const Point& high, double threshold) {
    return Frames{name, make.box(kSize, {0, 0, 0}, high), make.box(kSize, {0, 0, 0}, high),
                  threshold};
  };
  std::vector<Frames> all = {
      boxes("two neighbours", {3475, 3475, 3475}, 100.0), boxes("sparse", {1e5, 1e5, 1e4}, 100.0),
      boxes("plane", {8000, 8000, 0}, 50.0), boxes("dense", {900, 600, 130}, 20.0),
      boxes("wide: folded", {1e9, 1e3, 1e3}, 10.0)};
  Frames crowds{"crowds and lonely ones", {}, {}, 20.0};
  for (std::vector<Point>* set : {&crowds.points, &crowds.others}) {
    *set = make.box(kSize, {0, 0, 0}, {3e4, 3e4, 3e4});
    for (std::size_t i = 0; i < kSize / 2; ++i) {
      const auto crowd = static_cast<double>(i % 40);
      (*set)[i] = {crowd * 700.0 + make.between(0, 30), make.between(0, 30), make.between(0, 30)};
    }
  }
  all.push_back(crowds);
  for (Frames& frames : all) {
    const double fast = frames.threshold_m;
    frames.velocities = make.box(kSize, {-fast, -fast, -fast}, {fast, fast, fast});
  }
  return all;
}

// The caller's containers, with more room than any answer takes.
struct Answers {
  Answers() {
    constexpr std::size_t kMany = 4'000'000;
    ids.reserve(kMany);
    pairs.reserve(kMany);
    rows.offsets.reserve(kMany);
    rows.ids.reserve(2 * kMany);
    nearest.reserve(kMany);
    conflicts.reserve(kMany);
  }

  std::vector<std::uint32_t> ids;
  std::vector<Pair> pairs;
  IdRows rows;
  std::vector<Nearest> nearest;
  std::vector<Conflict> conflicts;
};

struct Method {
  std::string name;
  std::function<bool(Engine&, const Frames&, const SearchOptions&, Answers&)> call;
};

MoversView movers_of(const Frames& frame) {
  return {frame.points, frame.velocities};
}

PredictOptions over_a_short_time(const SearchOptions& options) {
  return {.threshold_m = options.threshold_m, .horizon_s = 0.2, .threads = options.threads};
}

std::vector<Method> methods() {
  using F = const Frames&;
  using O = const SearchOptions&;
  using A = Answers&;
  const PairVisitor all = [](std::span<const Pair>) { return true; };
  return {
      {"FindAtRisk",
       [](Engine& e, F f, O o, A a) { return bool(e.find_at_risk(f.points, o, a.ids)); }},
      {"FindAtRiskBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_at_risk_between(f.points, f.others, o, a.ids));
       }},
      {"FindPairs",
       [](Engine& e, F f, O o, A a) { return bool(e.find_pairs(f.points, o, a.pairs)); }},
      {"FindPairsBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_pairs_between(f.points, f.others, o, a.pairs));
       }},
      {"VisitPairs",
       [all](Engine& e, F f, O o, A) { return bool(e.visit_pairs(f.points, o, all)); }},
      {"FindNeighbors",
       [](Engine& e, F f, O o, A a) { return bool(e.find_neighbors(f.points, o, a.rows)); }},
      {"FindNeighborsBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_neighbors_between(f.points, f.others, o, a.rows));
       }},
      {"CountNeighbors",
       [](Engine& e, F f, O o, A a) { return bool(e.count_neighbors(f.points, o, a.ids)); }},
      {"CountNeighborsBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.count_neighbors_between(f.points, f.others, o, a.ids));
       }},
      {"FindConflictGroups",
       [](Engine& e, F f, O o, A a) { return bool(e.find_conflict_groups(f.points, o, a.rows)); }},
      {"FindNearest", [](Engine& e, F f, O o,
                         A a) { return bool(e.find_nearest(f.points, a.nearest, o.threads)); }},
      {"FindNearestWithin",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_nearest_within(f.points, o, a.nearest));
       }},
      {"FindNearestBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_nearest_between(f.points, f.others, a.nearest, o.threads));
       }},
      {"FindNearestWithinBetween",
       [](Engine& e, F f, O o, A a) {
         return bool(e.find_nearest_within_between(f.points, f.others, o, a.nearest));
       }},
      {"FindClosestPair",
       [](Engine& e, F f, O o, A) { return bool(e.find_closest_pair(f.points, o.threads)); }},
      {"FindClosestPairBetween",
       [](Engine& e, F f, O o, A) {
         return bool(e.find_closest_pair_between(f.points, f.others, o.threads));
       }},
      {"PredictPairs",
       [](Engine& e, F f, O o, A a) {
         return bool(e.predict_pairs(movers_of(f), over_a_short_time(o), a.pairs));
       }},
      {"PredictConflicts",
       [](Engine& e, F f, O o, A a) {
         return bool(e.predict_conflicts(movers_of(f), over_a_short_time(o), a.conflicts));
       }},
  };
}

class EngineAllocates : public testing::TestWithParam<Method> {
 protected:
  // The memory that a call on this frame takes from the system.
  static std::uint64_t taken(Engine& engine, const Frames& frame, unsigned threads) {
    static Answers answers;
    const SearchOptions options{frame.threshold_m, false, threads};
    const std::uint64_t before = test::allocations();
    EXPECT_TRUE(GetParam().call(engine, frame, options, answers));
    return test::allocations() - before;
  }
};

TEST_P(EngineAllocates, NothingForTheSameFrameAgain) {
  for (const Frames& frame : swarms()) {
    for (const unsigned threads : {1U, 2U}) {
      Engine engine;
      EXPECT_GT(taken(engine, frame, threads), 0U) << "nothing is counted";
      (void)taken(engine, frame, threads);
      for (int again = 0; again < 2; ++again) {
        EXPECT_EQ(taken(engine, frame, threads), 0U) << frame.name << ", threads: " << threads;
      }
    }
  }
}

// Frames of sizes that it has seen before, in any order.
TEST_P(EngineAllocates, NothingForFramesThatItHasSeen) {
  for (Frames& frame : swarms()) {
    for (const unsigned threads : {1U, 2U}) {
      test::SceneMaker make(threads);
      std::vector<Frames> frames;
      Engine engine;
      for (int early = 0; early < 2; ++early) {
        frame.move(make);
        (void)taken(engine, frames.emplace_back(frame), threads);
      }
      (void)taken(engine, frames.front(), threads);
      std::uint64_t later = 0;
      for (const std::size_t again : {1U, 0U, 1U}) {
        later += taken(engine, frames[again], threads);
      }
      EXPECT_EQ(later, 0U) << frame.name << ", threads: " << threads;
    }
  }
}

// All points move, and now and then a frame takes a little more than all before it.
TEST_P(EngineAllocates, LittleForNewFramesThatAreMuchTheSame) {
  for (Frames& frame : swarms()) {
    for (const unsigned threads : {1U, 2U}) {
      test::SceneMaker make(threads);
      Engine engine;
      const std::uint64_t first = taken(engine, frame, threads);
      std::uint64_t later = 0;
      for (int late = 0; late < 4; ++late) {
        frame.move(make);
        later += taken(engine, frame, threads);
      }
      EXPECT_LE(later, first) << frame.name << ", threads: " << threads << ", in four frames";
    }
  }
}

// One Engine for all questions in turn has seen frames of this size as well.
TEST(EngineMemory, ServesAllQuestionsInTurn) {
  Answers answers;
  const Frames frame = swarms().front();
  const SearchOptions options{frame.threshold_m};
  Engine engine;
  const std::vector<Method> all = methods();
  const auto ask_all = [&] {
    for (const Method& method : all) method.call(engine, frame, options, answers);
  };
  ask_all();
  ask_all();
  const std::uint64_t before = test::allocations();
  for (int again = 0; again < 3; ++again) ask_all();
  EXPECT_EQ(test::allocations() - before, 0U);
}

TEST(EngineMemory, IsGivenBackOnRequest) {
  Answers answers;
  const Frames frame = swarms().front();
  const std::uint64_t held = test::blocks_held();
  Engine engine;
  ASSERT_TRUE(engine.find_pairs(frame.points, {frame.threshold_m}, answers.pairs));
  const std::uint64_t working = test::blocks_held();
  engine.release_memory();
  EXPECT_GT(working, test::blocks_held() + 5);
  EXPECT_LE(test::blocks_held(), held + 4) << "the engine itself";
}

void PrintTo(const Method& method, std::ostream* out) {  // NOLINT: GoogleTest's name
  *out << method.name;
}

INSTANTIATE_TEST_SUITE_P(Calls, EngineAllocates, testing::ValuesIn(methods()),
                         [](const auto& test_case) { return test_case.param.name; });

}  // namespace
}  // namespace beespace
