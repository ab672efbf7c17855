// Whether a bee jumps: whether it is farther from one fix to the next than anything flies, so that
// one of the two places is wrong, or its time is.
//
// Nothing that flies below space is faster than kMostSpeed_mps. Who tells a speed flies at
// kTimesOwnSpeed times that, and kBesideOwnSpeed_mps, at most; of who tells none that
// is the speed that nearly all steps of its track keep, or where these are not known yet, the
// fastest of those before that was no jump. Times may be rounded, or be
// those of arrival, by kTimesDiffer_s. On the Earth it goes about as its velocities say
// (stated_rates.hpp), and what is slow goes as they say elsewhere in its track (own_motion.hpp).
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/own_motion.hpp"

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::io {

class Jumps {
 public:
  // Judged by what came before.
  Jumps() = default;
  // By all of a track: its fixes in the order of time, and their velocities, or none.
  Jumps(const std::vector<Fix>& fixes, const std::vector<Velocity>& velocities, Frame frame);

  static constexpr double kMostSpeed_mps = 1'500.0;
  static constexpr double kTimesOwnSpeed = 10.0;
  static constexpr double kBesideOwnSpeed_mps = 100.0;
  static constexpr double kTimesDiffer_s = 0.5;

  // Fixes in the order of time, each with a velocity or none, which may have not-a-numbers; whether
  // the bee jumps to this one. One that goes back in time is the first of those to come.
  bool take(const Fix& fix, const Velocity* velocity, Frame frame = Frame::kMetres);
  // The same, without taking it; false before the first one.
  [[nodiscard]] bool jumps_to(const Fix& fix, const Velocity* velocity, Frame frame) const;

 private:
  [[nodiscard]] double most_speed_mps(const Velocity* before, const Velocity* now) const;

  OwnMotion own_;
  // Of who tells no speed: of nearly all steps of a whole track, or the fastest one before.
  double usual_mps_ = 0.0;
  std::size_t steps_ = 0;
  bool is_whole_ = false;  // all is in there
  std::optional<Fix> last_ = {};
  std::optional<Velocity> velocity_ = {};  // of the last one
};

}  // namespace beespace::io
