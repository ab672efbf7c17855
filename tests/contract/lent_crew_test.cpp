// What works with the caller's threads gives the answers that it gives with its own, and uses all
// of the caller's; and a stop ends the advice at whatever moment it is requested.
#include "tests/support/scene_maker.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <stop_token>
#include <utility>
#include <vector>

namespace beespace {
namespace {

// Three workers on one thread. Counts its tasks, and requests a stop when so many have run.
class CountingCrew final : public Crew {
 public:
  [[nodiscard]] unsigned size() const override { return 3; }
  void run(Task task) override {
    if (tasks_ == stop_after_) source_.request_stop();
    ++tasks_;
    for (unsigned worker = 0; worker < size(); ++worker) task(worker);
  }

  [[nodiscard]] std::size_t tasks() const { return tasks_; }
  std::stop_token stop_after(std::size_t tasks) {
    stop_after_ = tasks_ + tasks;
    source_ = {};
    return source_.get_token();
  }

 private:
  std::size_t tasks_ = 0;
  std::size_t stop_after_ = static_cast<std::size_t>(-1);
  std::stop_source source_;
};

struct Flock {
  Flock() {
    test::SceneMaker make(11);
    for (const Point& p : make.box(600, {0, 0, 0}, {120, 120, 40})) {
      movers.push_back({p, {make.between(-2, 2), make.between(-2, 2), 0}});
      preferred.push_back({make.between(-3, 3), make.between(-3, 3), 0});
    }
  }

  [[nodiscard]] Result<Advised> advised_by(Adviser& adviser, std::stop_token stop = {}) const {
    const AdviseOptions options{.threshold_m = 2.0, .step_s = 0.2, .stop = std::move(stop)};
    Advised advised;
    return adviser.advise(movers, preferred, limits, options, advised)
        .transform([&](std::monostate) { return advised; });
  }

  std::vector<Mover> movers;
  std::vector<Velocity> preferred;
  std::vector<FlightLimits> limits = {{.max_speed_mps = 5, .max_acceleration_mps2 = 3}};
};

void expect_same(const Advised& a, const Advised& b) {
  EXPECT_EQ(a.advice, b.advice);
  EXPECT_EQ(a.too_close.size(), b.too_close.size());
}

TEST(LentCrew, AdvisesAsAnAdvisersOwn) {
  const Flock flock;
  CountingCrew crew;
  Adviser lent(crew);
  Adviser own;
  const auto expected = flock.advised_by(own);
  const auto advised = flock.advised_by(lent);
  ASSERT_TRUE(expected && advised);
  expect_same(*advised, *expected);
  EXPECT_GT(crew.tasks(), 0U);
}

TEST(LentCrew, IsStoppedAtAnyMomentOfTheAdvice) {
  const Flock flock;
  CountingCrew crew;
  Adviser adviser(crew);
  const auto expected = flock.advised_by(adviser);
  ASSERT_TRUE(expected);
  const std::size_t tasks = crew.tasks();
  ASSERT_GT(tasks, 3U);
  for (std::size_t after = 0; after < tasks; ++after) {
    const auto stopped = flock.advised_by(adviser, crew.stop_after(after));
    ASSERT_FALSE(stopped) << after;
    EXPECT_EQ(stopped.error().code, ErrorCode::kStopped);
  }
  const auto again = flock.advised_by(adviser, crew.stop_after(tasks));
  ASSERT_TRUE(again);
  expect_same(*again, *expected);
}

TEST(LentCrew, LeavesNoAdviceWhereItWasStopped) {
  const Flock flock;
  Adviser adviser;
  std::stop_source source;
  source.request_stop();
  Advised advised;
  advised.advice.resize(3);
  const AdviseOptions options{.threshold_m = 2.0, .step_s = 0.2, .stop = source.get_token()};
  const Status status =
      adviser.advise(flock.movers, flock.preferred, flock.limits, options, advised);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kStopped);
  EXPECT_TRUE(advised.advice.empty());
}

TEST(LentCrew, FollowsASwarmAsItsOwn) {
  const Flock flock;
  CountingCrew crew;
  const SwarmOptions options{.threshold_m = 2.0, .horizon_s = 3.0};
  Swarm lent(options, crew);
  Swarm own(options);
  std::vector<SwarmEvent> events;
  std::size_t told = 0;
  for (int look = 0; look < 20; ++look) {
    const double time_s = 0.5 * look;
    for (std::size_t i = 0; i < flock.movers.size(); ++i) {
      const Mover& mover = flock.movers[i];
      const PositionReport report{
          .id = i,
          .time_s = time_s,
          .position = {mover.position.x + mover.velocity.x * time_s,
                       mover.position.y + mover.velocity.y * time_s, mover.position.z}};
      ASSERT_TRUE(lent.update(report));
      ASSERT_TRUE(own.update(report));
    }
    const auto expected = own.advance(time_s);
    ASSERT_TRUE(expected);
    ASSERT_TRUE(lent.advance(time_s, events));
    EXPECT_EQ(events, *expected);
    told += events.size();
  }
  EXPECT_GT(told, 100U);
  EXPECT_GT(crew.tasks(), 0U);
}

TEST(LentCrew, AnswersForAnIndexAsItsOwn) {
  test::SceneMaker make(5);
  const std::vector<Point> points = make.box(3'000, {0, 0, 0}, {100, 100, 100});
  CountingCrew crew;
  auto lent = Index::build(points, crew);
  auto own = Index::build(points);
  ASSERT_TRUE(lent && own);
  const std::size_t built_with = crew.tasks();
  EXPECT_GT(built_with, 0U);
  const AroundOptions around{.radius_m = 5.0};
  EXPECT_EQ(lent->find_around(points, around).value(), own->find_around(points, around).value());
  EXPECT_GT(crew.tasks(), built_with);
  const std::size_t found_with = crew.tasks();
  EXPECT_EQ(lent->k_nearest(points, 4).value(), own->k_nearest(points, 4).value());
  EXPECT_GT(crew.tasks(), found_with);
  const std::size_t near_with = crew.tasks();
  lent->rebuild();
  EXPECT_GT(crew.tasks(), near_with);
}

}  // namespace
}  // namespace beespace
