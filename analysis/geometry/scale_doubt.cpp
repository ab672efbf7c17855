#include "analysis/geometry/scale_doubt.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace beespace::analysis {
namespace {

// Millimetres are not looked for in a wider place: 20 m for one.
constexpr double kWidest = 20'000.0;

}  // namespace

bool may_be_pixels(const std::vector<io::UnitTaken>& units, io::Frame frame,
                   const std::optional<io::StatedLength>& threshold) {
  const bool small = threshold && (threshold->unit == io::Unit::kMillimetre ||
                                   threshold->unit == io::Unit::kMicrometre);
  return small && frame == io::Frame::kMetres &&
         std::any_of(units.begin(), units.end(), [](const io::UnitTaken& taken) {
           return taken.of.starts_with('x') && taken.evidence == io::UnitEvidence::kUsual;
         });
}

void Spread::add(const Point& place) {
  least_ = {std::min(least_.x, place.x), std::min(least_.y, place.y), std::min(least_.z, place.z)};
  greatest_ = {std::max(greatest_.x, place.x), std::max(greatest_.y, place.y),
               std::max(greatest_.z, place.z)};
}

double Spread::metres() const {
  return std::hypot(greatest_.x - least_.x, greatest_.y - least_.y, greatest_.z - least_.z);
}

std::optional<Error> doubt_of_scale(const io::Recording& recording,
                                    const std::optional<io::StatedLength>& threshold) {
  if (!may_be_pixels(recording.units, recording.frame, threshold)) return std::nullopt;
  Spread spread;
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) spread.add(fix.position);
  }
  return doubt_of_scale(recording.units, recording.frame, spread, threshold, kWithScale);
}

std::optional<Error> doubt_of_scale(const io::LoadedPoints& points,
                                    const std::optional<io::StatedLength>& threshold) {
  if (!may_be_pixels(points.units, points.frame, threshold)) return std::nullopt;
  Spread spread;
  for (const Point& place : points.points) spread.add(place);
  return doubt_of_scale(points.units, points.frame, spread, threshold, kWithoutScale);
}

std::optional<Error> doubt_of_scale(const std::vector<io::UnitTaken>& units, io::Frame frame,
                                    const Spread& spread,
                                    const std::optional<io::StatedLength>& threshold,
                                    std::string_view if_pixels) {
  if (!may_be_pixels(units, frame, threshold)) return std::nullopt;
  const double wide_m = spread.metres();
  if (!std::isfinite(wide_m) || !(wide_m > kWidest * threshold->metric)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "are x and y in metres? Nothing names their unit, and they would go " +
                   io::grouped(wide_m, 0) + " m far, " +
                   io::grouped(wide_m / threshold->metric, 0) + " times the threshold of " +
                   io::text_of(*threshold) + "; if they are pixels, " + std::string(if_pixels) +
                   ", otherwise say --units position=mm, or position=m if they are in metres",
               {}};
}

}  // namespace beespace::analysis
