// Where on the Earth, for map files: longitudes and latitudes of what facts have in metres.
#pragma once

#include "report/earth_frame.hpp"
#include "report/facts.hpp"

#include <beespace/geodesy.hpp>

#include <string>

namespace beespace::report {

class MapPlaces {
 public:
  // The swarm has an origin.
  explicit MapPlaces(const SwarmFacts& swarm) : frame_(*swarm.origin) {}

  // Rounded to a tenth of a millimetre, so that numbers are as short as they were.
  [[nodiscard]] GeographicPosition of(const Point& place) const;

 private:
  EarthFrame frame_;
};

Point middle_of(const Point& a, const Point& b);

// "-75.5,6.25,1500", with any separator.
std::string place_text(const GeographicPosition& position, char separator);

}  // namespace beespace::report
