#include <beespace/closest_approach.hpp>
#include <beespace/engine.hpp>
#include <beespace/verify.hpp>

#include "verify/clearance.hpp"
#include "verify/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace beespace {

namespace {

using verify::Curve;

// Of the threshold: how exactly the closest distance is known.
constexpr double kTolerance = 1e-9;
// How much a limit may be exceeded, for rounding.
constexpr double kOverLimit = 1.0 + 1e-9;

std::string shown(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

std::optional<Error> check_clearance(const VerifyOptions& options) {
  const double clearance_m = options.clearance_m;
  if (std::isnan(clearance_m)) {
    if (options.obstacles == nullptr) return std::nullopt;
    return Error{ErrorCode::kInvalidArgument,
                 "there are obstacles, and the clearance from them is not given (or is not a "
                 "number); say in metres how close is too close",
                 {}};
  }
  if (clearance_m >= kSmallestInMotion && clearance_m <= kLargestInMotion) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the clearance is " + shown(clearance_m) +
                   " m; give a finite distance above zero (7.9e-31 m to 1.3e+30 m)",
               {}};
}

std::optional<Error> check_options(const VerifyOptions& options) {
  // As in the rest of the library.
  const auto approach = closest_approach({}, {}, {options.threshold_m, {}, 0.0});
  if (!approach) return approach.error();
  const auto check = [](double limit, const char* name, const char* unit) -> std::optional<Error> {
    if (limit >= 0.0) return std::nullopt;
    return Error{ErrorCode::kInvalidArgument,
                 std::string("the greatest ") + name + " is " + shown(limit) + " " + unit +
                     "; give zero or more, or infinity for none",
                 {}};
  };
  if (auto error = check_clearance(options)) return error;
  if (auto error = check(options.max_speed_mps, "speed", "m/s")) return error;
  return check(options.max_acceleration_mps2, "acceleration", "m/s^2");
}

Point scaled_difference(const Point& a, const Point& b, double scale) {
  return {(a.x - b.x) * scale, (a.y - b.y) * scale, (a.z - b.z) * scale};
}

}  // namespace

class __attribute__((visibility("hidden"))) Verifier::State {
 public:
  explicit State(const VerifyOptions& options) : options_(options) {}

  Status add(double time_s, const MoversView& movers, const RunOptions& run) {
    if (auto error = check(time_s, movers)) return *std::move(error);
    now_.clear();
    for (std::size_t i = 0; i < movers.size(); ++i) now_.push_back(movers[i]);
    if (time_s_) {
      if (Status looked = look_at_step(*time_s_, time_s, run); !looked) return looked;
      ++verdict_.steps;
    }
    time_s_ = time_s;
    std::swap(before_, now_);
    return std::monostate{};
  }

  void skip() { time_s_.reset(); }

  [[nodiscard]] const VerifyOptions& options() const { return options_; }
  [[nodiscard]] const Verdict& verdict() const { return verdict_; }

 private:
  std::optional<Error> check(double time_s, const MoversView& movers) const {
    if (auto error = check_options(options_)) return error;
    if (auto error = check_movers(movers)) return error;
    if (!std::isfinite(time_s)) {
      return Error{
          ErrorCode::kNotFinite, "the time is " + shown(time_s) + "; give a finite one", {}};
    }
    if (!time_s_) return std::nullopt;
    if (!(time_s > *time_s_)) {
      return Error{ErrorCode::kTimeOrder,
                   "time " + shown(time_s) + " s does not come after " + shown(*time_s_) + " s",
                   {}};
    }
    const double lasts_s = time_s - *time_s_;
    if (!(lasts_s >= kSmallestInMotion && lasts_s <= kLargestInMotion)) {
      return Error{ErrorCode::kInvalidArgument,
                   "time " + shown(time_s) + " s comes " + shown(lasts_s) + " s after " +
                       shown(*time_s_) + " s; let steps last 7.9e-31 s to 1.3e+30 s",
                   {}};
    }
    if (movers.size() != before_.size()) {
      return Error{ErrorCode::kInvalidArgument,
                   std::to_string(movers.size()) + " movers, after " +
                       std::to_string(before_.size()) + "; give as many each time",
                   {}};
    }
    return std::nullopt;
  }

