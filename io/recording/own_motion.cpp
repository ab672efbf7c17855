#include "io/recording/own_motion.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace beespace::io {
namespace {

constexpr std::uint64_t kFewestAgreed = 20;
// What stands may say less.
constexpr double kSaysThatItMoves_mps = 0.05;
constexpr double kAgreesWithin = 0.5;  // of the way

constexpr double kTimesFastest = 2.0;
constexpr double kTimesUsualOff = 5.0;
// Times may be those of arrival.
constexpr double kArrivesLate_s = 0.5;
// Of fixes farther apart in time velocities say little.
constexpr double kTooLong_s = 60.0;

struct Step {
  double way_m;
  double seconds;
  double said_mps;  // the faster one of its two ends
  double off_m;
};

bool is_said(const Velocity* velocity) {
  return velocity != nullptr && std::isfinite(velocity->x) && std::isfinite(velocity->y);
}

std::optional<Step> step_between(const Fix& from, const Velocity* from_velocity, const Fix& to,
                                 const Velocity* to_velocity, Frame frame) {
  const double seconds = to.time_s - from.time_s;
  if (!is_said(from_velocity) || !is_said(to_velocity) || !(seconds > 0.0) ||
      seconds > kTooLong_s) {
    return std::nullopt;
  }
  const Point way = flat_offset_m(to.position, from.position, frame);
  const double east_m = (from_velocity->x + to_velocity->x) / 2.0 * seconds;
  const double north_m = (from_velocity->y + to_velocity->y) / 2.0 * seconds;
  return Step{std::hypot(way.x, way.y), seconds,
              std::max(std::hypot(from_velocity->x, from_velocity->y),
                       std::hypot(to_velocity->x, to_velocity->y)),
              std::hypot(way.x - east_m, way.y - north_m)};
}

}  // namespace

void NearlyAll::take(double length) {
  int exponent = 0;
  const double part = std::frexp(length, &exponent);  // from 0.5 to 1
  const auto fine = static_cast<int>((part - 0.5) * 2.0 * static_cast<double>(kOfAnOctave));
  const int place = (exponent + kOctaves / 2) * static_cast<int>(kOfAnOctave) + fine;
  const int last = static_cast<int>(counts_.size()) - 1;
  ++counts_[static_cast<std::size_t>(length > 0.0 ? std::clamp(place, 0, last) : 0)];
  ++count_;
}

double NearlyAll::least_bound() const {
  constexpr double kNearly = 0.95;
  if (count_ == 0) return 0.0;
  double seen = 0.0;
  std::size_t place = 0;
  for (; place + 1 < counts_.size(); ++place) {
    seen += static_cast<double>(counts_[place]);
    if (seen >= kNearly * static_cast<double>(count_)) break;
  }
  const auto octave = static_cast<int>(place / kOfAnOctave) - kOctaves / 2;
  const auto fine = static_cast<double>(place % kOfAnOctave + 1);
  return std::ldexp(0.5 + fine / (2.0 * static_cast<double>(kOfAnOctave)), octave);
}

void OwnMotion::take(const Fix& from, const Velocity* from_velocity, const Fix& to,
                     const Velocity* to_velocity, Frame frame) {
  const auto step = step_between(from, from_velocity, to, to_velocity, frame);
  if (!step) return;
  fastest_mps_ = std::max(fastest_mps_, step->said_mps);
  speeds_mps_.take(step->way_m / step->seconds);
  off_m_.take(step->off_m);
  if (step->said_mps < kSaysThatItMoves_mps) return;
  ++moving_;
  if (step->off_m <= kAgreesWithin * step->said_mps * step->seconds) ++agreed_;
}

bool OwnMotion::contradicted_by(const Fix& from, const Velocity* from_velocity, const Fix& to,
                                const Velocity* to_velocity, Frame frame) const {
  if (agreed_ < kFewestAgreed || 2 * agreed_ < moving_ || fastest_mps_ > kFastest_mps) return false;
  const auto step = step_between(from, from_velocity, to, to_velocity, frame);
  if (!step) return false;
  const auto is_too_far = [&step](double fastest_mps) {
    return step->way_m > kTimesFastest * fastest_mps * (step->seconds + kArrivesLate_s);
  };
  // Nearly all steps end here, without looking at what is usual.
  if (!is_too_far(std::max(fastest_mps_, step->said_mps))) return false;
  return is_too_far(speeds_mps_.least_bound()) &&
         step->off_m > kTimesUsualOff * off_m_.least_bound();
}

}  // namespace beespace::io
