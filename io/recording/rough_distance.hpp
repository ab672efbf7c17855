// How far two places are apart, about: what counts is a factor.
#pragma once

#include "io/frames/coordinate_frame.hpp"

#include <beespace/point.hpp>

namespace beespace::io {

// In metres; of degrees as if the Earth were flat there.
double rough_distance_m(const Point& a, const Point& b, Frame frame);

}  // namespace beespace::io
