#include "motion/prediction.hpp"

#include "core/density.hpp"
#include "core/memory.hpp"
#include "core/pair_order.hpp"
#include "core/validate.hpp"
#include "motion/passing_search.hpp"
#include "motion/separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>

namespace beespace::motion {

namespace {

bool by_pair(const Conflict& a, const Conflict& b) {
  return std::tie(a.first, a.second) < std::tie(b.first, b.second);
}
bool same_pair(const Conflict& a, const Conflict& b) {
  return a.first == b.first && a.second == b.second;
}

// What the movers have in common, measured once.
struct Crowd {
  Velocity drift;           // about the mean velocity: moving along with it, everybody is slower
  double fastest = 0.0;     // relative to it
  double farthest_m = 0.0;  // largest coordinate
};

Crowd measure(const MoversView& movers, const core::Resources& with) {
  struct Sums {
    std::array<double, 3> velocity{};
    double farthest_m = 0.0;
    double fastest = 0.0;
  };
  core::PerWorker<Sums> parts(with);
  const auto each = [&](auto&& add) {
    with.crew.split(movers.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
      Sums sums;
      for (std::size_t i = begin; i < end; ++i) add(sums, movers[i]);
      parts[worker].push_back(sums);
    });
  };
  each([](Sums& sums, const Mover& mover) {
    sums.velocity[0] += mover.velocity.x;
    sums.velocity[1] += mover.velocity.y;
    sums.velocity[2] += mover.velocity.z;
    const Point& p = mover.position;
    sums.farthest_m = std::max({sums.farthest_m, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  });
  Crowd crowd;
  std::array<double, 3> sum{};
  for (std::size_t worker = 0; worker < parts.size(); ++worker) {
    for (const Sums& part : parts[worker]) {
      for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part.velocity[axis];
      crowd.farthest_m = std::max(crowd.farthest_m, part.farthest_m);
    }
    parts[worker].clear();
  }
  const auto count = static_cast<double>(std::max<std::size_t>(1, movers.size()));
  crowd.drift = {sum[0] / count, sum[1] / count, sum[2] / count};
  each([&](Sums& sums, const Mover& mover) {
    const double x = mover.velocity.x - crowd.drift.x;
    const double y = mover.velocity.y - crowd.drift.y;
    const double z = mover.velocity.z - crowd.drift.z;
    sums.fastest = std::max(sums.fastest, std::sqrt(x * x + y * y + z * z));
  });
  for (std::size_t worker = 0; worker < parts.size(); ++worker) {
    for (const Sums& part : parts[worker]) crowd.fastest = std::max(crowd.fastest, part.fastest);
  }
  return crowd;
}

class Prediction {
 public:
  Prediction(const MoversView& movers, const PredictOptions& options, const core::Resources& with,
             const PredictionChoices& choices)
      : movers_(movers),
        options_(options),
        separation_(separation_of(options, movers.has_heights())),
        with_(with),
        choices_(choices),
        crowd_(measure(movers, with)),
        clearance_m_(separation_.reach_m()),
        // Positions along the way are wrong by a few roundings of these.
        blur_m_(0x1p-48 *
                (crowd_.farthest_m + options.horizon_s * (crowd_.fastest + length(crowd_.drift)))),
        middles_(with.memory, movers.size()),
        moves_(with.memory, movers.size()) {
    note_moves();
  }

  Result<std::vector<Conflict>> run() {
    double begin = 0.0;
    for (bool first = true; first || begin < options_.horizon_s; first = false) {
      const double end = step_end(begin);
      take_step(begin, end);
      if (found_.size() > options_.max_results) {
        settle();
        if (found_.size() > options_.max_results) {
          return core::too_many_results(options_.max_results);
        }
      }
      begin = end;
    }
    settle();
    return std::move(found_);
  }

 private:
  static double length(const Velocity& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

  [[nodiscard]] PointsView middles() const {
    return std::span<const Point>(middles_.data(), movers_.size());
  }

  void move_middles_to(double time) {
    const Velocity& drift = crowd_.drift;
    with_.crew.split(movers_.size(), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto [p, v] = movers_[i];
        middles_[i] = {p.x + (v.x - drift.x) * time, p.y + (v.y - drift.y) * time,
                       p.z + (v.z - drift.z) * time};
      }
    });
  }

  void note_moves() {
    const Velocity& drift = crowd_.drift;
    with_.crew.split(movers_.size(), [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        const Point v = movers_.velocities()[i];
        moves_[i] = {static_cast<float>(v.x - drift.x), static_cast<float>(v.y - drift.y),
                     static_cast<float>(v.z - drift.z), 0.0F};
      }
    });
  }

  // Where the step from `begin` on ends: later than it, unless that is the horizon.
  double step_end(double begin) {
    const double left = options_.horizon_s - begin;
    const double step = choices_.step_s ? *choices_.step_s : cheapest_step(begin, left);
    const double end = begin + step;
    const bool last = step > 0.999'999 * left || !(end > begin);
    return last ? options_.horizon_s : end;
  }

