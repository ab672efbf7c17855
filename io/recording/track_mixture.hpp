// Whether a track is that of several vehicles that report at rates of their own: whether a few
// smooth tracks, well apart, explain it, among which it goes to and fro.
//
// At a scale G each place is given to the nearest of up to kMostHeads tracks, at least G apart: it
// goes on with one if it is within G / 4 of where that one is by now, and is a stray one otherwise.
// Noise of whatever size fills the plane between tracks: at most a half of what jumps (a quarter
// where it does so to all sides) lands on one of them. Of several vehicles all do. Single places
// that are wrong are stray themselves, and as many as what jumps back. What is looked at is the
// last kWindow places with kFewestTurns turns among them that would take more than
// `impossible_mps2` (so that what is reported seldom may go to and fro as it likes), at
// some scales about the typical length of their jumps. Places that are rounded jump, too: a scale
// is some times as large as the least step between places, unless it is larger than what rounds at
// such rates. Heights, which are often rounded, are left out of account.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/track.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::io {

class TrackMixture {
 public:
  static constexpr std::size_t kWindow = 256;
  static constexpr std::size_t kFewestTurns = 16;
  static constexpr std::size_t kMostHeads = 8;

  explicit TrackMixture(double impossible_mps2) : impossible_mps2_(impossible_mps2) {}

  // Fixes in the order of time, no two at one time, with their number; the number of the first one
  // of those that have shown that they are of several.
  std::optional<std::uint64_t> take(const Fix& fix, std::uint64_t number, Frame frame);

  struct Place {  // in metres from the first one
    double time_s;
    double x;
    double y;
    std::uint64_t number;
    bool turns;  // impossibly, at the one before
  };

 private:
  [[nodiscard]] bool is_of_several() const;

  double impossible_mps2_;
  std::optional<Fix> origin_ = {};
  Place before_ = {};
  Place last_ = {};
  std::uint64_t taken_ = 0;
  std::uint64_t last_turn_ = 0;     // as counted in taken_
  std::vector<Place> window_ = {};  // a ring once it is full; empty where nothing turns
  std::size_t next_ = 0;
};

}  // namespace beespace::io
