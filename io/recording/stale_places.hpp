// Places that are repeated though the bee has long left them: feeds say the last known place again
// and again once contact is lost, as OpenSky does, beside a speed that says that it moves.
#pragma once

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

namespace beespace::io {

class StalePlaces {
 public:
  // Records come more often than places, which are said again for a second or two; who stands has
  // a speed that wavers, too.
  static constexpr double kUsual_s = 3.0;
  static constexpr double kMoves_mps = 3.0;

  // Fixes in the order of time, each with a velocity or none, which may have not-a-numbers; whether
  // this one is at a place that the bee left more than kUsual_s before: exactly where it has been
  // since, though all that it said of its speed over ground meanwhile is more than kMoves_mps.
  bool take(const Fix& fix, const Velocity* velocity);

 private:
  bool moves_ = false;  // since
  Fix since_ = {};      // the first fix at that place
};

}  // namespace beespace::io