  // The step whose cost is least for the time that it covers: short ones look around often, long
  // ones look at many.
  double cheapest_step(double begin, double left) {
    // Where they were in the middle of the step before is near enough.
    const PointsView places = begin == 0.0 ? movers_.positions() : middles();
    const core::DensitySample sample(places, with_.memory);
    // Measured, in nanoseconds: of sorting a bee, and of comparing it with one other.
    constexpr double kSorting = 60.0;
    constexpr double kComparing = 0.25;
    double best = left;
    double best_cost = 0.0;
    double step = left;
    while (step > 0.0) {
      const double reach = clearance_m_ + crowd_.fastest * step;
      // Rows around, as far as the reach: as large as a cube of 2.6 times that.
      const double cost = (kSorting + 0.5 * kComparing * sample.mates(2.6 * reach)) / step;
      if (step == left || cost < best_cost) {
        best = step;
        best_cost = cost;
      }
      if (crowd_.fastest * step < 0.25 * clearance_m_) break;
      step *= 0.7;
    }
    return left / std::ceil(left / best * 0.999'999);  // steps of one length end at the horizon
  }

  void take_step(double begin, double end) {
    const double half = 0.5 * (end - begin);
    move_middles_to(begin + half);
    const MovingBalls balls{middles(), {moves_.data(), movers_.size()}};
    // The middle is rounded, and so is the half.
    const Step step{half * (1.0 + 0x1p-50), clearance_m_ + 2.0 * blur_m_};
    const auto candidates = find_passing(balls, step, with_, choices_.search);
    judge(candidates, begin);
  }

  // In ascending order, so that the first of each two is read one after the other, and what is
  // found need not be sorted.
  void judge(const core::Vector<core::FoundPairs>& candidates, double step_begin) {
    std::size_t size = 0;
    for (const core::FoundPairs& part : candidates) size += part.size();
    core::Buffer<Pair> pairs(with_.memory, size);
    core::order_pairs(candidates, core::Direction::kAscending, movers_.size(), with_, pairs.data());
    const std::size_t before = found_.size();
    found_.reserve(before + size);
    core::advise_huge_pages(found_.data() + before, size * sizeof(Conflict));
    found_.resize(before + size);
    std::vector<std::size_t> ends(with_.crew.size());  // of what each worker has found
    with_.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      std::size_t to = before + begin;
      for (std::size_t k = begin; k < end; ++k) {
        constexpr std::size_t kAhead = 16;
        if (k + kAhead < end) prefetch(pairs[k + kAhead].second);
        const auto [first, second] = pairs[k];
        const State a = state_of(movers_, first);
        const State b = state_of(movers_, second);
        if (step_begin > 0.0 && surely_found_before(a, b, step_begin)) continue;
        const auto report = conflict_of(a, b, separation_, options_.horizon_s);
        if (!report) continue;
        found_[to++] = {first,
                        second,
                        report->span.begins_s,
                        report->closest_s,
                        report->span.ends_s,
                        report->closest_m};
      }
      ends[worker] = to;
    });
    close_gaps(before, size, ends);
  }

  // Puts what workers have found, each at the beginning of its share, one behind the other.
  void close_gaps(std::size_t before, std::size_t size, const std::vector<std::size_t>& ends) {
    auto to = found_.begin() + static_cast<std::ptrdiff_t>(before);
    for (unsigned worker = 0; worker < ends.size(); ++worker) {
      const auto from = found_.begin() +
                        static_cast<std::ptrdiff_t>(before + with_.crew.share(size, worker).first);
      const auto end = found_.begin() + static_cast<std::ptrdiff_t>(ends[worker]);
      if (from < end) to = from == to ? end : std::move(from, end, to);
    }
    found_.erase(to, found_.end());
  }

  void prefetch(PointId id) const {
    for (const PointsView* view : {&movers_.positions(), &movers_.velocities()}) {
      const auto* const first = reinterpret_cast<const std::byte*>(view->axes()[0]);
      __builtin_prefetch(first + static_cast<std::ptrdiff_t>(id) * view->stride_bytes()[0]);
    }
  }

  // Whether the two are in conflict where this step begins and the one before it ended.
  [[nodiscard]] bool surely_found_before(const State& a, const State& b, double time) const {
    RelativeMotion<4> motion = relative_motion(a, b);
    for (std::size_t axis = 0; axis < 4; ++axis) motion.r[axis] += motion.w[axis] * time;
    const std::size_t up = separation_.vertical_axis();
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!options_.vertical_m || axis != up) squared += motion.r[axis] * motion.r[axis];
    }
    const double slack = 4.0 * blur_m_;
    constexpr double kRounded = 1.0 - 0x1p-40;
    if (std::sqrt(squared) + slack >= options_.threshold_m * kRounded) return false;
    return !options_.vertical_m || std::abs(motion.r[up]) + slack < *options_.vertical_m * kRounded;
  }

  // Sorts what several steps have found, and drops whom more than one has.
  void settle() {
    const auto not_below = [](const Conflict& a, const Conflict& b) { return !by_pair(a, b); };
    if (std::adjacent_find(found_.begin(), found_.end(), not_below) == found_.end()) return;
    std::sort(found_.begin(), found_.end(), by_pair);
    found_.erase(std::unique(found_.begin(), found_.end(), same_pair), found_.end());
  }

  const MoversView& movers_;
  const PredictOptions& options_;
  Separation separation_;
  const core::Resources& with_;
  const PredictionChoices& choices_;
  Crowd crowd_;
  double clearance_m_;
  double blur_m_;
  core::Buffer<Point> middles_;
  core::Buffer<Move> moves_;
  std::vector<Conflict> found_;
};

}  // namespace

Result<std::vector<Conflict>> predict(const MoversView& movers, const PredictOptions& options,
                                      const core::Resources& with,
                                      const PredictionChoices& choices) {
  return Prediction(movers, options, with, choices).run();
}

}  // namespace beespace::motion
