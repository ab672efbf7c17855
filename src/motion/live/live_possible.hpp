// What stale bees may be in conflict with: each bee is somewhere in a ball around where it was last
// heard of, which grows with the greatest speed of any.
#pragma once

#include "base/resources.hpp"
#include "motion/live/live_bees.hpp"
#include "motion/live/live_overload.hpp"
#include "motion/separation.hpp"

#include <beespace/point.hpp>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::motion {

class LivePossible {
 public:
  LivePossible(const Separation& enter, double max_speed_mps, std::size_t max_pairs)
      : enter_(enter), max_speed_mps_(max_speed_mps), max_pairs_(max_pairs) {}

  // Tells the pairs of which one is stale and that have become possible: each once a silence.
  LeftOut tell(const LiveBees& bees, double now_s, const core::Resources& with,
               std::vector<SwarmEvent>& events);
  // What has been said of a bee that has been heard of again, or removed: with others that are
  // still silent it is said anew.
  void forget(PointId bee);
  void forget_all() { silent_.clear(); }

 private:
  struct Heard {
    PointId bee;
    Fix last;
    double height_m;
    bool stale;
  };
  // A silence, and with whom a conflict has been said to be possible in it: ascending.
  struct Silent {
    PointId bee;
    double since_s;
    std::vector<PointId> said;
    std::size_t unsaid = 0;  // others, at the last look around
    std::uint64_t all_said_at =
        0;  // of LiveBees::changes(): nothing is left to say until it changes
  };

  static std::vector<Heard> heard_of(const LiveBees& bees);
  void follow(const std::vector<Heard>& heard);
  void remember(const SwarmEvent& event);
  void probe_neighbors(const Heard& stale, Silent& silent, const std::vector<Heard>& heard,
                       double now_s, std::vector<SwarmEvent>& found) const;

  Separation enter_;
  double max_speed_mps_;
  std::size_t max_pairs_;
  std::vector<Silent> silent_;  // ascending
};

}  // namespace beespace::motion
