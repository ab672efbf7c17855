// The events of a pair of live bees, and which of them have been reported already.
#pragma once

#include "motion/pair_walk.hpp"

#include <beespace/swarm.hpp>

#include <limits>
#include <vector>

namespace beespace::motion {

// Turns the results of a walk into events, each reported once a stretch; the closest approach again
// only when the two have come clearly closer than reported.
class EventEmitter {
 public:
  // The reported events of the current stretch.
  struct Reported {
    bool entered = false;
    double closest_m = std::numeric_limits<double>::infinity();
  };

  // `cut_off` is the event that ends a stretch which ends with what is known: kLeft where one of
  // the two was removed, kLost where it is silent, kEnded where nothing more comes.
  EventEmitter(AgentId a, AgentId b, double margin_m, EventKind cut_off, Reported& reported,
               std::vector<SwarmEvent>& events)
      : first_(std::min(a, b)),
        second_(std::max(a, b)),
        margin_m_(margin_m),
        cut_off_(cut_off),
        reported_(reported),
        events_(events) {}

  void going_on(const PairWalk::Stretch& stretch) {
    if (!stretch.conflict.certain) return;
    emit_entered(stretch);
    emit_closest_if_passed(stretch);
  }

  void ended(const PairWalk::Stretch& stretch) {
    if (stretch.conflict.certain) {
      emit_entered(stretch);
      // If a pair is cut off while it comes closer, the closest approach has not passed.
      stretch.cut_off ? emit_closest_if_passed(stretch) : emit_closest(stretch);
      emit(stretch.cut_off ? cut_off_ : EventKind::kLeft, stretch.conflict.ends_s, stretch.end_m,
           stretch);
    }
    reported_ = {};
  }

 private:
  void emit_entered(const PairWalk::Stretch& stretch) {
    if (reported_.entered) return;
    reported_.entered = true;
    emit(EventKind::kEntered, stretch.certain_s, stretch.certain_m, stretch);
  }
  // How far apart they must be again before the closest approach counts as passed.
  void emit_closest_if_passed(const PairWalk::Stretch& stretch) {
    if (stretch.end_m >= stretch.conflict.closest_m + margin_m_) emit_closest(stretch);
  }
  void emit_closest(const PairWalk::Stretch& stretch) {
    const double closest_m = stretch.conflict.closest_m;
    if (!(closest_m < reported_.closest_m - margin_m_) && !first_closest()) return;
    reported_.closest_m = closest_m;
    emit(EventKind::kClosestPassed, stretch.conflict.closest_s, closest_m, stretch);
  }
  [[nodiscard]] bool first_closest() const {
    return reported_.closest_m == std::numeric_limits<double>::infinity();
  }
  void emit(EventKind kind, double time_s, double distance_m, const PairWalk::Stretch& stretch) {
    const double since_s = kind == EventKind::kLost ? time_s : 0.0;
    events_.push_back(
        {kind, time_s, first_, second_, distance_m, stretch.conflict.closest_s, since_s});
  }

  AgentId first_;
  AgentId second_;
  double margin_m_;
  EventKind cut_off_;
  Reported& reported_;
  std::vector<SwarmEvent>& events_;
};

}  // namespace beespace::motion
