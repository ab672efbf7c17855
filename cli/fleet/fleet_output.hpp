// What `beespace fleet` answers: a row for each bee, and in JSON the figures of all.
#pragma once

#include "analysis/recorded/tracking_figures.hpp"
#include "cli/fleet/set_beside_flown.hpp"
#include "cli/output/rows.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::cli {

struct FleetAnswer {
  const SetBesideFlown& both;
  const analysis::TrackingFigures& figures;
  const io::Recording& flown;  // whose clock times are of
  const io::Recording& set;
  std::optional<double> max_deviation_m = {};
};

// Of the bees that were compared: which one strayed farthest; which strayed farther than
// max_deviation_m, where that is given.
std::optional<std::size_t> farthest_bee(const FleetAnswer& answer);
std::vector<std::size_t> bees_too_far(const FleetAnswer& answer);

// For how long it is not known how far they strayed: of one, and of all together.
double unknown_s(const FleetAnswer& answer, std::size_t bee);
double unknown_s(const FleetAnswer& answer);
// Whether it is known all the time, of all that were set or flown.
bool is_known(const FleetAnswer& answer);

// id, set_id, farthest_m, farthest_s, mean_m, p95_m, fixes, unknown_s; those that were set or flown
// alone come last.
Rows fleet_rows(const FleetAnswer& answer);

// The members of the JSON document but for those rows.
void write_figures(io::JsonWriter& json, const FleetAnswer& answer);

// Rounded up to the millimetre: it is a bound.
double up_to_mm(double value);

}  // namespace beespace::cli
