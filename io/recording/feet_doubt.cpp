#include "io/recording/feet_doubt.hpp"

#include "io/frames/coordinate_frame.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/table/table_sources.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

constexpr std::size_t kFewestRatios = 8;
constexpr std::size_t kMostRatios = 100'000;

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::string three_digits(double value) {
  std::array<char, 32> text = {};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3)
          .ptr;
  return {text.data(), end};
}

}  // namespace

bool FeetDoubt::concerns(const std::vector<UnitTaken>& units) {
  return std::any_of(units.begin(), units.end(), [](const UnitTaken& taken) {
    // What Flightradar24 exports has its place in one column, as nothing else has.
    return taken.evidence == UnitEvidence::kSource &&
           taken.reason.find(kFlightradar24) == std::string::npos &&
           (taken.unit == Unit::kFoot || taken.unit == Unit::kKnot);
  });
}

void FeetDoubt::take_height(double metres) {
  highest_m_ = std::max(highest_m_, metres);
}

void FeetDoubt::take_speed(const Velocity& stated) {
  const double stated_mps = std::hypot(stated.x, stated.y);
  if (std::isfinite(stated_mps)) fastest_mps_ = std::max(fastest_mps_, stated_mps);
}

void FeetDoubt::take_step(const Fix& from, const Velocity& stated, const Fix& to) {
  constexpr double kLongest_s = 60.0;  // turns make the way between two records shorter
  constexpr double kFlies_mps = 20.0;
  const double stated_mps = std::hypot(stated.x, stated.y);
  const double seconds = to.time_s - from.time_s;
  if (!(stated_mps >= kFlies_mps) || !std::isfinite(stated_mps)) return;
  if (!(seconds > 0.0) || seconds > kLongest_s || ratios_.size() >= kMostRatios) return;
  const double metres = flat_distance_m(from.position, to.position, Frame::kWgs84);
  if (metres > 0.0) ratios_.push_back(metres / seconds / stated_mps);
}

std::optional<Error> FeetDoubt::doubt() const {
  // No airliner is so high in metres, or so fast in m/s, even with the wind.
  constexpr double kHighest = 20'000.0;
  constexpr double kFastest = 400.0;
  if (highest_m_ > in_metric(kHighest, Unit::kFoot)) return std::nullopt;
  if (fastest_mps_ > in_metric(kFastest, Unit::kKnot)) return std::nullopt;
  constexpr double kKnots = 1.4;    // times as fast as they say, at most: between 1 and
  constexpr double kMetres = 2.7;   // 1.94, as m/s that are taken for knots; not beyond
  constexpr double kTurning = 0.6;  // on ways that are not straight
  constexpr std::string_view kWhichUnits =
      ", as the names tell that traffic gives them? State vectors of OpenSky without columns of "
      "their own (origin_country, sensors, position_source) have the same names, in metres and "
      "m/s";
  constexpr std::string_view kSayWhich =
      ". Say which: --units aviation, or --units height=m,speed=m/s,climb=m/s";
  const std::string question = "are heights in feet and speeds in knots" + std::string(kWhichUnits);
  if (ratios_.size() < kFewestRatios) {
    return Error{ErrorCode::kInvalidArgument,
                 question +
                     ", and here neither a height, a speed, nor the way from record to "
                     "record tells" +
                     std::string(kSayWhich),
                 {}};
  }
  const double ratio = middle_of(ratios_);
  if (ratio > kTurning && ratio < kKnots) return std::nullopt;
  const std::string how = ratio >= kKnots && ratio < kMetres ? ", and would fit" : "";
  return Error{ErrorCode::kInvalidArgument,
               question + how + ": from record to record aircraft go " + three_digits(ratio) +
                   " times as fast as they say in knots" + std::string(kSayWhich),
               {}};
}

}  // namespace beespace::io
