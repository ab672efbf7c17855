#include "motion/predict/prediction_steps.hpp"

#include "grid/density.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

namespace beespace::motion {

namespace {

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

// GNU vectors, because a compiler must not reorder minima by itself: SSE2 on x86-64, NEON on ARM64.
using Doubles [[gnu::vector_size(16)]] = double;
using Masks [[gnu::vector_size(16)]] = std::int64_t;

Doubles magnitude_of(const Doubles& value) {
  return value < 0.0 ? -value : value;
}
Doubles larger(const Doubles& a, const Doubles& b) {
  return a > b ? a : b;
}
Doubles smaller(const Doubles& a, const Doubles& b) {
  return a < b ? a : b;
}

// The box of points.
class Box {
 public:
  void add(const Point& p) {
    const Doubles xy{p.x, p.y};
    const Doubles z{p.z, p.z};
    low_xy_ = smaller(xy, low_xy_);
    high_xy_ = larger(xy, high_xy_);
    low_z_ = smaller(z, low_z_);
    high_z_ = larger(z, high_z_);
  }
  void add_to(core::Bounds& bounds) const {
    bounds.low = {std::min(bounds.low[0], low_xy_[0]), std::min(bounds.low[1], low_xy_[1]),
                  std::min(bounds.low[2], low_z_[0])};
    bounds.high = {std::max(bounds.high[0], high_xy_[0]), std::max(bounds.high[1], high_xy_[1]),
                   std::max(bounds.high[2], high_z_[0])};
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Doubles low_xy_{kInfinity, kInfinity};
  Doubles low_z_ = low_xy_;
  Doubles high_xy_ = -low_xy_;
  Doubles high_z_ = -low_xy_;
};

// The union of all parts' boxes; all zero for none.
template <class Parts, class BoxOf>
core::Bounds bounds_of(const Parts& parts, const BoxOf& box_of) {
  if (parts.empty()) return {};
  core::Bounds bounds;
  bounds.low.fill(std::numeric_limits<double>::infinity());
  bounds.high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& part : parts) box_of(part).add_to(bounds);
  return bounds;
}

// Statistics of all movers.
class MoverExtremes {
 public:
  void add(const Point& p, const Point& v, const Velocity& relative) {
    const Doubles values[] = {{p.x, p.y}, {p.z, v.x}, {v.y, v.z}};
    for (const Doubles& value : values) {
      const Doubles magnitude = magnitude_of(value);
      // A NaN is neither zero nor within anything.
      inside_ &=
          (value == 0.0) | ((magnitude >= kSmallestInMotion) & (magnitude <= kLargestInMotion));
    }
    farthest_ = larger(magnitude_of(values[0]), farthest_);
    highest_ = larger(magnitude_of(values[1]), highest_);
    const double squared =
        relative.x * relative.x + relative.y * relative.y + relative.z * relative.z;
    squared_speed_ = std::max(squared_speed_, squared);
  }

  [[nodiscard]] bool inside() const { return inside_[0] != 0 && inside_[1] != 0; }
  [[nodiscard]] double fastest() const { return std::sqrt(squared_speed_); }
  [[nodiscard]] double farthest_m() const {
    return std::max({farthest_[0], farthest_[1], highest_[0]});
  }

