// A stop that is requested, at whatever moment, ends every long call with an error of its own and
// no answer; and nothing else: the next call of the same Engine is complete.
#include "tests/support/scene_maker.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

// Two workers on one thread; requests a stop when so many tasks have run.
class StoppingCrew final : public Crew {
 public:
  [[nodiscard]] unsigned size() const override { return 2; }
  void run(Task task) override {
    for (unsigned worker = 0; worker < size(); ++worker) {
      if (left_ == 0) source_.request_stop();
      --left_;
      task(worker);
    }
  }
  std::stop_token stop_after(std::size_t tasks) {
    source_ = {};
    left_ = tasks;
    return source_.get_token();
  }

 private:
  std::stop_source source_;
  std::size_t left_ = 0;
};

struct Answers {
  std::vector<std::uint32_t> ids;
  std::vector<Pair> pairs;
  IdRows rows;
  std::vector<Nearest> nearest;
  NearestRows nearest_rows;
  std::vector<Conflict> conflicts;
  std::optional<ClosestPair> closest;

  friend bool operator==(const Answers&, const Answers&) = default;
};

// Writes the answer; what a visitor saw of a search that was stopped is none.
struct Call {
  std::string name;
  std::function<Status(Engine&, std::stop_token, Answers&)> ask;
};

std::vector<Call> calls(const std::vector<Point>& points, const std::vector<Point>& others) {
  const auto within = [](std::stop_token stop) {
    return SearchOptions{.threshold_m = 12.0, .stop = std::move(stop)};
  };
  const auto upright = [](std::stop_token stop) {
    return SearchOptions{.threshold_m = 12.0, .vertical_m = 9.0, .stop = std::move(stop)};
  };
  const auto ahead = [](std::stop_token stop) {
    return PredictOptions{.threshold_m = 4.0, .horizon_s = 1.0, .stop = std::move(stop)};
  };
  const auto closest = [](Answers& answers, const Result<std::optional<ClosestPair>>& found) {
    return found.transform([&](const auto& pair) { answers.closest = pair; });
  };
  using E = Engine&;
  using A = Answers&;
  using S = std::stop_token;
  const auto visited = [](const Result<bool>& all, std::vector<Pair>& pairs) -> Status {
    std::sort(pairs.begin(), pairs.end());
    if (all) return std::monostate{};
    pairs.clear();
    return all.error();
  };
  return {
      {"at risk", [=](E e, S s, A a) { return e.find_at_risk(points, within(s), a.ids); }},
      {"at risk between",
       [=](E e, S s, A a) { return e.find_at_risk_between(points, others, within(s), a.ids); }},
      {"at risk, cylinder",
       [=](E e, S s, A a) { return e.find_at_risk(points, upright(s), a.ids); }},
      {"pairs", [=](E e, S s, A a) { return e.find_pairs(points, within(s), a.pairs); }},
      {"pairs, cylinder", [=](E e, S s, A a) { return e.find_pairs(points, upright(s), a.pairs); }},
      {"pairs between, cylinder",
       [=](E e, S s, A a) { return e.find_pairs_between(points, others, upright(s), a.pairs); }},
      {"visited pairs",
       [=](E e, S s, A a) {
         const auto all = e.visit_pairs(points, within(s), [&](std::span<const Pair> batch) {
           a.pairs.insert(a.pairs.end(), batch.begin(), batch.end());
           return true;
         });
         return visited(all, a.pairs);
       }},
      {"neighbours", [=](E e, S s, A a) { return e.find_neighbors(points, within(s), a.rows); }},
      {"counts", [=](E e, S s, A a) { return e.count_neighbors(points, within(s), a.ids); }},
      {"groups", [=](E e, S s, A a) { return e.find_conflict_groups(points, within(s), a.rows); }},
      {"groups, cylinder",
       [=](E e, S s, A a) { return e.find_conflict_groups(points, upright(s), a.rows); }},
      {"nearest",
       [=](E e, S s, A a) {
         return e.find_nearest(points, a.nearest, {1, s});
       }},
      {"nearest within",
       [=](E e, S s, A a) { return e.find_nearest_within(points, within(s), a.nearest); }},
      {"nearest between",
       [=](E e, S s, A a) {
         return e.find_nearest_between(points, others, a.nearest, {1, s});
       }},
      {"k nearest",
       [=](E e, S s, A a) {
         return e.find_k_nearest(points, 4, a.nearest_rows, {1, s});
       }},
      {"closest pair",
       [=](E e, S s, A a) {
         return closest(a, e.find_closest_pair(points, {1, s}));
       }},
      {"closest pair between",
       [=](E e, S s, A a) {
         return closest(a, e.find_closest_pair_between(points, others, {1, s}));
       }},
      {"predicted conflicts",
       [=](E e, S s, A a) {
         return e.predict_conflicts({points, others}, ahead(s), a.conflicts);
       }},
      {"predicted pairs",
       [=](E e, S s, A a) {
         return e.predict_pairs({points, others}, ahead(s), a.pairs);
       }},
  };
}

