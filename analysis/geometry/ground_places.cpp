#include "analysis/geometry/ground_places.hpp"

#include <beespace/geodesy.hpp>

#include <numeric>

namespace beespace::analysis {

GroundPlaces ground_places(const io::LoadedPoints& loaded,
                           const std::optional<io::StatedLength>& vertical, io::Unit height_unit) {
  GroundPlaces places;
  if (!vertical) return places;
  const bool as_stated = compares_as_stated(vertical, height_unit);
  const bool geographic = loaded.frame == io::Frame::kWgs84;
  places.vertical_m = as_stated ? exactly_in(*vertical, height_unit) : vertical->metric;
  if (!as_stated && !geographic) return places;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    places.heights_m.push_back(as_stated ? record.height : record.geographic.height_m);
    if (!geographic) {
      const Point& point = loaded.points[record.point];
      places.ground.push_back({point.x, point.y, 0.0});
      return;
    }
    GeographicPosition place = record.geographic;
    place.height_m = 0.0;
    places.ground.push_back(*to_ecef(place));  // was read before, so it is valid
  });
  return places;
}

}  // namespace beespace::analysis
