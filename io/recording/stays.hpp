// Fixes of a bee, one after the other, at exactly one place, bit by bit; and how it goes on from
// there.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>

namespace beespace::io {

struct Stay {
  Fix since = {};  // its first fix
  double until_s = 0.0;
  std::size_t fixes = 0;
  bool stands = false;  // as one of them says
  // How far its own velocities say that it moved over ground meanwhile.
  double east_m = 0.0;
  double north_m = 0.0;

  [[nodiscard]] double lasted_s() const { return until_s - since.time_s; }
  // Whether there are so many fixes, for so long, that the place may have been said again and again
  // though the bee had left it. Shorter repetitions are bridged by a straight line, as missing
  // records are.
  [[nodiscard]] bool is_long() const;
  // What says that it stands does, but where its own velocities cannot have led it on from there.
  [[nodiscard]] bool may_be_frozen() const { return !stands && is_long(); }
};

// A stay that is over, and the step from its last fix to the next place.
struct LeftStay {
  Stay stay;
  double metres;
  double seconds;
};

class Stays {
 public:
  // Fixes in the order of time, each with a velocity or none; one that goes back in time counts for
  // nothing. The stay that is over with this one, if one is.
  std::optional<LeftStay> take(const Fix& fix, const Velocity* velocity, Frame frame);
  // The one that goes on; nothing before the first fix.
  [[nodiscard]] const std::optional<Stay>& current() const { return current_; }

 private:
  std::optional<Stay> current_ = {};
  Velocity velocity_ = {0.0, 0.0, 0.0};  // of its last fix; 0 where none is known
};

}  // namespace beespace::io
