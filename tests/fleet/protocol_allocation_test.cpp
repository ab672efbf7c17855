// A Follower never allocates, and neither does what a planner knows of its branches once they have
// begun. Counted in all of this program: every operator new.
#include "guide/branches.hpp"
#include "tests/support/allocation_count.hpp"

#include <beespace/follower.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace beespace {
namespace {

constexpr FlightLimits kPlanned{.max_speed_mps = 8.0, .max_acceleration_mps2 = 2.0};
constexpr double kPeriod_s = 0.1;

TEST(ProtocolAllocates, NothingOnceItHasBegun) {
  auto planner = guide::Branches::rooted(
      {.agent = 7, .planned = kPlanned, .period_s = kPeriod_s, .command_delay = 4}, {1, 2, 3}, 0);
  Follower follower = *Follower::make(7, kPlanned, kPeriod_s);
  Command command;
  std::vector<Point> places;
  places.reserve(100);
  const std::uint64_t before = test::allocations();
  int taken = 0;
  Setpoint last;
  for (Tick now = 0; now < 500; ++now) {
    planner.advance(now);
    follower.advance(now);
    if (planner.awaits_root()) {
      planner.write_root(command);
      planner.acknowledge(follower.receive(command));
    }
    const double speed_mps = now % 20 < 10 ? 0.1 : -0.1;
    Velocity next = planner.base_state(planner.departs()).velocity;
    next.x += speed_mps;
    if (!planner.full()) {
      planner.issue(next, {}, command);
      // Three of four get through, and so do one of seven reports.
      if (now % 4 != 0) taken += follower.receive(command).reply == CommandReply::kTaken ? 1 : 0;
      if (now % 7 == 0) planner.report(follower.held(), now);
    }
    places.clear();
    planner.append_places(now, places);
    last = follower.setpoint(0.05);
    if (now % 100 == 99) {
      StoredBranch stored = follower.stored();
      follower.lose();
      ASSERT_TRUE(follower.restore(stored));
    }
  }
  EXPECT_EQ(test::allocations(), before);
  EXPECT_GT(taken, 100);
  EXPECT_GE(last.nominal.position.x, 1.0);
  const auto copy = std::make_unique<Command>(command);
  EXPECT_GT(test::allocations(), before) << "nothing is counted";
}

}  // namespace
}  // namespace beespace
