#include "io/frames/map_projection.hpp"

#include <cmath>
#include <numbers>

namespace beespace::io {

LongitudeLatitude px4_reprojected(const LongitudeLatitude& reference, double north_m,
                                  double east_m) {
  constexpr double kRadius_m = 6'371'000.0;  // PX4's
  constexpr double kDegree = std::numbers::pi / 180.0;
  const double north = north_m / kRadius_m;
  const double east = east_m / kRadius_m;
  const double away = std::sqrt(north * north + east * east);
  if (!(away > 0.0)) return reference;
  const double latitude = reference.latitude_deg * kDegree;
  const double sine = std::sin(away);
  const double cosine = std::cos(away);
  LongitudeLatitude place;
  place.latitude_deg =
      std::asin(cosine * std::sin(latitude) + north * sine * std::cos(latitude) / away) / kDegree;
  place.longitude_deg =
      reference.longitude_deg + std::atan2(east * sine, away * std::cos(latitude) * cosine -
                                                            north * std::sin(latitude) * sine) /
                                    kDegree;
  if (place.longitude_deg > 180.0) place.longitude_deg -= 360.0;
  if (place.longitude_deg < -180.0) place.longitude_deg += 360.0;
  return place;
}

}  // namespace beespace::io
