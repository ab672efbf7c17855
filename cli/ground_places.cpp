#include "cli/ground_places.hpp"

#include <beespace/geodesy.hpp>

#include <numeric>
#include <utility>

namespace beespace::cli {

GroundPlaces ground_places(const io::LoadedPoints& loaded, bool vertical) {
  GroundPlaces places;
  if (!vertical || loaded.frame != io::Frame::kWgs84) return places;
  std::vector<PointId> everybody(loaded.points.size());
  std::iota(everybody.begin(), everybody.end(), PointId{0});
  io::for_each_record(loaded, everybody, [&](const io::Record& record) {
    GeographicPosition place = record.geographic;
    places.heights_m.push_back(std::exchange(place.height_m, 0.0));
    places.ground.push_back(*to_ecef(place));  // was read before, so it is valid
  });
  return places;
}

}  // namespace beespace::cli
