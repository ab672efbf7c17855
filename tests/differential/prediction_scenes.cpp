#include "tests/differential/prediction_scenes.hpp"

#include "tests/differential/boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace beespace::differential {

namespace {

double in_domain(double value) {
  if (std::abs(value) < kSmallestInMotion) return std::copysign(0.0, value);
  return std::clamp(value, -kLargestInMotion, kLargestInMotion);
}

class PredictionMaker {
 public:
  explicit PredictionMaker(Random& random) : random_(random) {}

  PredictionScene make() {
    choose_scale();
    const std::size_t count = 2 + random_.below(random_.once_in(8) ? 60 : 14);
    const bool lattice = random_.once_in(3);
    scene_.name = lattice ? "lattice" : "box";
    for (std::size_t i = 0; i < count; ++i) {
      scene_.flights.push_back(lattice ? on_lattice() : anywhere());
    }
    scene_.apart = scene_.options.vertical_m && random_.once_in(5);
    for (Flight& f : scene_.flights) finish(f);
    // Some pass others just about too closely.
    const std::size_t times = random_.below(count);
    for (std::size_t i = 0; i < times; ++i) {
      const std::size_t chosen = random_.below(count);
      const Flight& other = random_.one_of(scene_.flights);
      if (&other != &scene_.flights[chosen]) tempt(scene_.flights[chosen], other);
    }
    return std::move(scene_);
  }

 private:
  void choose_scale() {
    PredictOptions& o = scene_.options;
    o.threshold_m =
        random_.coin() ? std::ldexp(1.0, random_.whole(-10, 10)) : random_.magnitude(-20, 20);
    if (random_.once_in(2)) {
      o.vertical_m =
          random_.coin() ? o.threshold_m * random_.magnitude(-4, 2) : random_.magnitude(-20, 20);
      if (random_.coin()) o.vertical_m = std::ldexp(1.0, random_.whole(-10, 10));
    }
    o.inclusive = random_.coin();
    o.horizon_s = random_.once_in(6) ? 0.0 : random_.magnitude(-6, 8);
    if (random_.coin()) o.horizon_s = std::round(o.horizon_s);
    // In the horizon some go as far as that many thresholds.
    const double lasts = o.horizon_s > 0.0 ? o.horizon_s : 1.0;
    speed_ = o.threshold_m / lasts * random_.magnitude(-4, 10);
    far_ = random_.once_in(3) ? 0.0 : random_.magnitude(-10, 50);
    if (random_.once_in(5)) far_ = 6.37e6;
    drift_ = random_.once_in(3) ? speed_ * random_.magnitude(0, 20) : 0.0;
    if (random_.once_in(16)) go_to_the_ends();
  }

  // Of the motion domain.
  void go_to_the_ends() {
    PredictOptions& o = scene_.options;
    const bool small = random_.coin();
    const auto near_end = [&](bool low) {
      const double off = random_.magnitude(-2, 30);
      return std::clamp(low ? kSmallestInMotion * off : kLargestInMotion / off, kSmallestInMotion,
                        kLargestInMotion);
    };
    o.threshold_m = near_end(small);
    if (o.vertical_m) o.vertical_m = near_end(random_.once_in(4) ? !small : small);
    o.horizon_s = near_end(random_.coin());
    speed_ = random_.coin() ? near_end(random_.coin()) : in_domain(o.threshold_m / o.horizon_s);
    far_ = random_.coin() ? 0.0 : near_end(random_.coin());
    drift_ = random_.coin() ? 0.0 : near_end(random_.coin());
  }

  [[nodiscard]] double up() const {
    return scene_.options.vertical_m ? *scene_.options.vertical_m / scene_.options.threshold_m
                                     : 1.0;
  }

  Flight anywhere() {
    const double side = scene_.options.threshold_m * spread_;
    Flight f;
    f.mover.position = {random_.between(-side, side), random_.between(-side, side),
                        random_.between(-side, side) * up()};
    // Most are slow, a few by far the fastest.
    const double speed = speed_ * (random_.once_in(5) ? random_.magnitude(-20, 0) : 1.0);
    f.mover.velocity = {random_.between(-speed, speed), random_.between(-speed, speed),
                        random_.between(-speed, speed) * up()};
    if (random_.once_in(4)) f.mover.velocity.z = 0.0;
    if (random_.once_in(8)) f.mover.velocity = {};
    return f;
  }

