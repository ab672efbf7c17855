// Whether a bee goes from one fix to the next as its own velocities say, as it does elsewhere in
// its track: where a step leads much farther away than they do, a place before it was wrong, as of
// a filter that has lost its satellites and finds them again.
//
// It is asked only of those whose velocities lead to the next place as a rule: they may be along
// other axes, in another unit, or too coarse for their places. What is faster than kFastest_mps has
// old places and coarse speeds (stated_rates.hpp).
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/mover.hpp>
#include <beespace/track.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::io {

// Of some lengths: what nearly all of them are shorter than, within a fifth.
class NearlyAll {
 public:
  void take(double length);
  [[nodiscard]] double least_bound() const;  // of 95 in 100; 0 of none

 private:
  static constexpr std::size_t kOfAnOctave = 4;
  static constexpr int kOctaves = 40;  // from 2^-20 to 2^20

  std::array<std::uint32_t, kOfAnOctave * kOctaves> counts_{};
  std::uint32_t count_ = 0;
};

class OwnMotion {
 public:
  static constexpr double kFastest_mps = 60.0;

  // A step between two fixes, the earlier one first; of velocities not-a-numbers are not known, and
  // null where none is.
  void take(const Fix& from, const Velocity* from_velocity, const Fix& to,
            const Velocity* to_velocity, Frame frame);
  // By all that was taken; of a track that is known as a whole that step may be one of these.
  [[nodiscard]] bool contradicted_by(const Fix& from, const Velocity* from_velocity, const Fix& to,
                                     const Velocity* to_velocity, Frame frame) const;

 private:
  std::uint64_t moving_ = 0;  // steps in which it says that it moves
  std::uint64_t agreed_ = 0;  // of these: it gets where that leads
  double fastest_mps_ = 0.0;  // as it says
  NearlyAll speeds_mps_;      // as it moves
  NearlyAll off_m_;           // from where its velocities lead
};

}  // namespace beespace::io
