#include "report/map/map_places.hpp"

#include "io/bytes/number_text.hpp"

#include <cmath>

namespace beespace::report {

GeographicPosition MapPlaces::of(const Point& place) const {
  const auto rounded = [](double value, double steps) {
    return std::round(value * steps) / steps + 0.0;  // and no -0
  };
  const GeographicPosition exact = frame_.position_of(place);
  return {rounded(exact.longitude_deg, 1e9), rounded(exact.latitude_deg, 1e9),
          rounded(exact.height_m, 1e4)};
}

Point middle_of(const Point& a, const Point& b) {
  return {0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (a.z + b.z)};
}

std::string place_text(const GeographicPosition& position, char separator) {
  return io::exact(position.longitude_deg) + separator + io::exact(position.latitude_deg) +
         separator + io::exact(position.height_m);
}

}  // namespace beespace::report
