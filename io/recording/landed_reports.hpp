// Which places of a drone are on the ground, by what its autopilot says beside them now and then:
// that it has landed, or not. Where it does not say so surely, it is taken for flying.
//
// A place is on the ground where the report before it and the one behind it both say so, and these
// are no more than 5 s apart. Up to 5 s before the first report and behind the last one it is as
// these say where it is the same place, within a metre. Who says at a place to be faster than a
// drone on the ground flies.
//
// Of what is less sure, as that motors are off, a stretch counts as a whole or not at all: where a
// drone goes anywhere while it says so throughout, it is not on the ground before, or after that,
// either. And it counts only of a drone that has ever said that it is not so, or that says all the
// while how high it is above where it took off.
//
// A flag may be stuck. So a stretch of such places counts only where it stays within 2 m of where
// it begins or ends, is no more than that above its own lowest place, and at about the height at
// which the drone is on the ground as its log begins or ends: where all of that is not so it flies.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::io {

// Of what a vehicle is by its own word (MAV_TYPE of MAVLink): whether it drives or swims. Nothing
// says where the ground is beneath it, and it says that it has landed while it goes on.
inline bool never_lands(double mav_type) {
  constexpr double kRover = 10.0;  // behind it boats and submarines
  constexpr double kSubmarine = 12.0;
  return mav_type >= kRover && mav_type <= kSubmarine;
}

// Likewise, whether it stays on the ground or on the water: of two of these it says little that one
// is above the other.
inline bool stays_on_surface(double mav_type) {
  constexpr double kRover = 10.0;
  constexpr double kBoat = 11.0;
  return mav_type == kRover || mav_type == kBoat;
}

class LandedReports {
 public:
  struct Place {
    std::int64_t micros = 0;  // by the clock of the reports
    Point position = {};
    Velocity velocity = {};  // not-a-number where unknown
    // Above where it took off, by its own word; not-a-number where it does not say.
    double above_home_m = std::numeric_limits<double>::quiet_NaN();
  };

  // In the order in which they came; `sure` is not what only hints at it.
  void take(std::int64_t micros, bool landed, bool sure = true);
  // Whether it has ever said so.
  [[nodiscard]] bool any_landed() const;

  // One for each of the places, which are in the order in which they came.
  [[nodiscard]] std::vector<bool> on_ground(const std::vector<Place>& places, Frame frame) const;

 private:
  struct Report {
    std::int64_t micros;
    bool landed;
    bool sure;
  };
  enum class Word : std::uint8_t { kFlies, kHints, kSure };

  [[nodiscard]] Word word_at(std::int64_t micros) const;
  void doubt_hints(const std::vector<Place>& places, std::vector<bool>& ground) const;
  void add_before_first(const std::vector<Place>& places, Frame frame,
                        std::vector<bool>& ground) const;
  void add_behind_last(const std::vector<Place>& places, Frame frame,
                       std::vector<bool>& ground) const;

  std::vector<Report> reports_;
  bool goes_back_ = false;  // the clock does: then nothing is sure
};

}  // namespace beespace::io
