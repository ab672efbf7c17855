// Whether a frame is crowded enough for searches that take whole boxes of points at once, or whole
// rows of pairs.
#pragma once

#include "search/choices.hpp"
#include "search/frame.hpp"

#include <algorithm>

namespace beespace::search {

// Whether a cube of the threshold holds more than `enough` others, seen from a point's place.
inline bool is_crowded(const Frame& frame, double threshold_m, double enough,
                       const Choices& choices) {
  if (frame.points().empty() || frame.others().empty()) return false;
  if (choices.crowds != Choices::Crowds::kAutomatic) {
    return choices.crowds == Choices::Crowds::kAlways;
  }
  return frame.mates(threshold_m) > enough;
}

// Whether points share their places so often that it pays to look at each place once.
inline bool has_duplicates(const Frame& frame, double threshold_m) {
  constexpr double kTwinCells = 0x1p-40;  // of all that matters: so close are only twins
  const double widest = frame.widest() > 0.0 ? frame.widest() : threshold_m;
  return frame.mates(std::min(widest, threshold_m) * kTwinCells) > 1.0;
}

}  // namespace beespace::search
