// Once an Adviser has seen a few steps, advice for as many agents allocates nothing. Counted in all
// of this program: every operator new, on every thread.
#include "tests/support/allocation_count.hpp"
#include "tests/support/scene_maker.hpp"

#include <beespace/advise.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace beespace {
namespace {

TEST(AdviserAllocates, NothingForStepsThatItHasSeen) {
  for (const unsigned threads : {1U, 2U}) {
    test::SceneMaker make(7);
    constexpr std::size_t kSize = 17'000;  // enough that two threads share the work
    std::vector<Mover> movers;
    std::vector<Velocity> preferred;
    for (const Point& p : make.box(kSize, {0, 0, 0}, {1500, 1500, 300})) {
      movers.push_back({p, {}});
      preferred.push_back({make.between(-3, 3), make.between(-3, 3), 0});
    }
    const std::vector<FlightLimits> limits = {{.max_speed_mps = 5, .max_acceleration_mps2 = 3}};
    const AdviseOptions options{.threshold_m = 2.0, .step_s = 0.2, .threads = threads};
    Adviser adviser;
    Advised advised;
    const std::uint64_t at_first = test::allocations();
    for (int step = 0; step < 3; ++step) {
      ASSERT_TRUE(adviser.advise(movers, preferred, limits, options, advised));
    }
    EXPECT_GT(test::allocations(), at_first) << "nothing is counted";
    // Which worker meets the agent with the most neighbours differs from step to step: with two, it
    // takes some more steps until each has met it.
    const int most = threads == 1 ? 4 : 500;
    int steps = 0;
    int without = 0;
    for (; steps < most && without < 4; ++steps) {
      const std::uint64_t before = test::allocations();
      ASSERT_TRUE(adviser.advise(movers, preferred, limits, options, advised));
      without = test::allocations() == before ? without + 1 : 0;
    }
    EXPECT_EQ(without, 4) << "threads: " << threads << ", after " << steps << " steps";
  }
}

}  // namespace
}  // namespace beespace
