#include "io/recording/place_noise.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::io {
namespace {

constexpr std::array kTens = {1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
// By more than two units of the last digit no rounding of four places bends a way.
constexpr double kUnitsOfRounding = 2.5;
// What moves slowly leaps by one, or by one on both axes.
constexpr double kUnitsOfALeap = 1.5;
constexpr std::size_t kFewestClear = 20;
constexpr double kFewestOfSteps = 0.25;
// Of white noise 0.73 turn, of a walk at random 0.67, of smooth ways hardly any.
constexpr double kTurnOfNoise = 0.6;

constexpr std::size_t kStepsOfBlock = 10;
// Of white noise 1: of a walk at random 10, of a straight way 100.
constexpr double kStandsWithin = 2.0;

constexpr double kUsualBraking_mps2 = 3.0;
constexpr double kNearlyFull = 0.5;
constexpr double kWeightOfLast = 0.125;

double unit_m(std::size_t digits, Frame frame) {
  constexpr double kMetresPerDegree = 111'195.0;
  return (frame == Frame::kWgs84 ? kMetresPerDegree : 1.0) / kTens[digits];
}

}  // namespace

void PlaceNoise::take_digits(double value) {
  constexpr double kNearly = 1e-3;  // of a unit: the decimal is rounded to a double
  while (digits_ + 1 < kTens.size()) {
    const double units = value * kTens[digits_];
    if (std::abs(units - std::round(units)) <= kNearly) return;
    ++digits_;
  }
}

void PlaceNoise::take_block(const Fix& fix, double step_m, Frame frame) {
  block_.squares_m2 += step_m * step_m;
  if (++block_.steps < kStepsOfBlock) return;
  const double way_m = flat_distance_m(block_.since.position, fix.position, frame);
  stood_ = stood_ ||
           way_m * way_m <= kStandsWithin * block_.squares_m2 / static_cast<double>(kStepsOfBlock);
  block_ = {fix};
}

void PlaceNoise::take(const Fix& fix, Frame frame) {
  take_digits(fix.position.x);
  take_digits(fix.position.y);
  if (!last_) {
    last_ = fix;
    block_ = {fix};
    return;
  }
  const Point way = flat_offset_m(fix.position, last_->position, frame);
  const double seconds = fix.time_s - last_->time_s;
  const double across_m = std::hypot(way.x, way.y);
  const std::array<double, 2> step = {way.x, way.y};
  const bool even = steps_ > 0 && seconds <= 2.0 * last_s_ && last_s_ <= 2.0 * seconds;
  const double rounding_m = kUnitsOfRounding * unit_m(digits_, frame);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double bend = step[axis] - step_[axis] * (even ? seconds / last_s_ : 0.0);
    if (even && steps_ > 1) {
      const double before = bends_[axis];
      const bool clear = std::abs(bend) > rounding_m && std::abs(before) > rounding_m;
      ++wavering_.steps;
      wavering_.clear += clear ? 1 : 0;
      wavering_.turned += clear && (bend < 0.0) != (before < 0.0) ? 1 : 0;
    }
    bends_[axis] = bend;
  }
  usual_mps_ = steps_ == 0 && usual_mps_ == 0.0
                   ? across_m / seconds
                   : usual_mps_ + kWeightOfLast * (speed_mps_ - usual_mps_);
  speed_mps_ = across_m / seconds;
  clear_ = across_m > kUnitsOfALeap * unit_m(digits_, frame);
  falls_ = -way.z > across_m;
  steps_ = even ? steps_ + 1 : 1;
  step_ = step;
  last_s_ = seconds;
  take_block(fix, std::hypot(across_m, way.z), frame);
  last_ = fix;
}

bool PlaceNoise::is_measured() const {
  const auto clear = static_cast<double>(wavering_.clear);
  return wavering_.clear >= kFewestClear &&
         clear >= kFewestOfSteps * static_cast<double>(wavering_.steps) &&
         static_cast<double>(wavering_.turned) >= kTurnOfNoise * clear;
}

bool PlaceNoise::stops_at_once() const {
  return clear_ && !falls_ && speed_mps_ >= kNearlyFull * usual_mps_ &&
         2.0 * speed_mps_ > kUsualBraking_mps2 * last_s_;
}

}  // namespace beespace::io
