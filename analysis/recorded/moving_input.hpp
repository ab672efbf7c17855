// From what was recorded to what the library searches: metres in one Cartesian frame, as tracks or
// as movers at one instant.
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::analysis {

// What distances are taken of: positions in space; or, for a vertical threshold between geographic
// positions, those on the ground, and heights apart from them. Of a threshold in the unit of the
// heights, where that is not the metre, these are heights as they are stated.
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
                                  const std::optional<io::StatedLength>& vertical);
double height_unit_m(Geometry geometry, io::Unit height_unit);

// A height as the input states it.
struct StatedHeight {
  double value = 0.0;
  io::Unit unit = io::Unit::kMetre;
};

// One track for each bee. Curves become straight lines within the tolerance.
Result<std::vector<Track>> tracks_of(const io::Recording& recording, Geometry geometry,
                                     double tolerance_m);

// A report of the input, in the units of the library and the frame of tracks_of; heights that are
// apart in the unit that the geometry compares.
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

// Everybody at one instant, the last that the recording knows of. Whoever was last heard of before
// is brought there in a straight line; or left out when that is more than max_age_s ago.
struct Snapshot {
  std::vector<Mover> movers;
  std::vector<double> heights_m;  // empty, or of each mover, kept apart from its position: in the
                                  // unit that the geometry compares, as climb rates are
  std::vector<double> climbs_mps;
  std::vector<std::uint32_t> bees;  // whose each mover is: ascending places in the recording
  double time_s = 0.0;
  std::uint64_t brought_forward = 0;
  double oldest_s = 0.0;    // of those: how far
  std::uint64_t stale = 0;  // left out
  // Of these neither a velocity nor two fixes, max_age_s apart at most, tell how fast they go: they
  // are no movers, and known only where they were last heard of.
  struct Placed {
    std::uint32_t bee = 0;
    Point position = {};
    double height_m = 0.0;  // apart, as above
  };
  std::vector<Placed> unmoving;
  std::uint64_t estimated = 0;  // velocities that come from the last two fixes

  [[nodiscard]] MoversView view() const;
  // The movers, and behind them the unmoving ones where they were last heard of: the present moment
  // as far as it is known, of which a search must not look ahead.
  [[nodiscard]] Snapshot present() const;
};

// Whether it matters how fast those go who need not be brought there.
enum class Wanted : std::uint8_t { kMotion, kPlaces };

// Errors: kMissingColumn where nobody has a velocity that is wanted, or two fixes to tell it from.
Result<Snapshot> snapshot_of(const io::Recording& recording, Geometry geometry, double max_age_s,
                             Wanted wanted);

}  // namespace beespace::analysis
