// Two segments, piece by piece: in which windows of time are they in conflict, and what is that as
// one stretch?
//
// A window is the time in which both are on one straight piece each; there the exact decision of
// encounter.hpp holds. Windows follow each other without a gap, so a conflict goes on in the next
// one if and only if the two are in conflict at the instant in between.
#pragma once

#include "motion/separation.hpp"
#include "motion/track_segments.hpp"

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
  static WalkSeparation within(const Separation& separation, const TrackSegment& first,
                               const TrackSegment& second);
};

// A stretch: where it began, and what there was of it.
struct Stretch {
  Conflict conflict;       // ends at the end of the last window
  double end_m = 0.0;      // how far apart the two are there
  double certain_s = 0.0;  // since when it is certain, if it is
  double certain_m = 0.0;  // and how far apart they are then
  bool cut_off = false;    // ends because one of the two is not known any longer
};

// Where a walk has come to: what it needs to go on later.
struct WalkState {
  std::size_t first_piece = 0;  // the window to walk next
  std::size_t second_piece = 0;
  double walked_until = -std::numeric_limits<double>::infinity();  // the end of the one before
  std::optional<Stretch> open = {};                                // in conflict at that instant
  // Windows that end until then have been walked in another step.
  double walked_before = -std::numeric_limits<double>::infinity();
};

class PairWalk {
 public:
  using Stretch = motion::Stretch;
  using State = WalkState;

  // Live, the first fix of a segment is an instant by itself before it is the beginning of a piece,
  // so that events do not depend on when the second one came.
  PairWalk(const TrackSegment& first, const TrackSegment& second, const WalkSeparation& separation,
           bool live = false)
      : first_(first),
        second_(second),
        separation_(separation),
        reach_m_(separation.outer.reach_m()),
        live_(live) {}

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

  const TrackSegment& first_;
  const TrackSegment& second_;
  const WalkSeparation& separation_;
  double reach_m_;
  bool live_;
};

template <class Ended, class GoingOn>
void PairWalk::walk(const TimeSpan& time, State& state, Ended&& ended, GoingOn&& going_on) const {
  while (state.first_piece < first_.pieces() && state.second_piece < second_.pieces()) {
    const Piece first = piece_of(first_, state.first_piece);
    const Piece second = piece_of(second_, state.second_piece);
    const TimeSpan window{std::max(first.from.time_s, second.from.time_s),
                          std::min(first.to.time_s, second.to.time_s)};
    if (window.begins_s > time.ends_s) return;
    if (window.begins_s <= window.ends_s && window.ends_s >= time.begins_s &&
        window.ends_s > state.walked_before) {
      const auto walk_now = [&](const TimeSpan& now) {
        const std::optional<Stretch> over = walk_window(first, second, now, state);
        if (over) ended(*over);
        if (state.open) going_on(std::as_const(*state.open));
      };
      const bool begins = (state.first_piece == 0 && first.from.time_s == window.begins_s) ||
                          (state.second_piece == 0 && second.from.time_s == window.begins_s);
      if (live_ && begins && !state.open) walk_now({window.begins_s, window.begins_s});
      if (!live_ || !begins || window.ends_s > window.begins_s) walk_now(window);
    }
    const bool first_goes_on = first.to.time_s <= window.ends_s && !first_.waits();
    const bool second_goes_on = second.to.time_s <= window.ends_s && !second_.waits();
    if (!first_goes_on && !second_goes_on) return;  // as far as is known
    if (first_goes_on) ++state.first_piece;
    if (second_goes_on) ++state.second_piece;
  }
  const bool over = (state.first_piece >= first_.pieces() && first_.complete) ||
                    (state.second_piece >= second_.pieces() && second_.complete);
  if (!over || !state.open) return;
  state.open->cut_off = true;
  ended(*std::exchange(state.open, std::nullopt));
}

}  // namespace beespace::motion
