// Degrees or metres? Decided from what names say and what the values allow, or not at all.
//
// The values speak over the whole input: beyond +-360 (first) or +-90 (second coordinate) they are
// no degrees, and no two columns may look like degrees beside that. They are in degrees when they
// would be an absurd pillar far from the origin in metres, but which column is the longitude they
// show only beyond +-90. Everything between is refused: nothing is guessed.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
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

// What the names of the columns tell of the position.
enum class Naming : std::uint8_t {
  kNone,      // nothing: the columns were taken in their order
  kAxes,      // which are x, y and z, but not whether these are metres
  kBareAxes,  // x, y and z and nothing else: metres, unless the values contradict
  kSure,      // everything
};

struct FrameDecision {
  Frame frame = Frame::kMetres;
  std::string reason = {};
  std::string note = {};  // what was decided beyond the frame; empty when nothing was
};

// What can be decided before any value is seen: `asked`, then `evidence`; kAuto when neither says.
FrameDecision frame_before_values(Frame asked, const FrameEvidence& evidence);

// By the values; `dimensions` coordinates of each point were read. Errors: kUnknownFrame, with the
// index of the first point that fits badly in location.record where there is one.
Result<FrameDecision> frame_from_values(std::span<const Point> points, const Extent& extent,
                                        std::size_t dimensions, Naming naming);

// Why points under bare x, y and z may be degrees after all: kUnknownFrame.
std::optional<Error> contradiction_to_metres(std::span<const Point> points, const Extent& extent,
                                             std::size_t dimensions);

}  // namespace beespace::io
