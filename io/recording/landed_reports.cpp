#include "io/recording/landed_reports.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace beespace::io {
namespace {

constexpr std::int64_t kMostApartMicros = 5'000'000;
constexpr double kSamePlace_m = 1.0;
// What an estimator says of who stands wavers by less.
constexpr double kFastestLanded_mps = 1.0;
constexpr double kMostClimbLanded_mps = 0.5;
// So far what an estimator says of the place of who stands drifts, in the plane and in height.
constexpr double kStandingDrift_m = 2.0;
constexpr double kGroundLevel_m = 3.0;  // what is higher than the ground than that is not on it
constexpr double kAboveHome_m = 5.0;    // a height by pressure drifts by less in a flight

// What is not known is not beyond anything.
bool is_faster_than_landed(const Velocity& velocity) {
  return std::hypot(velocity.x, velocity.y) > kFastestLanded_mps ||
         std::abs(velocity.z) > kMostClimbLanded_mps;
}

bool is_within(const Point& a, const Point& b, double most_m, Frame frame) {
  const Point apart = flat_offset_m(a, b, frame);
  return std::hypot(apart.x, apart.y) <= most_m && std::abs(apart.z) <= most_m;
}

// Where a drone is on the ground as its log begins, and as it ends.
std::vector<double> ground_levels_m(const std::vector<LandedReports::Place>& places,
                                    const std::vector<bool>& ground) {
  std::vector<double> levels;
  if (ground.front()) levels.push_back(places.front().position.z);
  if (ground.back()) levels.push_back(places.back().position.z);
  return levels;
}

bool is_at_level(double height_m, const std::vector<double>& levels) {
  return std::any_of(levels.begin(), levels.end(), [height_m](double level_m) {
    return std::abs(height_m - level_m) <= kGroundLevel_m;
  });
}

// Of the places from `begin` to `end`, all of which are said to be on the ground.
void doubt_stretch(const std::vector<LandedReports::Place>& places, std::size_t begin,
                   std::size_t end, const std::vector<double>& levels, Frame frame,
                   std::vector<bool>& ground) {
  double lowest_m = places[begin].position.z;
  for (std::size_t i = begin; i < end; ++i) lowest_m = std::min(lowest_m, places[i].position.z);
  for (std::size_t i = begin; i < end; ++i) {
    const Point& at = places[i].position;
    const bool stays = is_within(at, places[begin].position, kStandingDrift_m, frame) ||
                       is_within(at, places[end - 1].position, kStandingDrift_m, frame);
    ground[i] = stays && at.z - lowest_m <= kStandingDrift_m && is_at_level(at.z, levels) &&
                !(places[i].above_home_m > kAboveHome_m);
  }
}

}  // namespace

void LandedReports::take(std::int64_t micros, bool landed, bool sure) {
  if (!reports_.empty() && micros < reports_.back().micros) goes_back_ = true;
  reports_.push_back({micros, landed, sure});
}

bool LandedReports::any_landed() const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [](const Report& report) { return report.landed; });
}

LandedReports::Word LandedReports::word_at(std::int64_t micros) const {
  const auto behind =
      std::upper_bound(reports_.begin(), reports_.end(), micros,
                       [](std::int64_t at, const Report& report) { return at < report.micros; });
  if (behind == reports_.begin() || behind == reports_.end()) return Word::kFlies;
  const Report& before = *std::prev(behind);
  if (!before.landed || !behind->landed || behind->micros - before.micros > kMostApartMicros) {
    return Word::kFlies;
  }
  return before.sure && behind->sure ? Word::kSure : Word::kHints;
}

// Of `ground`, which is what is left of the places that are said to be so.
void LandedReports::doubt_hints(const std::vector<Place>& places, std::vector<bool>& ground) const {
  const bool has_flown = std::any_of(reports_.begin(), reports_.end(),
                                     [](const Report& report) { return !report.landed; });
  for (std::size_t begin = 0; begin < places.size();) {
    bool hints = false;
    bool doubted = false;
    std::size_t end = begin;
    for (; end < places.size(); ++end) {
      const Word word = word_at(places[end].micros);
      if (word == Word::kFlies && !ground[end]) break;
      hints = hints || word == Word::kHints;
      doubted = doubted || !ground[end] || !(has_flown || std::isfinite(places[end].above_home_m));
    }
    if (hints && doubted) {
      std::fill(ground.begin() + static_cast<std::ptrdiff_t>(begin),
                ground.begin() + static_cast<std::ptrdiff_t>(end), false);
    }
    begin = std::max(end, begin + 1);
  }
}

void LandedReports::add_before_first(const std::vector<Place>& places, Frame frame,
                                     std::vector<bool>& ground) const {
  const auto first =
      static_cast<std::size_t>(std::find(ground.begin(), ground.end(), true) - ground.begin());
  for (std::size_t i = first; i-- > 0;) {
    const std::int64_t before_us = reports_.front().micros - places[i].micros;
    if (before_us <= 0 || before_us > kMostApartMicros ||
        is_faster_than_landed(places[i].velocity) ||
        !is_within(places[i].position, places[first].position, kSamePlace_m, frame)) {
      return;
    }
    ground[i] = true;
  }
}

void LandedReports::add_behind_last(const std::vector<Place>& places, Frame frame,
                                    std::vector<bool>& ground) const {
  std::size_t last = places.size();
  while (last > 0 && !ground[last - 1]) --last;
  if (last == 0) return;
  for (std::size_t i = last; i < places.size(); ++i) {
    const std::int64_t behind_us = places[i].micros - reports_.back().micros;
    if (behind_us < 0 || behind_us > kMostApartMicros ||
        is_faster_than_landed(places[i].velocity) ||
        !is_within(places[i].position, places[last - 1].position, kSamePlace_m, frame)) {
      return;
    }
    ground[i] = true;
  }
}

std::vector<bool> LandedReports::on_ground(const std::vector<Place>& places, Frame frame) const {
  std::vector<bool> ground(places.size());
  if (goes_back_ || !any_landed()) return ground;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ground[i] =
        word_at(places[i].micros) != Word::kFlies && !is_faster_than_landed(places[i].velocity);
  }
  if (std::find(ground.begin(), ground.end(), true) == ground.end()) return ground;
  if (reports_.front().landed) add_before_first(places, frame, ground);
  if (reports_.back().landed) add_behind_last(places, frame, ground);
  const std::vector<double> levels = ground_levels_m(places, ground);
  for (std::size_t begin = 0; begin < places.size();) {
    std::size_t end = begin;
    while (end < places.size() && ground[end]) ++end;
    if (end > begin) doubt_stretch(places, begin, end, levels, frame, ground);
    begin = end + 1;
  }
  doubt_hints(places, ground);
  return ground;
}

}  // namespace beespace::io
