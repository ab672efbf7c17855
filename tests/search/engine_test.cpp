// An Engine and its crew: earlier and concurrent calls do not change the answers, which are those
// of the functions of the same name.
#include <beespace/engine.hpp>

#include "tests/support/scene_maker.hpp"

#include <beespace/at_risk.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/neighbors.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace beespace {
namespace {

struct Swarm {
  std::vector<Point> points;
  std::vector<Point> others;
  SearchOptions options{.threshold_m = 100.0};
};

Swarm swarm_of(std::size_t size, double threshold, std::uint32_t seed = 1) {
  test::SceneMaker make(seed);
  const Point high{1000, 700, 300};
  return {make.box(size, {0, 0, 0}, high), make.box(size / 2, {0, 0, 0}, high), {threshold}};
}

// An Engine with reused containers, compared with a new Engine for each query.
class Asking {
 public:
  Asking() = default;
  explicit Asking(Crew& crew) : engine_(crew) {}

  // The questions whose answers are wrong.
  std::string wrong_answers(const Swarm& swarm) {
    const auto& [points, others, options] = swarm;
    std::string wrong;
    const auto expect = [&](const char* question, const Status& status, bool right) {
      if (!status || !right) wrong += std::string(question) + " ";
    };
    Status status = engine_.find_at_risk(points, options, ids_);
    expect("at_risk", status, ids_ == *find_at_risk(points, options));
    status = engine_.find_pairs_between(points, others, options, pairs_);
    expect("pairs_between", status, pairs_ == *find_pairs_between(points, others, options));
    status = engine_.find_neighbors(points, options, rows_);
    expect("neighbors", status, rows_ == *find_neighbors(points, options));
    status = engine_.find_pairs(points, options, pairs_);
    expect("pairs", status, pairs_ == *find_pairs(points, options));
    status = engine_.find_conflict_groups(points, options, rows_);
    expect("groups", status, rows_ == *find_conflict_groups(points, options));
    status = engine_.count_neighbors_between(points, others, options, ids_);
    expect("counts_between", status, ids_ == *count_neighbors_between(points, others, options));
    status = engine_.find_nearest(points, nearest_, options.threads);
    expect("nearest", status, nearest_ == *find_nearest(points));
    const auto closest = engine_.find_closest_pair(points, options.threads);
    expect("closest_pair", std::monostate{}, closest && *closest == *find_closest_pair(points));
    return wrong;
  }

  Engine& engine() { return engine_; }

 private:
  Engine engine_;
  std::vector<std::uint32_t> ids_;
  std::vector<Pair> pairs_;
  IdRows rows_;
  std::vector<Nearest> nearest_;
};

TEST(Engine, AnswersAreRightForSwarmsOfAllSizesInTurn) {
  Asking asking;
  for (const unsigned threads : {1U, 2U, 0U}) {
    for (const std::size_t size : {30'000U, 10U, 0U, 1U, 20'000U, 17U, 3000U}) {
      Swarm swarm = swarm_of(size, 15.0);
      swarm.options.threads = threads;
      EXPECT_EQ(asking.wrong_answers(swarm), "") << size << " points, threads: " << threads;
    }
    asking.engine().release_memory();
  }
}

TEST(Engine, MovesWithAllItHas) {
  const Swarm swarm = swarm_of(2000, 30.0);
  std::vector<PointId> at_risk;
  Engine first;
  ASSERT_TRUE(first.find_at_risk(swarm.points, swarm.options, at_risk));
  Engine second(std::move(first));
  first = Engine();
  for (Engine* engine : {&first, &second}) {
    ASSERT_TRUE(engine->find_at_risk(swarm.points, swarm.options, at_risk));
    EXPECT_EQ(at_risk, *find_at_risk(swarm.points, swarm.options));
  }
}

// A pool that starts a thread for every part, as no pool should, and counts its calls.
class ThreadAPart final : public Crew {
 public:
  [[nodiscard]] unsigned size() const override { return 3; }
  void run(Task task) override {
    ++runs;
    std::vector<std::thread> threads;
    for (unsigned worker = 0; worker < size(); ++worker) {
      threads.emplace_back([task, worker] { task(worker); });
    }
    for (std::thread& thread : threads) thread.join();
  }

