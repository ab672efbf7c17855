// What append_places() gives: the hull of all nominal places.
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/guide/branches_helpers.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/follower.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::guide {
namespace {

using core::Vector3;
using core::vector_of;
using fleet::Braking;
using scenes::RandomStream;

double support(const std::vector<Point>& places, const Vector3& direction) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Point& p : places) farthest = std::max(farthest, dot(vector_of(p), direction));
  return farthest;
}

// A planner and an agent that hear each other badly.
class Flight {
 public:
  explicit Flight(std::uint64_t seed, int delay) : random_(seed), delay_(delay) {
    follower.advance(0);
    branches.write_root(command_);
    branches.acknowledge(follower.receive(command_));
    all_.push_back(command_);
  }

  // All nominal places from a tick on, of all live branches, at ticks and halfway.
  [[nodiscard]] std::vector<Point> nominal_places(Tick from) const {
    std::vector<Point> places;
    const Braking braking(kPlanned, kPeriod_s);
    for (const Command& command : all_) {
      if (!branches.lives(command.number)) continue;
      const fleet::Path path = fleet::path_of(command);
      for (Tick tick = from; tick < from + delay_ + 12; ++tick) {
        const BranchState state = path.at(tick, braking);
        const BranchState next = path.at(tick + 1, braking);
        places.push_back(state.nominal.position);
        places.push_back(
            fleet::within_tick(state, next, 0.5 * kPeriod_s, kPeriod_s).nominal.position);
      }
    }
    return places;
  }

  void step(Tick now) {
    branches.advance(now);
    follower.advance(now);
    if (!branches.full() && random_.uniform(0.0, 1.0) < 0.7) {
      Velocity v = branches.base_state(branches.departs()).velocity;
      const auto towards = [&](double& value) {
        value = std::clamp(value + random_.uniform(-0.5, 0.5), -4.0, 4.0);
      };
      towards(v.x);
      towards(v.y);
      towards(v.z);
      branches.issue(v, {}, command_);
      added = vector_of(
          fleet::latest_stop(command_.path().back().nominal, Braking(kPlanned, kPeriod_s)));
      all_.push_back(command_);
      if (random_.uniform(0.0, 1.0) < 0.6) follower.receive(command_);
    }
    if (random_.uniform(0.0, 1.0) < 0.2) branches.report(follower.held(), follower.tick());
    if (random_.uniform(0.0, 1.0) < 0.2) branches.acknowledge(taken(follower.held()));
  }

  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  std::optional<Vector3> added;

 private:
  RandomStream random_;
  int delay_;
  Command command_;
  std::vector<Command> all_;

 public:
  Branches branches = Branches::rooted(options(delay_), kPlace, 0);
};

TEST(Branches, AClaimHoldsAllNominalPlacesAndIsNoLargerThanNeeded) {
  RandomStream random(9);
  std::size_t points = 0;
  std::size_t claims = 0;
  for (int flown = 0; flown < std::max(2, test::rounds(40)); ++flown) {
    Flight flight(static_cast<std::uint64_t>(flown), 1 + flown % 5);
    std::vector<Point> before = places_from(flight.branches, 0);
    for (Tick now = 1; now < 60; ++now) {
      flight.added.reset();
      flight.step(now);
      ASSERT_TRUE(flight.branches.lives(flight.follower.held()));
      for (const Tick from : {now - 1, now}) {
        const std::vector<Point> claim = places_from(flight.branches, from);
        const std::vector<Point> nominal = flight.nominal_places(from);
        points += claim.size();
        ++claims;
        for (int look = 0; look < 20; ++look) {
          const Vector3 to = vector_of(scenes::random_direction(random));
          ASSERT_GE(support(claim, to), support(nominal, to) - 1e-12);
          // It grows by the stop of the new command alone.
          if (from == now - 1) {
            double known = support(before, to);
            if (flight.added) known = std::max(known, dot(*flight.added, to));
            ASSERT_LE(support(claim, to), known + 1e-12);
          }
        }
      }
      before = places_from(flight.branches, now);
    }
  }
  EXPECT_LT(points, 14 * claims);
}

// The point that decides: where the agent is when it departs, half a tick on, and its way after.
TEST(Branches, ACommandAddsThePlaceThatTheAdviserTests) {
  Branches branches = Branches::rooted(options(), kPlace, 10);
  const Braking braking(kPlanned, kPeriod_s);
  for (Tick now = 11; now < 15; ++now) {
    branches.advance(now);
    const Mover from = branches.base_state(branches.departs());
    const Velocity next = changed(branches, 0.75);
    const Vector3 q = vector_of(from.position) + braking.drift(vector_of(from.velocity)) +
                      braking.way_after(vector_of(next));
    issue(branches, 0.75);
    const std::vector<Point> places = places_from(branches, now);
    EXPECT_TRUE(std::any_of(places.begin(), places.end(), [&](const Point& place) {
      return core::length(vector_of(place) - q) < 1e-12;
    }));
  }
}

TEST(Branches, AnAgentThatStandsForLongClaimsAPlace) {
  Branches branches = Branches::rooted(options(), kPlace, 0);
  for (Tick now = 1; now < 4; ++now) {
    branches.advance(now);
    issue(branches, 1.0);
  }
  branches.acknowledge(taken(number(4)));
  for (Tick now = 4; now < 300; ++now) branches.advance(now);
  const std::vector<Point> places = places_from(branches, 299);
  for (const Point& place : places) EXPECT_EQ(place, branches.base_state(300).position);
  EXPECT_LE(places.size(), 2U);
  EXPECT_FALSE(branches.would_change({}));
}

}  // namespace
}  // namespace beespace::guide
