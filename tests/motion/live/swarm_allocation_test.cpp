// Once a Swarm has seen a few looks, the next ones allocate nothing for agents that stay and pairs
// that go on. Counted in all of this program: every operator new, on every thread.
#include "tests/support/allocation_count.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beespace {
namespace {

// Agents that circle, so that pairs meet and part, and in every look some are predicted.
class Circling {
 public:
  explicit Circling(std::size_t agents) {
    test::SceneMaker make(7);
    centres_ = make.box(agents, {0, 0, 0}, {300, 300, 60});
    for (std::size_t i = 0; i < agents; ++i) phases_.push_back(make.between(0, 6.28));
  }

  void report(Swarm& swarm, double time_s) const {
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      const double angle = phases_[i] + 0.5 * time_s;
      const Point& c = centres_[i];
      ASSERT_TRUE(
          swarm.update({.id = kFirst + i,
                        .time_s = time_s,
                        .position = {c.x + 8 * std::cos(angle), c.y + 8 * std::sin(angle), c.z}}));
    }
  }

 private:
  static constexpr AgentId kFirst = AgentId{1} << 40;  // ids are of any size

  std::vector<Point> centres_;
  std::vector<double> phases_;
};

TEST(SwarmAllocates, NothingForWhatItHasSeen) {
  const Circling flock(2'000);
  Crew alone;
  Swarm swarm({.threshold_m = 2.0, .horizon_s = 3.0}, alone);
  std::vector<SwarmEvent> events;
  std::vector<LiveMover> movers;
  const std::uint64_t at_first = test::allocations();
  std::uint64_t taken = 0;
  std::size_t told = 0;
  constexpr int kTurn = 63;  // looks, after which all are where they were
  for (int look = 0; look < 7 * kTurn; ++look) {
    const std::uint64_t before = test::allocations();
    flock.report(swarm, 0.2 * look);
    ASSERT_TRUE(swarm.advance(0.2 * look, events));
    swarm.movers(0.2 * look, movers);
    ASSERT_EQ(movers.size(), 2'000U);
    EXPECT_GE(movers.front().id, AgentId{1} << 40);
    if (look < 6 * kTurn) continue;
    taken += test::allocations() - before;
    told += events.size();
  }
  EXPECT_GT(test::allocations(), at_first) << "nothing is counted";
  EXPECT_GT(told, 1000U);
  EXPECT_EQ(taken, 0U);
}

}  // namespace
}  // namespace beespace
