// What distances are taken of, and positions, velocities and heights of an input in the units of
// the library: metres in one Cartesian frame.
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace beespace::analysis {

// What distances are taken of: positions in space; or, for a vertical threshold between geographic
// positions, those on the ground, and heights apart from them. Where the threshold and the heights
// can be compared exactly in another unit than the metre (io::compared_in), these are heights in
// it.
enum class Geometry : std::uint8_t { kSpace, kGroundAndHeight, kGroundAndStatedHeight };
Geometry geometry_for(io::Frame frame, io::Unit height_unit,
                      const std::optional<io::StatedLength>& vertical);
Geometry geometry_for(const io::Recording& recording,
                      const std::optional<io::StatedLength>& vertical);

[[nodiscard]] inline bool heights_apart(Geometry geometry) {
  return geometry != Geometry::kSpace;
}

// The vertical threshold for that geometry, and how many metres the unit of its heights is.
std::optional<double> vertical_in(Geometry geometry,
                                  const std::optional<io::StatedLength>& vertical,
                                  io::Unit height_unit);
double height_unit_m(Geometry geometry, io::Unit height_unit);

// A height as the input states it.
struct StatedHeight {
  double value = 0.0;
  io::Unit unit = io::Unit::kMetre;
};

// The height of a fix.
StatedHeight stated_height(const io::Recording& recording, const io::RecordedBee& bee,
                           std::size_t fix);

// Whether it has no number that stands for an unknown one.
bool is_known(const Velocity& velocity);

// A position of the input in the units and the frame of the library; heights that are apart in the
// unit that the geometry compares.
struct InMetres {
  Point position;
  std::optional<Velocity> velocity;  // where the input knows it
  double height_m = 0.0;
  double climb_mps = 0.0;
};
Result<InMetres> in_metres(const Point& position, const std::optional<Velocity>& velocity,
                           io::Frame frame, Geometry geometry, const StatedHeight& stated = {});

// That of a fix.
Result<InMetres> in_metres(const io::Recording& recording, std::size_t bee, std::size_t fix,
                           Geometry geometry);

// What is computed may be too small for the motion domain; its difference to 0 cannot be seen.
double flushed(double value);

}  // namespace beespace::analysis