  // On which many graze at exactly the threshold, begin there or end there.
  Flight on_lattice() {
    const double step = scene_.options.threshold_m / random_.whole(1, 2);
    const double lasts = scene_.options.horizon_s > 0.0 ? scene_.options.horizon_s : 1.0;
    const double rise = scene_.options.vertical_m.value_or(step);
    const auto whole = [&] { return static_cast<double>(random_.whole(-4, 4)); };
    Flight f;
    f.mover.position = {step * whole(), step * whole(), rise * whole()};
    f.mover.velocity = {step / lasts * whole(), step / lasts * whole(), rise / lasts * whole()};
    return f;
  }

  void finish(Flight& f) {
    if (offset_.x == 0.0 && offset_.y == 0.0 && offset_.z == 0.0 && far_ > 0.0) {
      offset_ = random_.coin() ? Point{0.0, 0.0, far_}
                               : Point{far_, random_.between(-far_, far_), far_ * 0.75};
    }
    Point& p = f.mover.position;
    Velocity& v = f.mover.velocity;
    if (scene_.apart) {
      f.height = in_domain(p.z + offset_.z);
      f.climb = in_domain(v.z);
      p.z *= 0.25;
    } else {
      p.z += offset_.z;
    }
    p = {in_domain(p.x + offset_.x), in_domain(p.y + offset_.y), in_domain(p.z)};
    v = {in_domain(v.x + drift_), in_domain(v.y - 0.5 * drift_), in_domain(v.z)};
  }

  // The places from which something at a velocity gets into a conflict are convex: from one of
  // them, along an axis, there is a last double that still does.
  void tempt(Flight& f, const Flight& other) {
    const PredictOptions& o = scene_.options;
    const double when = random_.once_in(3) ? 0.0 : random_.between(0.0, o.horizon_s);
    const double corner = random_.coin() ? 0.0 : 1.0 - 0x1p-20;
    const double angle = random_.between(0.0, 1.0);
    const Point& p = other.mover.position;
    const Velocity& v = other.mover.velocity;
    Velocity& w = f.mover.velocity;
    if (random_.once_in(3)) w = v;  // at rest to each other
    Flight tempted = f;
    tempted.mover.position = {
        in_domain(p.x + (v.x - w.x) * when + corner * angle * o.threshold_m),
        in_domain(p.y + (v.y - w.y) * when +
                  corner * std::sqrt(1.0 - angle * angle) * o.threshold_m * (1.0 - 0x1p-19)),
        in_domain(p.z + (v.z - w.z) * when)};
    const double rise = o.vertical_m ? corner * *o.vertical_m : 0.0;
    if (scene_.apart) {
      tempted.height = in_domain(other.height + (other.climb - f.climb) * when + rise);
    } else {
      tempted.mover.position.z = in_domain(tempted.mover.position.z + rise);
    }
    if (!meets(tempted, other)) return;
    push_out(tempted, other, tempted.mover.position.x);
    if (scene_.apart) {
      push_out(tempted, other, tempted.height);
    } else {
      push_out(tempted, other, tempted.mover.position.z);
    }
    f = tempted;
    double& last = random_.coin() ? f.mover.position.x : f.mover.position.z;
    last = in_domain(ulps_up(last, random_.whole(-1, 1)));
  }

  [[nodiscard]] bool meets(const Flight& f, const Flight& other) const {
    return in_conflict(f, other, scene_.options, scene_.apart);
  }

  // Along one axis, to the last double at which it still meets.
  void push_out(Flight& f, const Flight& other, double& value) {
    if (random_.once_in(4)) return;
    const bool above = random_.coin();
    const double begin = value;
    const double end = above ? kLargestInMotion : -kLargestInMotion;
    std::int64_t near = rank_of(begin);
    std::int64_t far = rank_of(end);
    if (near == far) return;
    while (near + (above ? 1 : -1) != far) {
      const std::int64_t middle = std::midpoint(near, far);
      value = double_of(middle);
      if (value != in_domain(value)) break;  // too small to go on
      (meets(f, other) ? near : far) = middle;
    }
    value = in_domain(double_of(near));
  }

  Random& random_;
  PredictionScene scene_;
  double spread_ = random_.magnitude(-1, 5);
  double speed_ = 1.0;
  double far_ = 0.0;
  double drift_ = 0.0;
  Point offset_{};
};

}  // namespace

PredictionScene random_prediction(Random& random) {
  return PredictionMaker(random).make();
}

}  // namespace beespace::differential
