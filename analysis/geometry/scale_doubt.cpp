#include "analysis/geometry/scale_doubt.hpp"

#include "io/bytes/number_text.hpp"
#include "io/recording/unit_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace beespace::analysis {
namespace {

// Places spread wider than so many thresholds are asked about even with --crs metres: 20 m for a
// millimetre.
constexpr double kWidest = 20'000.0;

bool is_small(io::Unit unit) {
  return unit == io::Unit::kCentimetre || unit == io::Unit::kMillimetre ||
         unit == io::Unit::kMicrometre;
}

}  // namespace

bool are_without_unit(const std::vector<io::UnitTaken>& units, io::Frame frame) {
  return frame == io::Frame::kMetres &&
         std::any_of(units.begin(), units.end(), [](const io::UnitTaken& taken) {
           return taken.of.starts_with('x') && taken.evidence == io::UnitEvidence::kUsual;
         });
}

bool may_be_pixels(const std::vector<io::UnitTaken>& units, io::Frame frame,
                   const std::optional<io::StatedLength>& threshold) {
  return threshold && is_small(threshold->unit) && are_without_unit(units, frame);
}

std::string metres_note(const std::vector<io::UnitTaken>& units, io::Frame frame,
                        const std::optional<io::StatedLength>& threshold) {
  if (!may_be_pixels(units, frame, threshold)) return {};
  return "places are taken as metres, as --crs metres says, beside a threshold of " +
         io::text_of(*threshold) + "; if they are in another unit, say --units position=mm";
}

double fastest_in_metres(const std::optional<io::StatedLength>& threshold) {
  constexpr double kFast_mps = 50.0;
  constexpr double kThresholdsPerSecond = 40.0;
  if (!threshold) return io::kFastestUsual_mps;
  return std::min(io::kFastestUsual_mps,
                  std::max(kFast_mps, kThresholdsPerSecond * threshold->metric));
}

std::optional<Error> doubt_of_unit(const PlacesTaken& taken,
                                   const std::optional<io::StatedLength>& threshold) {
  if (taken.asked_for_metres || !may_be_pixels(taken.units, taken.frame, threshold)) {
    return std::nullopt;
  }
  return Error{ErrorCode::kInvalidArgument,
               "are x and y in metres? Nothing names their unit, and the threshold is " +
                   io::text_of(*threshold) +
                   "; say --units position=mm, or position=m if they are in metres",
               {}};
}

void Spread::add(const Point& place) {
  least_ = {std::min(least_.x, place.x), std::min(least_.y, place.y), std::min(least_.z, place.z)};
  greatest_ = {std::max(greatest_.x, place.x), std::max(greatest_.y, place.y),
               std::max(greatest_.z, place.z)};
}

double Spread::metres() const {
  return std::hypot(greatest_.x - least_.x, greatest_.y - least_.y, greatest_.z - least_.z);
}

void WholePlaces::add(const Point& place) {
  const auto is_whole = [](double value) { return value == std::round(value); };
  whole_ = whole_ && is_whole(place.x) && is_whole(place.y) && is_whole(place.z);
  if (!whole_) return;
  ++places_;
  spread_.add(place);
}

std::optional<Error> WholePlaces::doubt(const std::optional<io::StatedLength>& threshold) const {
  constexpr std::size_t kFewest = 20;
  constexpr double kThousand = 1000.0;
  constexpr double kAFew_m = 3.0;
  if (!whole_ || places_ < kFewest || !threshold || threshold->metric > kAFew_m) {
    return std::nullopt;
  }
  const double wide = spread_.metres();
  if (!(wide >= kThousand)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "are x, y, z in metres? Nothing names their unit; they are whole numbers, and go " +
                   io::grouped(wide, 0) + " far beside a threshold of " + io::text_of(*threshold) +
                   ": say --units position=mm, position=cm, or position=m if they are in metres",
               {}};
}

std::optional<Error> doubt_of_scale(const io::Recording& recording, io::Frame asked,
                                    const std::optional<io::StatedLength>& threshold) {
  if (!are_without_unit(recording.units, recording.frame)) return std::nullopt;
  if (may_be_pixels(recording.units, recording.frame, threshold)) {
    Spread spread;
    for (const io::RecordedBee& bee : recording.bees) {
      for (const Fix& fix : bee.fixes) spread.add(fix.position);
    }
    return doubt_of_scale({recording.units, recording.frame, asked == io::Frame::kMetres}, spread,
                          threshold, kWithScale);
  }
  // Two of one id are not fast.
  if (recording.missing.shared == 0) {
    if (auto fast = io::doubt_of_metres(recording, fastest_in_metres(threshold))) return fast;
  }
  if (asked == io::Frame::kMetres) return std::nullopt;
  WholePlaces places;
  for (const io::RecordedBee& bee : recording.bees) {
    for (const Fix& fix : bee.fixes) places.add(fix.position);
  }
  return places.doubt(threshold);
}

std::optional<Error> doubt_of_scale(const io::LoadedPoints& points, io::Frame asked,
                                    const std::optional<io::StatedLength>& threshold) {
  if (!may_be_pixels(points.units, points.frame, threshold)) return std::nullopt;
  Spread spread;
  for (const Point& place : points.points) spread.add(place);
  return doubt_of_scale({points.units, points.frame, asked == io::Frame::kMetres}, spread,
                        threshold, kWithoutScale);
}

std::optional<Error> doubt_of_scale(const PlacesTaken& taken, const Spread& spread,
                                    const std::optional<io::StatedLength>& threshold,
                                    std::string_view if_pixels) {
  if (!may_be_pixels(taken.units, taken.frame, threshold)) return std::nullopt;
  const double wide_m = spread.metres();
  if (!std::isfinite(wide_m)) return std::nullopt;
  if (taken.asked_for_metres && !(wide_m > kWidest * threshold->metric)) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "are x and y in metres? Nothing names their unit, and they would go " +
                   io::grouped(wide_m, 0) + " m far, " +
                   io::grouped(wide_m / threshold->metric, 0) + " times the threshold of " +
                   io::text_of(*threshold) + "; if they are pixels, " + std::string(if_pixels) +
                   ", otherwise say --units position=mm, or position=m if they are in metres",
               {}};
}

}  // namespace beespace::analysis
