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
constexpr double kFastestLanded_mps = 2.0;
constexpr double kMostClimbLanded_mps = 1.0;

// What is not known is not beyond anything.
bool is_faster_than_landed(const Velocity& velocity) {
  return std::hypot(velocity.x, velocity.y) > kFastestLanded_mps ||
         std::abs(velocity.z) > kMostClimbLanded_mps;
}

bool is_same_place(const Point& a, const Point& b, Frame frame) {
  const Point apart = flat_offset_m(a, b, frame);
  return std::hypot(apart.x, apart.y) <= kSamePlace_m && std::abs(apart.z) <= kSamePlace_m;
}

}  // namespace

void LandedReports::take(std::int64_t micros, bool landed) {
  if (!reports_.empty() && micros < reports_.back().micros) goes_back_ = true;
  reports_.push_back({micros, landed});
}

bool LandedReports::any_landed() const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [](const Report& report) { return report.landed; });
}

bool LandedReports::says_landed(std::int64_t micros) const {
  const auto behind =
      std::upper_bound(reports_.begin(), reports_.end(), micros,
                       [](std::int64_t at, const Report& report) { return at < report.micros; });
  if (behind == reports_.begin() || !std::prev(behind)->landed) return false;
  if (all_changes_) return true;
  return behind != reports_.end() && behind->landed &&
         behind->micros - std::prev(behind)->micros <= kMostApartMicros;
}

void LandedReports::add_before_first(const std::vector<Place>& places, Frame frame,
                                     std::vector<bool>& ground) const {
  const auto first =
      static_cast<std::size_t>(std::find(ground.begin(), ground.end(), true) - ground.begin());
  for (std::size_t i = first; i-- > 0;) {
    const std::int64_t before_us = reports_.front().micros - places[i].micros;
    if (before_us <= 0 || before_us > kMostApartMicros ||
        is_faster_than_landed(places[i].velocity) ||
        !is_same_place(places[i].position, places[first].position, frame)) {
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
        !is_same_place(places[i].position, places[last - 1].position, frame)) {
      return;
    }
    ground[i] = true;
  }
}

std::vector<bool> LandedReports::on_ground(const std::vector<Place>& places, Frame frame) const {
  std::vector<bool> ground(places.size());
  if (goes_back_ || !any_landed()) return ground;
  for (std::size_t i = 0; i < places.size(); ++i) {
    ground[i] = says_landed(places[i].micros) && !is_faster_than_landed(places[i].velocity);
  }
  if (std::find(ground.begin(), ground.end(), true) == ground.end()) return ground;
  if (reports_.front().landed) add_before_first(places, frame, ground);
  if (reports_.back().landed) add_behind_last(places, frame, ground);
  return ground;
}

}  // namespace beespace::io
