// What has happened between live bees: walks along the reports that have come since the last
// search.
#pragma once

#include "core/resources.hpp"
#include "motion/live_bees.hpp"
#include "motion/live_events.hpp"
#include "motion/pair_walk.hpp"
#include "motion/step_balls.hpp"

#include <beespace/swarm.hpp>

#include <cstdint>
#include <tuple>
#include <vector>

namespace beespace::motion {

class LiveWalks {
 public:
  // Bees enter by the inner separation and leave by the outer one.
  LiveWalks(const WalkSeparation& separation, double margin_m)
      : separation_(separation), margin_m_(margin_m) {}

  // Searches what is new, tells what has happened, and lets the bees forget what is done with.
  void search(LiveBees& bees, const core::Resources& with, std::vector<SwarmEvent>& events);

  // Whether two bees have entered and not left.
  [[nodiscard]] bool have_entered(PointId a, PointId b) const;

 private:
  // Two runs by their places, the lower first; what has been walked and said of them.
  struct LivePair {
    std::uint32_t first;
    std::uint32_t second;
    PairWalk::State state;
    PairTeller::Said said;

    [[nodiscard]] auto places() const { return std::tie(first, second); }
  };
  struct Entered {
    PointId first;
    PointId second;

    friend auto operator<=>(const Entered&, const Entered&) = default;  // NOLINT(*-use-nullptr)
  };

  void add_candidates(const core::Vector<core::FoundPairs>& candidates,
                      const std::vector<ActiveRun>& active, const std::vector<LiveRun>& bees);
  void walk(const std::vector<Run>& runs, const std::vector<LiveRun>& bees,
            const core::Resources& with, std::vector<SwarmEvent>& events);
  void forget(LiveBees& bees);

  WalkSeparation separation_;
  double margin_m_;
  std::vector<LivePair> pairs_;   // in conflict by the outer separation, ascending
  std::vector<Entered> entered_;  // ascending, the lower id first
};

}  // namespace beespace::motion