TEST(Stop, AtAnyMomentLeavesNoAnswerAndNoTrace) {
  test::SceneMaker make(3);
  std::vector<Point> points = make.box(1500, {0, 0, 0}, {150, 150, 150});
  for (std::size_t i = 0; i < 300; ++i) points[i] = {0.1 * static_cast<double>(i % 7), 0, 0};
  const std::vector<Point> others = make.box(1500, {0, 0, 0}, {150, 150, 150});
  StoppingCrew crew;
  Engine engine(crew);
  for (const Call& call : calls(points, others)) {
    Answers right;
    ASSERT_TRUE(call.ask(engine, {}, right)) << call.name;
    std::size_t stopped = 0;
    for (std::size_t tasks = 0;; ++tasks) {
      const std::stop_token stop = crew.stop_after(tasks);
      Answers answers;
      const Status status = call.ask(engine, stop, answers);
      if (status) {
        EXPECT_EQ(answers, right) << call.name;
        EXPECT_FALSE(stop.stop_requested()) << call.name;
        break;
      }
      ++stopped;
      ASSERT_EQ(status.error().code, ErrorCode::kStopped) << call.name;
      ASSERT_EQ(answers, Answers{}) << call.name << ", after " << tasks << " tasks";
      ASSERT_LT(tasks, 100'000U);
    }
    EXPECT_GT(stopped, 1U) << call.name;
  }
}

TEST(Stop, IsAnErrorOfItsOwn) {
  EXPECT_EQ(to_string(ErrorCode::kStopped), "stopped");
  std::stop_source source;
  source.request_stop();
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}};
  const auto found = find_at_risk(points, {.threshold_m = 2.0, .stop = source.get_token()});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kStopped);
}

// What is wrong with the question is said all the same.
TEST(Stop, ComesAfterOptionsThatMakeNoSense) {
  std::stop_source source;
  source.request_stop();
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}};
  const auto found = find_at_risk(points, {.threshold_m = -2.0, .stop = source.get_token()});
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::kInvalidThreshold);
}

// Twenty thousand million pairs would take a minute.
TEST(Stop, EndsALongSearchSoon) {
  test::SceneMaker make(4);
  const std::vector<Point> crowd = make.box(200'000, {0, 0, 0}, {1, 1, 1});
  for (const unsigned threads : {1U, 2U}) {
    for (const std::optional<double> vertical_m : {std::optional<double>(), std::optional(9.0)}) {
      std::stop_source source;
      std::uint64_t seen = 0;
      const SearchOptions options{.threshold_m = 9.0,
                                  .threads = threads,
                                  .vertical_m = vertical_m,
                                  .stop = source.get_token()};
      const auto all = visit_pairs(crowd, options, [&](std::span<const Pair> pairs) {
        seen += pairs.size();
        source.request_stop();
        return true;
      });
      ASSERT_FALSE(all);
      EXPECT_EQ(all.error().code, ErrorCode::kStopped);
      EXPECT_LT(seen, 4'000'000'000U);
    }
  }
}

// A search that a visitor makes is not stopped with the one that it visits.
TEST(Stop, IsNotThatOfASearchWithin) {
  test::SceneMaker make(5);
  const std::vector<Point> points = make.box(3000, {0, 0, 0}, {60, 60, 60});
  const auto right = *find_pairs(points, {.threshold_m = 6.0});
  std::stop_source source;
  bool complete = false;
  const SearchOptions options{.threshold_m = 6.0, .stop = source.get_token()};
  const auto all = visit_pairs(points, options, [&](std::span<const Pair>) {
    source.request_stop();
    const auto within = find_pairs(points, {.threshold_m = 6.0});
    complete = within && *within == right;
    return true;
  });
  EXPECT_TRUE(complete);
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().code, ErrorCode::kStopped);
}

TEST(Stop, EndsRecordingsIndexesAndVerification) {
  std::stop_source source;
  source.request_stop();
  const std::stop_token stop = source.get_token();
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}};
  const std::vector<Track> tracks = {{{{0.0, {0, 0, 0}}, {1.0, {1, 0, 0}}}},
                                     {{{0.0, {0, 9, 0}}, {1.0, {1, 8, 0}}}}};
  const auto is_stopped = [](const auto& result) {
    return !result && result.error().code == ErrorCode::kStopped;
  };
  EXPECT_TRUE(is_stopped(find_conflicts(tracks, {.threshold_m = 2.0, .stop = stop})));
  EXPECT_TRUE(is_stopped(find_closest_encounter(tracks, 10.0, {1, stop})));
  EXPECT_TRUE(is_stopped(Index::build(points, {1, stop})));
  const Index index = *Index::build(points);
  EXPECT_TRUE(is_stopped(index.find_around(points, {.radius_m = 1.0, .stop = stop})));
  EXPECT_TRUE(is_stopped(index.k_nearest(points, 1, {1, stop})));
  Verifier verifier({.threshold_m = 0.5, .stop = stop});
  const std::vector<Mover> movers = {{{0, 0, 0}, {}}, {{9, 0, 0}, {}}};
  const Status first = verifier.add(0.0, movers);
  EXPECT_TRUE(is_stopped(first) || is_stopped(verifier.add(1.0, movers)));
}

}  // namespace
}  // namespace beespace