  std::size_t runs = 0;
};

TEST(Engine, WorksWithTheThreadsOfAnotherPool) {
  ThreadAPart pool;
  Asking asking(pool);
  for (const std::size_t size : {0U, 1U, 2U, 5000U}) {
    EXPECT_EQ(asking.wrong_answers(swarm_of(size, 20.0)), "") << size;
  }
  EXPECT_GT(pool.runs, 20U);
}

TEST(ThreadCrew, ServesManyEnginesAtOnce) {
  constexpr std::size_t kCallers = 8;
  ThreadCrew crew(3);
  std::vector<std::string> wrong(kCallers);
  std::vector<std::thread> callers;
  for (std::size_t caller = 0; caller < kCallers; ++caller) {
    callers.emplace_back([&, caller] {
      Asking asking(crew);
      for (std::uint32_t round = 0; round < 4; ++round) {
        const auto seed = static_cast<std::uint32_t>(caller) + 10 * round;
        wrong[caller] += asking.wrong_answers(swarm_of(500 + 300 * caller, 40.0, seed));
      }
    });
  }
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(wrong, std::vector<std::string>(kCallers));
}

// A search within a task of the crew that it is to work with.
TEST(ThreadCrew, ServesAnEngineWithinItsOwnTask) {
  ThreadCrew crew(3);
  std::vector<std::string> wrong(crew.size(), "not asked");
  crew.run([&](unsigned worker) {
    wrong[worker] = Asking(crew).wrong_answers(swarm_of(3000, 25.0, worker));
  });
  EXPECT_EQ(wrong, std::vector<std::string>(crew.size()));
}

TEST(MaxResults, AreAllowedAndOneMoreIsAnError) {
  const Swarm swarm = swarm_of(20'000, 12.0);
  const std::uint64_t pairs = find_pairs(swarm.points, swarm.options).value().size();
  const std::uint64_t between =
      find_pairs_between(swarm.points, swarm.others, swarm.options).value().size();
  ASSERT_GT(std::min(pairs, between), 1000U);
  const auto expect_limit = [](std::uint64_t results, const auto& ask) {
    for (const std::uint64_t allowed : {results, results + 1}) {
      EXPECT_TRUE(ask(allowed).has_value()) << allowed;
    }
    for (const std::uint64_t allowed : {results - 1, results / 2, std::uint64_t{0}}) {
      const auto refused = ask(allowed);
      ASSERT_FALSE(refused.has_value()) << allowed;
      EXPECT_EQ(refused.error().code, ErrorCode::kTooManyResults);
      EXPECT_NE(refused.error().message.find(std::to_string(allowed)), std::string::npos);
    }
  };
  for (const unsigned threads : {1U, 2U}) {
    const auto with = [&](std::uint64_t most) {
      return PairOptions{swarm.options.threshold_m, false, threads, most};
    };
    expect_limit(pairs, [&](auto most) { return find_pairs(swarm.points, with(most)); });
    expect_limit(2 * pairs, [&](auto most) { return find_neighbors(swarm.points, with(most)); });
    expect_limit(between, [&](auto most) {
      return find_pairs_between(swarm.points, swarm.others, with(most));
    });
    expect_limit(between, [&](auto most) {
      return find_neighbors_between(swarm.points, swarm.others, with(most));
    });
  }
}

TEST(MaxResults, OfNothingIsEnoughForNothing) {
  const std::vector<Point> lonely = {{0, 0, 0}, {9, 9, 9}};
  EXPECT_TRUE(find_pairs(lonely, {1.0, false, 1, 0}).has_value());
  EXPECT_TRUE(find_neighbors(lonely, {1.0, false, 1, 0}).has_value());
  EXPECT_EQ(find_neighbors(lonely, {100.0, false, 1, 1}).error().code, ErrorCode::kTooManyResults);
}

// A refusal must not be remembered.
TEST(Engine, AnswersAfterARefusal) {
  Asking asking;
  const Swarm swarm = swarm_of(2000, 40.0);
  std::vector<Pair> pairs;
  ASSERT_FALSE(asking.engine().find_pairs(swarm.points, {40.0, false, 1, 3}, pairs));
  ASSERT_FALSE(asking.engine().find_pairs(swarm.points, {-1.0}, pairs));
  EXPECT_EQ(asking.wrong_answers(swarm), "");
}

TEST(Engine, SaysInWhichOfTwoSetsThePlaceIs) {
  std::vector<Point> good = swarm_of(20'000, 1.0).points;
  std::vector<Point> bad = good;
  bad[17'001].z = std::numeric_limits<double>::quiet_NaN();
  Engine engine;
  std::vector<PointId> at_risk;
  for (const unsigned threads : {1U, 2U}) {
    const SearchOptions options{1.0, false, threads};
    const Status first = engine.find_at_risk_between(bad, bad, options, at_risk);
    const Status second = engine.find_at_risk_between(good, bad, options, at_risk);
    ASSERT_FALSE(first.has_value() || second.has_value());
    EXPECT_EQ(first.error().location.array, "points");
    EXPECT_EQ(second.error().location.array, "others");
    EXPECT_EQ(second.error().code, ErrorCode::kNotFinite);
    EXPECT_EQ(second.error().location.record, 17'001U);
  }
}

TEST(VisitPairs, ShowsEveryPairOnceInBoundedBatches) {
  const Swarm swarm = swarm_of(20'000, 25.0);
  const std::vector<Pair> expected = *find_pairs(swarm.points, swarm.options);
  ASSERT_GT(expected.size(), 10 * kMostPairsAtOnce);
  for (const unsigned threads : {1U, 2U}) {
    std::vector<Pair> seen;
    std::atomic<int> inside = 0;
    const SearchOptions options{25.0, false, threads};
    const auto all = visit_pairs(swarm.points, options, [&](std::span<const Pair> batch) {
      EXPECT_EQ(++inside, 1) << "two at a time";
      EXPECT_LE(batch.size(), kMostPairsAtOnce);
      EXPECT_FALSE(batch.empty());
      seen.insert(seen.end(), batch.begin(), batch.end());
      --inside;
      return true;
    });
    ASSERT_TRUE(all.has_value());
    EXPECT_TRUE(*all);
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(seen, expected);
  }
}

// In a crowd one point has more neighbours than a batch has room for. A visitor that stops at any
// batch gets none after it, and nothing is written where no room is left.
TEST(VisitPairs, EndsAtAnyBatchInACrowdToo) {
  const std::vector<Point> crowd = test::SceneMaker(3).box(20'000, {0, 0, 0}, {120, 120, 120});
  for (const unsigned threads : {1U, 2U}) {
    for (std::size_t last = 1; last <= 12; ++last) {
      std::size_t batches = 0;
      const auto all = visit_pairs(crowd, {50.0, false, threads}, [&](std::span<const Pair> batch) {
        EXPECT_LE(batch.size(), kMostPairsAtOnce);
        return ++batches < last;
      });
      ASSERT_TRUE(all.has_value());
      EXPECT_FALSE(*all);
      EXPECT_EQ(batches, last);
    }
  }
}

}  // namespace
}  // namespace beespace