 private:
  Masks inside_{-1, -1};
  Doubles farthest_{};
  Doubles highest_{};
  double squared_speed_ = 0.0;
};

}  // namespace

PredictionSteps::PredictionSteps(const MoversView& movers, const PredictOptions& options,
                                 const core::Resources& with, const PredictionTuning& tuning)
    : movers_(movers),
      options_(options),
      separation_(separation_of(options, movers.has_heights())),
      with_(with),
      tuning_(tuning),
      middles_(with.memory, movers.size()),
      moves_(with.memory, movers.size()),
      speeds_(&with.memory) {
  choose_drift();
  look_at_movers();
  if (!in_domain_) return;
  speeds_ = size_levels(movers.size(), fastest_, with.memory, [&](std::size_t i) {
    const Move& move = moves_[i];
    return length(move.x, move.y, move.z);
  });
}

PointsView PredictionSteps::middles() const {
  return std::span<const Point>(middles_.data(), movers_.size());
}

// Any drift will do, but a bad one makes all movers faster: the median of some, which a few that
// are very fast do not move.
void PredictionSteps::choose_drift() {
  constexpr std::size_t kSome = 1024;
  const std::size_t stride = movers_.size() / kSome + 1;
  core::Vector<double> along(&with_.memory);
  const auto median_of = [&](double Point::*axis) {
    along.clear();
    for (std::size_t i = 0; i < movers_.size(); i += stride) {
      along.push_back(movers_.velocities()[i].*axis);
    }
    if (along.empty()) return 0.0;
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    return *middle;
  };
  drift_ = {median_of(&Point::x), median_of(&Point::y), median_of(&Point::z)};
}

// Most queries take one step: its midpoints are stored on the way.
void PredictionSteps::look_at_movers() {
  struct Part {
    MoverExtremes extremes;
    Box box;
  };
  middles_time_ = 0.5 * options_.horizon_s;
  core::PerWorker<Part> parts(with_);
  with_.crew.split(movers_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Part part;
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = movers_.positions()[i];
      const Point v = movers_.velocities()[i];
      const Velocity relative{v.x - drift_.x, v.y - drift_.y, v.z - drift_.z};
      part.extremes.add(p, v, relative);
      moves_[i] = {static_cast<float>(relative.x), static_cast<float>(relative.y),
                   static_cast<float>(relative.z), 0.0F};
      middles_[i] = {p.x + relative.x * middles_time_, p.y + relative.y * middles_time_,
                     p.z + relative.z * middles_time_};
      part.box.add(middles_[i]);
    }
    if (begin < end) parts[worker].push_back(part);
  });
  const auto seen = std::move(parts).joined();
  bounds_ = bounds_of(seen, [](const Part& part) { return part.box; });
  for (const Part& part : seen) {
    in_domain_ = in_domain_ && part.extremes.inside();
    fastest_ = std::max(fastest_, part.extremes.fastest());
    farthest_m_ = std::max(farthest_m_, part.extremes.farthest_m());
  }
}

void PredictionSteps::move_middles_to(double time) {
  if (time == middles_time_) return;
  middles_time_ = time;
  core::PerWorker<Box> boxes(with_);
  with_.crew.split(movers_.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    Box box;
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = movers_.positions()[i];
      const Point v = movers_.velocities()[i];
      middles_[i] = {p.x + (v.x - drift_.x) * time, p.y + (v.y - drift_.y) * time,
                     p.z + (v.z - drift_.z) * time};
      box.add(middles_[i]);
    }
    if (begin < end) boxes[worker].push_back(box);
  });
  bounds_ = bounds_of(std::move(boxes).joined(), [](const Box& box) { return box; });
}

// Where the step from `begin` on ends: later than it, unless that is the horizon.
double PredictionSteps::step_end(double begin) {
  const double left = options_.horizon_s - begin;
  const double step = tuning_.step_s ? *tuning_.step_s : cheapest_step(begin, left);
  const double end = begin + step;
  const bool last = step > 0.999'999 * left || !(end > begin);
  return last ? options_.horizon_s : end;
}

// The step with the least cost per time: short steps sort often, long ones compare many pairs.
double PredictionSteps::cheapest_step(double begin, double left) {
  // The midpoints of the step before are near enough.
  const PointsView places = begin == 0.0 ? movers_.positions() : middles();
  const core::DensitySample sample(places, with_.memory);
  const double clearance_m = separation_.reach_m();
  constexpr double kSorting = 60.0;  // nanoseconds a bee, measured
  double best = left;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const SizeLevel& speed : speeds_) {
    double step = left;
    while (step > 0.0) {
      const double reach = clearance_m + speed.size * step;
      const double cost = (kSorting + comparing_cost(sample, reach, speed.beyond)) / step;
      if (cost < best_cost) {
        best = step;
        best_cost = cost;
      }
      if (speed.size * step < 0.25 * clearance_m) break;
      step *= 0.7;
    }
  }
  return left / std::ceil(left / best * 0.999'999);  // steps of one length end at the horizon
}

core::Vector<core::FoundPairs> PredictionSteps::passing(double begin, double end,
                                                        const DecidePass& decide,
                                                        std::uint64_t most) {
  const double half = 0.5 * (end - begin);
  move_middles_to(begin + half);
  // Positions along the way are wrong by a few roundings of these; so are the middle and the half.
  const double drift = length(drift_.x, drift_.y, drift_.z);
  const double blur_m = 0x1p-47 * (farthest_m_ + options_.horizon_s * (fastest_ + drift));
  Step step{half * (1.0 + 0x1p-50), separation_.reach_m() + blur_m};
  // The step's search knows only spheres.
  if (!separation_.vertical_m) step.surely_m = separation_.threshold_m - blur_m;
  step.follows_another = begin > 0.0;
  step.most = most;
  // Velocities are rounded to floats.
  const double reach_m = fastest_ * step.half_s * (1.0 + 0x1p-20);
  const MovingBalls balls{middles(), bounds_, {moves_.data(), movers_.size()}, reach_m};
  return find_passing(balls, step, with_, tuning_.search, decide);
}

}  // namespace beespace::motion
