// Degrees or metres? Decided from what names say and what the values allow, or not at all.
//
// The values speak over the whole input: beyond +-360 (first) or +-90 (second coordinate) they are
// no degrees; a swarm that would be an absurd pillar far from the origin if it were in metres is
// in degrees. Everything between is refused: nothing is guessed.
#pragma once

#include "io/load_points.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <limits>
#include <span>
#include <string>

namespace beespace::io {

// The smallest box around points, axis by axis.
struct Extent {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Point lowest = {kInfinity, kInfinity, kInfinity};
  Point highest = {-kInfinity, -kInfinity, -kInfinity};

  void include(const Extent& other);
};

Extent extent_of(std::span<const Point> points);

struct FrameEvidence {
  Frame frame = Frame::kAuto;  // kAuto: names say nothing
  std::string reason = {};
};

struct FrameDecision {
  Frame frame = Frame::kMetres;
  std::string reason = {};
};

// What can be decided before any value is seen: `asked`, then `evidence`; kAuto when neither says.
FrameDecision frame_before_values(Frame asked, const FrameEvidence& evidence);

// By the values alone. Errors: kUnknownFrame, with the index of the first point that fits badly in
// place.record where there is one.
Result<FrameDecision> frame_from_values(std::span<const Point> points, const Extent& extent);

}  // namespace beespace::io
