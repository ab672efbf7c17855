// What pages, pictures and map files are asked for: the separation that counts, and how to read.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/units/stated_length.hpp"
#include "io/units/units.hpp"

#include <beespace/geodesy.hpp>

#include <optional>
#include <stop_token>
#include <string>

namespace beespace::analysis {

// Where neither the caller nor the input says what is too close.
inline constexpr double kDefaultThreshold_m = 100.0;

struct SceneRequest {
  io::RecordingOptions load = {};
  std::optional<double> threshold_m = {};         // absent: what the input declares, or the default
  io::Unit threshold_unit = io::Unit::kUnstated;  // in which it is stated, for words
  bool threshold_is_bare = false;                 // without a unit
  // In the unit in which it is stated, so that heights in that unit can be compared as they stand.
  std::optional<io::StatedLength> vertical = {};
  bool inclusive = false;
  std::optional<double> ignore_below_m = {};  // see analysis/recorded/low_conflicts.hpp
  std::optional<double> max_gap_s = {};       // absent: from the data
  double tolerance_m = 0.001;                 // of curves that become straight lines
  std::optional<double> horizon_s = {};       // of one moment; absent: as usual of what it is of
  unsigned threads = 0;                       // 0: all
  std::stop_token stop = {};                  // ends the search, not the reading before it
  // Where east, north and up of geographic positions are 0; otherwise below the middle of all.
  std::optional<GeographicPosition> origin = {};

  // What a planner said of the fleet that is seen, a file (io/fleet/fleet_log.hpp); empty: nothing.
  std::string fleet_log = {};

  [[nodiscard]] std::optional<double> vertical_m() const {
    return vertical ? std::optional(vertical->metric) : std::nullopt;
  }
};

// As it was stated; nothing where the caller does not say it.
inline std::optional<io::StatedLength> typed_threshold(const SceneRequest& request) {
  if (!request.threshold_m) return std::nullopt;
  return io::StatedLength{*request.threshold_m,
                          io::from_metric(*request.threshold_m, request.threshold_unit),
                          request.threshold_unit, request.threshold_is_bare};
}

}  // namespace beespace::analysis
