#include "analysis/scene/placed_tracks.hpp"

#include "analysis/scene/place_on_earth.hpp"
#include "report/earth_frame.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>

#include <cmath>
#include <variant>

namespace beespace::analysis {
namespace {

bool can_be_placed(const Point& place) {
  return std::abs(place.x) <= kFarthestPlaced_m && std::abs(place.y) <= kFarthestPlaced_m &&
         place.z >= kLowestHeight_m && place.z <= kGreatestHeight_m;
}

}  // namespace

report::Placement placement_of(const io::ShowPlace& place) {
  return {{place.longitude_deg, place.latitude_deg, place.height_m.value_or(0.0)},
          place.heading_deg,
          place.y_to_the_right,
          place.height_m ? ", as the show says, whose heights are above mean sea level"
                         : ", as the show says, which gives no height: heights are "
                           "those above the place of take-off",
          place.height_m.has_value(),
          place.height_m.has_value()};
}

Status place_tracks(std::vector<Track>& tracks, const report::Placement& placement) {
  if (const auto ecef = to_ecef(placement.origin); !ecef) return ecef.error();
  const report::PlacementAxes axes(placement);
  const report::EarthFrame frame(placement.origin);
  for (Track& track : tracks) {
    for (Fix& fix : track.fixes) {
      const Point place = axes(fix.position);
      const auto ecef = can_be_placed(place) ? to_ecef(frame.position_of(place))
                                             : Result<Point>(Error{ErrorCode::kOutsideDomain});
      if (!ecef) {
        return Error{ErrorCode::kOutsideDomain,
                     "a place is farther than 100 km from the origin, or no height that there is; "
                     "positions that are set down on the Earth must be metres around --origin",
                     {}};
      }
      fix.position = *ecef;
    }
  }
  return std::monostate{};
}

}  // namespace beespace::analysis
