// What is too close where the command does not say: what the input declares, or what is usual.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/points/loaded_points.hpp"
#include "io/recording/recording.hpp"
#include "io/units/heights.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/units.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::analysis {

// Drones of shows fly some metres apart: a default for aircraft would find nothing but conflicts.
inline constexpr double kDefaultShowThreshold_m = 2.0;

// Of what drones logged, whatever is asked about it: more than a show needs, as they are elsewhere
// by some metres than they say.
inline constexpr double kDefaultDroneThreshold_m = 5.0;

struct DefaultThreshold {
  double metres;
  // ", as the input declares"; empty where it is `otherwise_m`.
  std::string_view words;
};

DefaultThreshold default_threshold(const io::Recording& recording, double otherwise_m);

// Of air traffic nothing else is usual than what its rules say, and these are of several kinds:
// what to type where nothing was, or a bare number that is less than any of them, as one of miles
// that would be taken for metres. Nothing for what is no air traffic, as far as is known: by its
// format, by what columns are called, by units, or as nothing else is so high and so fast. Likewise
// of a bare vertical threshold that is a usual one in feet, and none in metres.
std::optional<Error> threshold_needed(
    const io::Recording& recording, const std::optional<io::StatedLength>& typed,
    const std::optional<io::StatedLength>& vertical = std::nullopt);
std::optional<Error> threshold_needed(
    const io::LoadedPoints& points, const std::optional<io::StatedLength>& typed,
    const std::optional<io::StatedLength>& vertical = std::nullopt);
// The same of points of which the header is known, but perhaps no record is in memory.
std::optional<Error> threshold_needed(
    const io::LoadedPoints& points, std::string_view header,
    const std::optional<io::StatedLength>& typed,
    const std::optional<io::StatedLength>& vertical = std::nullopt);

// What tells of air traffic where reports come one by one.
struct TrafficSigns {
  io::Frame frame;
  io::Unit height_unit;
  io::HeightDatum heights;
  bool of_aircraft;  // its format or its columns say so
};
std::optional<Error> threshold_needed(
    const TrafficSigns& signs, const std::optional<io::StatedLength>& typed,
    const std::optional<io::StatedLength>& vertical = std::nullopt);

}  // namespace beespace::analysis
