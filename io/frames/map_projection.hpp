// From metres north and east of a place to longitude and latitude, as PX4 does.
#pragma once

namespace beespace::io {

struct LongitudeLatitude {
  double longitude_deg = 0.0;
  double latitude_deg = 0.0;
};

// PX4 counts metres in an azimuthal equidistant projection of a sphere, so this is what its own
// longitude and latitude are made by; on the ellipsoid the metres would be up to 0.3 % others.
LongitudeLatitude px4_reprojected(const LongitudeLatitude& reference, double north_m,
                                  double east_m);

}  // namespace beespace::io
