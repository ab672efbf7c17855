// Two runs, piece by piece: in which windows of time are they in conflict, and what is that as one
// stretch?
//
// A window is the time in which both are on one straight piece each; there the exact decision of
// encounter.hpp holds. Windows follow each other without a gap, so a conflict goes on in the next
// one if and only if the two are in conflict at the instant in between.
#pragma once

#include "motion/runs.hpp"
#include "motion/separation.hpp"

#include <beespace/conflict.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace beespace::motion {

// Conflict by the outer separation makes a stretch; conflict by the inner one, in some window of
// it, makes it certain. Outer and inner are what tolerances leave open (recordings), or where bees
// leave and where they enter (live).
struct WalkSeparation {
  Separation outer;
  Separation inner;
  bool same = true;  // there is no difference

  // What the tolerances of the two make of a separation.
  static WalkSeparation within(const Separation& separation, const Run& first, const Run& second);
};

// A stretch: where it began, and what there was of it.
struct Stretch {
  Conflict conflict;       // ends at the end of the last window
  double end_m = 0.0;      // how far apart the two are there
  double certain_s = 0.0;  // since when it is certain, if it is
  double certain_m = 0.0;  // and how far apart they are then
};

// Where a walk has come to: what it needs to go on later.
struct WalkState {
  std::size_t first_piece = 0;  // the window to walk next
  std::size_t second_piece = 0;
  double walked_until = -std::numeric_limits<double>::infinity();  // the end of the one before
  std::optional<Stretch> open = {};                                // in conflict at that instant
};

class PairWalk {
 public:
  using Stretch = motion::Stretch;
  using State = WalkState;

  PairWalk(const Run& first, const Run& second, const WalkSeparation& separation)
      : first_(first),
        second_(second),
        separation_(separation),
        reach_m_(separation.outer.reach_m()) {}

  // Walks the windows that meet the time, each as a whole, from where `state` has come to. Calls
  // ended(stretch) with each that has ended, and going_on(stretch) after each window at whose end
  // one goes on.
  template <class Ended, class GoingOn>
  void walk(const TimeSpan& time, State& state, Ended&& ended, GoingOn&& going_on) const;
  template <class Ended>
  void walk(const TimeSpan& time, State& state, Ended&& ended) const {
    walk(time, state, ended, [](const Stretch&) {});
  }

 private:
  // The stretch that the window has ended, if it has.
  std::optional<Stretch> walk_window(const Piece& first, const Piece& second,
                                     const TimeSpan& window, State& state) const;

  const Run& first_;
  const Run& second_;
  const WalkSeparation& separation_;
  double reach_m_;
};

template <class Ended, class GoingOn>
void PairWalk::walk(const TimeSpan& time, State& state, Ended&& ended, GoingOn&& going_on) const {
  while (state.first_piece < first_.pieces() && state.second_piece < second_.pieces()) {
    const Piece first = piece_of(first_, state.first_piece);
    const Piece second = piece_of(second_, state.second_piece);
    const TimeSpan window{std::max(first.from.time_s, second.from.time_s),
                          std::min(first.to.time_s, second.to.time_s)};
    if (window.begins_s > time.ends_s) return;
    if (window.begins_s <= window.ends_s && window.ends_s >= time.begins_s) {
      const std::optional<Stretch> over = walk_window(first, second, window, state);
      if (over) ended(*over);
      if (state.open) going_on(std::as_const(*state.open));
    }
    if (first.to.time_s <= window.ends_s) ++state.first_piece;
    if (second.to.time_s <= window.ends_s) ++state.second_piece;
  }
  const bool over = (state.first_piece >= first_.pieces() && first_.complete) ||
                    (state.second_piece >= second_.pieces() && second_.complete);
  if (over && state.open) ended(*std::exchange(state.open, std::nullopt));
}

}  // namespace beespace::motion
