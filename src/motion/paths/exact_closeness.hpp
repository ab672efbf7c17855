// Whether two pieces of curves are closer than a threshold at some instant, without rounding.
#pragma once

#include "motion/bezier_curve.hpp"

#include <beespace/conflict.hpp>

namespace beespace::motion {

// `window` lies within the time of both. Decides signs of a polynomial in time, the squared
// distance less the squared threshold, in Bernstein's form with numbers of any length. Where the
// two touch the threshold at an instant that halving does not hit, which straight lines may, and
// curves are not told from being closer: then they count as closer.
bool closer_exactly(const BezierCurve& first, const BezierCurve& second, const TimeSpan& window,
                    double threshold_m);

}  // namespace beespace::motion
