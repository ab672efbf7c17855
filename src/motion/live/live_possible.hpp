// Possible conflicts of silent bees: each bee is in a ball around its last known position, which
// grows with the greatest speed of all until it is heard again.
//
// The other bee is in a ball around its last report, too. Two balls are largest just before one of
// the two is heard again. So they are compared at that time, whenever this is called, also for
// silences that are over by then.
#pragma once

#include "base/resources.hpp"
#include "motion/live/live_bees.hpp"
#include "motion/live/live_overload.hpp"
#include "motion/separation.hpp"

#include <beespace/point.hpp>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::motion {

class LivePossible {
 public:
  LivePossible(const Separation& enter, double max_speed_mps, double max_age_s,
               std::size_t max_pairs)
      : enter_(enter),
        max_speed_mps_(max_speed_mps),
        max_age_s_(max_age_s),
        max_pairs_(max_pairs) {}

  // Reports the pairs that have become possible and of which one bee is silent, or was in one of
  // the silences that have ended since the last call: each pair once, until one of the two is heard
  // again after a silence.
  LeftOut search(const LiveBees& bees, const std::vector<Return>& returns, double now_s,
                 const core::Resources& with, std::vector<SwarmEvent>& events);
  // Forgets what was reported of a removed bee.
  void forget(AgentId bee);
  void forget_all() {
    silent_.clear();
    reported_until_s_ = LiveSegment::kNever;
  }

 private:
  // A report of a bee; the bee is silent if the next report comes later than the greatest age.
  struct Place {
    AgentId bee;
    Fix at;
    double height_m;
    double silent_after_s;
  };
  // The places of a bee since the last call, ascending in time: places_[begin] to places_[end - 1].
  struct Heard {
    AgentId bee;
    std::size_t begin;
    std::size_t end;
  };
  // A silence, and the bees with which a conflict has been reported as possible in it: ascending.
  struct Silent {
    Place last;
    double ends_s = std::numeric_limits<double>::infinity();
    std::vector<AgentId> reported = {};
    std::size_t unreported = 0;  // others, at the last search
    std::uint64_t all_reported_at =
        0;  // of LiveBees::changes(): nothing is left to say until it changes

    [[nodiscard]] bool goes_on() const { return ends_s == std::numeric_limits<double>::infinity(); }
  };
  struct Found {
    SwarmEvent event;
    std::size_t silent;  // of silent_
    AgentId other;
    bool goes_on;  // neither has been heard since
  };

  void note_places(const LiveBees& bees, const std::vector<Return>& returns);
  void follow(const LiveBees& bees, const std::vector<Return>& returns);
  void look_around(std::size_t index, double now_s, std::vector<Found>& found);
  bool judge(std::size_t index, const Heard& other, bool reported, double now_s,
             std::vector<Found>& found) const;
  [[nodiscard]] std::optional<SwarmEvent> possible(const Place& silent, const Place& other,
                                                   double at_s) const;

  Separation enter_;
  double max_speed_mps_;
  double max_age_s_;
  std::size_t max_pairs_;
  double reported_until_s_ = LiveSegment::kNever;
  std::vector<Silent> silent_;  // ascending by bee; between calls those that go on
  std::vector<Place> places_;
  std::vector<Heard> heard_;  // ascending
};

}  // namespace beespace::motion
