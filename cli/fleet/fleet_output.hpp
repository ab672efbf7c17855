// What `beespace fleet` says: the figures, and who strayed farthest.
#pragma once

#include "analysis/recorded/tracking_figures.hpp"
#include "cli/fleet/set_beside_flown.hpp"
#include "io/recording/recording.hpp"

#include <string>

namespace beespace::cli {

struct FleetAnswer {
  const SetBesideFlown& both;
  const analysis::TrackingFigures& figures;
  const io::Recording& flown;  // whose clock times are of
};

std::string fleet_text(const FleetAnswer& answer);
std::string fleet_json(const FleetAnswer& answer);

}  // namespace beespace::cli
