#include "analysis/recorded/scale_doubt.hpp"

#include "io/bytes/number_text.hpp"
#include "io/units/unit_taken.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace beespace::analysis {
namespace {

// Millimetres are not looked for in a wider place: 20 m for one.
constexpr double kWidest = 20'000.0;

// How far it is across, from the least to the greatest coordinates.
double spread_m(const io::Recording& recording) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Point least{kFar, kFar, kFar};
  Point greatest{-kFar, -kFar, -kFar};
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) {
      const Point& at = fix.position;
      least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
      greatest = {std::max(greatest.x, at.x), std::max(greatest.y, at.y),
                  std::max(greatest.z, at.z)};
    }
  }
  return std::hypot(greatest.x - least.x, greatest.y - least.y, greatest.z - least.z);
}

}  // namespace

std::optional<Error> doubt_of_scale(const io::Recording& recording,
                                    const std::optional<io::StatedLength>& threshold) {
  const bool small = threshold && (threshold->unit == io::Unit::kMillimetre ||
                                   threshold->unit == io::Unit::kMicrometre);
  const bool silent =
      std::any_of(recording.units.begin(), recording.units.end(), [](const io::UnitTaken& taken) {
        return taken.of.starts_with('x') && taken.evidence == io::UnitEvidence::kUsual;
      });
  if (!small || !silent || recording.frame != io::Frame::kMetres) return std::nullopt;
  const double wide_m = spread_m(recording);
  if (!std::isfinite(wide_m) || !(wide_m > kWidest * threshold->metric)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "are x and y in metres? Nothing names their unit, and they would go " +
                   io::grouped(wide_m, 0) + " m far, " +
                   io::grouped(wide_m / threshold->metric, 0) + " times the threshold of " +
                   io::text_of(*threshold) +
                   "; if they are pixels, say how long one is, as in --scale 0.1mm, otherwise "
                   "--units position=mm, or position=m if they are in metres",
               {}};
}

}  // namespace beespace::analysis