  // As the library does for movers: closest_approach knows what is wrong with one.
  std::optional<Error> check_movers(const MoversView& movers) const {
    if (movers.has_heights()) {
      return Error{ErrorCode::kInvalidArgument,
                   "there are heights apart from the positions; give positions in space",
                   {}};
    }
    if (!movers.fits()) {
      return Error{ErrorCode::kInvalidArgument,
                   "there are " + std::to_string(movers.positions().size()) + " positions and " +
                       std::to_string(movers.velocities().size()) +
                       " velocities, or axes of other lengths; give one of each for every mover",
                   {}};
    }
    for (std::size_t i = 0; i < movers.size(); ++i) {
      Mover mover = verify::in_domain(movers[i]);
      if (options_.straight) mover.velocity = {};  // not looked at
      const auto checked = closest_approach(mover, mover, {options_.threshold_m, {}, 0.0});
      if (checked) continue;
      Error error = checked.error();
      if (error.location.record) error.location.record = i;
      return error;
    }
    return std::nullopt;
  }

  Status look_at_step(double begin_s, double end_s, const RunOptions& run) {
    const double lasts_s = end_s - begin_s;
    curves_.clear();
    chords_.resize(now_.size());
    double farthest_m = 0.0;
    double bulge_m = 0.0;
    for (std::size_t i = 0; i < now_.size(); ++i) {
      const Point& p = before_[i].position;
      const Point& q = now_[i].position;
      curves_.push_back(options_.straight ? verify::line_of(p, q)
                                          : verify::curve_of(before_[i], now_[i], lasts_s));
      const Point chord = scaled_difference(q, p, 1.0 / lasts_s);
      chords_[i] = verify::in_domain(Mover{p, {chord.x, chord.y, chord.z}});
      bulge_m = std::max(bulge_m, verify::bulge_of(curves_.back()));
      for (const Point& at : {p, q}) {
        farthest_m = std::max({farthest_m, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
      }
    }
    const double rounded_m = 0x1p-48 * farthest_m;
    PredictOptions around;
    // The last: places and velocities that count as zero are off by less than 2^-99 each, of two.
    around.threshold_m =
        2.0 * options_.threshold_m + 2.0 * bulge_m + 4.0 * rounded_m + 0x1p-98 * (1.0 + lasts_s);
    around.horizon_s = lasts_s * (1.0 + 0x1p-50);
    around.threads = run.threads;
    around.stop = run.stop;
    if (Status found = engine_.predict_pairs(chords_, around, pairs_); !found) return found;
    check_limits(begin_s, lasts_s, rounded_m,
                 0x1p-52 * std::max(std::abs(begin_s), std::abs(end_s)));
    for (const Pair& pair : pairs_) check_pair(pair, begin_s, end_s, rounded_m);
    if (options_.obstacles != nullptr) check_clearance(begin_s, end_s, rounded_m);
    return std::monostate{};
  }

  void check_pair(const Pair& pair, double begin_s, double end_s, double rounded_m) {
    const Curve between = verify::difference(curves_[pair.first], curves_[pair.second]);
    const double closest_m =
        std::max(0.0, closest_(between, kTolerance * options_.threshold_m) - 2.0 * rounded_m);
    if (closest_m < 2.0 * options_.threshold_m &&
        closest_m < verdict_.closest_m.value_or(std::numeric_limits<double>::infinity())) {
      verdict_.closest_m = closest_m;
      verdict_.closest_pair = pair;
      verdict_.closest_step_s = begin_s;
    }
    if (closest_m >= options_.threshold_m) return;
    ++verdict_.losses;
    if (verdict_.first_losses.size() < Verdict::kMostShown) {
      verdict_.first_losses.push_back({pair, begin_s, end_s, closest_m});
    }
  }

  void check_clearance(double begin_s, double end_s, double rounded_m) {
    verify::ClearanceCheck check(*options_.obstacles, options_.clearance_m);
    for (PointId bee = 0; bee < curves_.size(); ++bee) {
      const auto found = check(curves_[bee], rounded_m);
      if (!found) continue;
      ++verdict_.clearance_losses;
      if (verdict_.first_clearance_losses.size() < Verdict::kMostShown) {
        verdict_.first_clearance_losses.push_back(
            {bee, found->obstacle, begin_s, end_s, found->closest_m});
      }
    }
  }

  void check_limits(double begin_s, double lasts_s, double rounded_m, double rounded_s) {
    // What is computed from differences of positions and times is as wrong as these are: both were
    // rounded when they were written.
    const double by_time = std::min(1.0, 2.0 * rounded_s / lasts_s);
    for (PointId bee = 0; bee < curves_.size(); ++bee) {
      const auto& c = curves_[bee].control;
      std::array<Point, 3> velocities;  // the control points of its derivative
      for (std::size_t k = 0; k < 3; ++k) {
        velocities[k] = scaled_difference(c[k + 1], c[k], 3.0 / lasts_s);
      }
      const double speed = verify::farthest_from_origin(velocities);
      verdict_.peak_speed_mps = std::max(verdict_.peak_speed_mps, speed);
      const double rounded_mps = 4.0 * rounded_m / lasts_s + by_time * speed;
      const double rounded_mps2 = 6.0 * rounded_mps / lasts_s;
      note(bee, BreachKind::kSpeed, begin_s, speed,
           options_.max_speed_mps * kOverLimit + rounded_mps);
      if (options_.straight) continue;
      double acceleration = 0.0;
      for (std::size_t k = 0; k < 2; ++k) {
        const Point bend =
            scaled_difference(verify::mixed(c[k], c[k + 2]), c[k + 1], 12.0 / (lasts_s * lasts_s));
        acceleration = std::max(acceleration, verify::length(bend));
      }
      verdict_.peak_acceleration_mps2 = std::max(verdict_.peak_acceleration_mps2, acceleration);
      note(bee, BreachKind::kAcceleration, begin_s, acceleration,
           options_.max_acceleration_mps2 * kOverLimit + rounded_mps2);
    }
  }

  void note(PointId bee, BreachKind kind, double begin_s, double value, double most) {
    if (!(value > most)) return;
    ++verdict_.breaches;
    if (verdict_.first_breaches.size() < Verdict::kMostShown) {
      verdict_.first_breaches.push_back({bee, kind, begin_s, value});
    }
  }

  VerifyOptions options_;
  Verdict verdict_;
  std::optional<double> time_s_;
  std::vector<Mover> before_;
  std::vector<Mover> now_;
  std::vector<Curve> curves_;  // of all, in this step
  std::vector<Mover> chords_;
  Engine engine_;
  std::vector<Pair> pairs_;
  verify::ClosestToOrigin closest_;
};

Verifier::Verifier(const VerifyOptions& options) : state_(std::make_unique<State>(options)) {
}
Verifier::Verifier(Verifier&&) noexcept = default;
Verifier& Verifier::operator=(Verifier&&) noexcept = default;
Verifier::~Verifier() = default;

Status Verifier::add(double time_s, const MoversView& movers) {
  return add(time_s, movers, {state_->options().threads, state_->options().stop});
}

Status Verifier::add(double time_s, const MoversView& movers, const RunOptions& run) {
  return state_->add(time_s, movers, run);
}

void Verifier::skip() {
  state_->skip();
}

const Verdict& Verifier::verdict() const {
  return state_->verdict();
}

}  // namespace beespace
