#include "io/recording/excursions.hpp"

#include "io/recording/flat_distance.hpp"
#include "io/recording/own_motion.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kTimesFastestOther = 3.0;
constexpr double kMayBeLate_s = 0.5;
// Ten times that of a falling stone: drones, birds and fish have less.
constexpr double kMostAcceleration_mps2 = 100.0;
constexpr double kShortestLeap_m = 0.1;

constexpr std::size_t kFewestUsualSteps = 20;
constexpr std::size_t kOneInSoMany = 20;
constexpr std::size_t kMostLeapsBetween = 8;
constexpr double kOfALeap = 0.5;

LongStep step_of(const Fix& from, const Fix& to, Frame frame) {
  const Point way = flat_offset_m(to.position, from.position, frame);
  return {from, to, way, std::hypot(way.x, way.y, way.z)};
}

bool is_sudden(const LongStep& step, double usual_s) {
  const double seconds = std::max(step.to.time_s - step.from.time_s, usual_s);
  return step.metres >= kShortestLeap_m && step.metres > kMostAcceleration_mps2 * seconds * seconds;
}

double reach_m(double fastest_mps, double seconds) {
  return fastest_mps * (seconds + kMayBeLate_s);
}

bool is_leap(const LongStep& step, double fastest_mps) {
  return step.metres > kTimesFastestOther * reach_m(fastest_mps, step.to.time_s - step.from.time_s);
}

bool are_few(std::size_t sudden, std::size_t steps) {
  return steps >= kFewestUsualSteps && sudden <= std::max<std::size_t>(2, steps / kOneInSoMany);
}

// `next`: nothing is between both leaps.
bool comes_back(const LongStep& out, const LongStep& back, bool next, double fastest_mps,
                Frame frame) {
  const double lasts_s = back.to.time_s - out.from.time_s;
  const double apart_m = flat_distance_m(out.from.position, back.to.position, frame);
  const double close_m = kOfALeap * std::min(out.metres, back.metres);
  if (apart_m <= close_m && apart_m <= reach_m(fastest_mps, lasts_s)) return true;
  const double off_m =
      std::hypot(out.way.x + back.way.x, out.way.y + back.way.y, out.way.z + back.way.z);
  return next && off_m <= close_m && apart_m <= kTimesFastestOther * reach_m(fastest_mps, lasts_s);
}

// From place to place, of nearly all the time that which is usual.
double usual_time_s(const std::vector<Fix>& fixes) {
  std::vector<double> stays_s;
  stays_s.reserve(fixes.size());
  std::size_t since = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    if (fixes[i].position == fixes[since].position) continue;
    stays_s.push_back(fixes[i].time_s - fixes[since].time_s);
    since = i;
  }
  if (stays_s.empty()) return 0.0;
  const auto middle = stays_s.begin() + static_cast<std::ptrdiff_t>(stays_s.size() / 2);
  std::nth_element(stays_s.begin(), middle, stays_s.end());
  return *middle;
}

// Whether any step is too sudden, whatever the others are.
bool any_is_sudden(const std::vector<Fix>& fixes, Frame frame) {
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    if (is_sudden(step_of(fixes[i - 1], fixes[i], frame), 0.0)) return true;
  }
  return false;
}

// To which fixes a bee leaps.
struct Leaps {
  std::vector<std::size_t> to = {};
  double fastest_mps = 0.0;
};

Leaps leaps_of(const std::vector<Fix>& fixes, Frame frame) {
  if (!any_is_sudden(fixes, frame)) return {};
  const double usual_s = usual_time_s(fixes);
  Leaps leaps;
  std::size_t steps = 0;
  for (std::size_t i = 1; i < fixes.size(); ++i) {
    const LongStep step = step_of(fixes[i - 1], fixes[i], frame);
    if (!(step.metres > 0.0)) continue;
    ++steps;
    if (is_sudden(step, usual_s)) {
      leaps.to.push_back(i);
    } else {
      const double seconds = std::max(step.to.time_s - step.from.time_s, usual_s);
      leaps.fastest_mps = std::max(leaps.fastest_mps, step.metres / seconds);
    }
  }
  if (!are_few(leaps.to.size(), steps) || leaps.fastest_mps > OwnMotion::kFastest_mps) return {};
  std::erase_if(leaps.to, [&](std::size_t to) {
    return !is_leap(step_of(fixes[to - 1], fixes[to], frame), leaps.fastest_mps);
  });
  return leaps;
}

}  // namespace

std::vector<Excursion> excursions(const std::vector<Fix>& fixes, Frame frame) {
  const Leaps leaps = leaps_of(fixes, frame);
  std::vector<Excursion> found;
  const auto leap = [&](std::size_t which) {
    return step_of(fixes[leaps.to[which] - 1], fixes[leaps.to[which]], frame);
  };
  for (std::size_t out = 0; out < leaps.to.size(); ++out) {
    const std::size_t end = std::min(leaps.to.size(), out + 1 + kMostLeapsBetween);
    for (std::size_t back = out + 1; back < end; ++back) {
      if (!comes_back(leap(out), leap(back), back == out + 1, leaps.fastest_mps, frame)) continue;
      const auto first = leaps.to.begin() + static_cast<std::ptrdiff_t>(out);
      const auto behind = leaps.to.begin() + static_cast<std::ptrdiff_t>(back + 1);
      found.push_back({leaps.to[out] - 1, leaps.to[back], {first, behind}});
      out = back;
      break;
    }
  }
  return found;
}

bool ExcursionWatch::take(const Fix& fix, Frame frame) {
  if (!last_) {
    last_ = fix;
    since_s_ = fix.time_s;
    return false;
  }
  if (!(fix.time_s > last_->time_s)) return false;
  const LongStep step = step_of(*last_, fix, frame);
  last_ = fix;
  return step.metres > 0.0 && takes_step(step, frame);
}

bool ExcursionWatch::takes_step(const LongStep& step, Frame frame) {
  // From place to place so far.
  const double usual_s =
      steps_ == 0 ? 0.0 : (step.from.time_s - since_s_) / static_cast<double>(steps_);
  ++steps_;
  if (!is_sudden(step, usual_s)) {
    const double seconds = std::max(step.to.time_s - step.from.time_s, usual_s);
    fastest_mps_ = std::max(fastest_mps_, step.metres / seconds);
    return false;
  }
  ++sudden_;
  if (!are_few(sudden_, steps_) || fastest_mps_ > OwnMotion::kFastest_mps ||
      !is_leap(step, fastest_mps_)) {
    return false;
  }
  for (const LongStep& out : leaps_) {
    if (!comes_back(out, step, &out == &leaps_.back(), fastest_mps_, frame)) continue;
    leaps_.clear();
    return true;
  }
  if (leaps_.size() == kMostLeapsBetween) leaps_.erase(leaps_.begin());
  leaps_.push_back(step);
  return false;
}

}  // namespace beespace::io
