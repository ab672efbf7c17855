#include "motion/passing/oversized_balls.hpp"

#include "grid/density.hpp"
#include "grid/size_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace beespace::motion {

namespace {

// How far a ball gets from the middle of its step.
double reach_of(const Move& move, double half_s) {
  const double x = move.x;
  const double y = move.y;
  const double z = move.z;
  return (std::sqrt(x * x + y * y + z * z) * half_s + double{move.radius_m}) * (1.0 + 0x1p-40);
}

// Pairs of which one is beyond the grid.
class SearchBeyond {
 public:
  SearchBeyond(const MovingBalls& balls, const Step& step, std::span<const PointId> beyond,
               const DecidePass& decide, Total& total)
      : balls_(balls), step_(step), beyond_(beyond), decide_(decide), total_(total) {}

  // Of these with those beyond.
  void operator()(std::size_t begin, std::size_t end, core::FoundPairs& found) const {
    core::FoundPairs::Chunk* chunk = nullptr;
    for (std::size_t i = begin; i < end; ++i) {
      const auto id = static_cast<PointId>(i);
      const bool is_beyond = std::binary_search(beyond_.begin(), beyond_.end(), id);
      for (const PointId far : beyond_) {
        if (is_beyond && far <= id) continue;  // once a pair
        if (!may_pass(id, far) || (decide_ && !decide_(id, far))) continue;
        if (chunk == nullptr || chunk->size == chunk->capacity) {
          if (chunk != nullptr && !total_.add(chunk->size)) return;
          chunk = &found.open_chunk();
        }
        chunk->first[chunk->size] = id;
        chunk->second[chunk->size] = far;
        ++chunk->size;
      }
    }
  }

 private:
  [[nodiscard]] bool may_pass(PointId i, PointId j) const {
    const Point p = balls_.middles[i];
    const Point q = balls_.middles[j];
    const Move& a = balls_.moves[i];
    const Move& b = balls_.moves[j];
    const std::array<double, 3> r{q.x - p.x, q.y - p.y, q.z - p.z};
    const std::array<double, 3> w{(double{b.x} - a.x) * step_.half_s,
                                  (double{b.y} - a.y) * step_.half_s,
                                  (double{b.z} - a.z) * step_.half_s};
    const double speed_squared = w[0] * w[0] + w[1] * w[1] + w[2] * w[2];
    const double approach = r[0] * w[0] + r[1] * w[1] + r[2] * w[2];
    const double t = speed_squared > 0.0 ? std::clamp(-approach / speed_squared, -1.0, 1.0) : 0.0;
    double squared = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = r[axis] + w[axis] * t;
      squared += at * at;
    }
    // Velocities are rounded to floats.
    const double blur_m = 0x1p-20 * std::sqrt(speed_squared);
    const double clearance_m = step_.clearance_m + a.radius_m + b.radius_m + blur_m;
    return !(squared > clearance_m * clearance_m * (1.0 + 0x1p-40));
  }

  const MovingBalls& balls_;
  const Step& step_;
  std::span<const PointId> beyond_;  // ascending
  const DecidePass& decide_;
  Total& total_;
};

}  // namespace

double reach_in_grid(const MovingBalls& balls, const Step& step, const core::Resources& with) {
  const auto levels =
      size_levels(balls.moves.size(), balls.reach_m, with.memory,
                  [&](std::size_t i) { return reach_of(balls.moves[i], step.half_s); });
  if (levels.size() == 1) return balls.reach_m;
  const core::DensitySample sample(balls.middles, with.memory);
  const auto cost = [&](const SizeLevel& level) {
    return comparing_cost(sample, step.clearance_m + 2.0 * level.size, level.beyond);
  };
  return std::min_element(levels.begin(), levels.end(),
                          [&](const SizeLevel& a, const SizeLevel& b) { return cost(a) < cost(b); })
      ->size;
}

Partition::Partition(const MovingBalls& balls, const Step& step, double reach_m,
                     const core::Resources& with)
    : in_grid_(&with.memory), beyond_(&with.memory), middles_(&with.memory), moves_(&with.memory) {
  for (std::size_t i = 0; i < balls.moves.size(); ++i) {
    const auto id = static_cast<PointId>(i);
    if (reach_of(balls.moves[i], step.half_s) > reach_m) {
      beyond_.push_back(id);
      continue;
    }
    in_grid_.push_back(id);
    middles_.push_back(balls.middles[i]);
    moves_.push_back(balls.moves[i]);
  }
  const PointsView middles = std::span<const Point>(middles_);
  grid_ = {middles, *core::measure(middles, with), moves_, reach_m};
}

void search_beyond(const MovingBalls& balls, const Step& step, std::span<const PointId> beyond,
                   const core::Resources& with, const DecidePass& decide, Total& total,
                   core::Vector<core::FoundPairs>& found) {
  const SearchBeyond search(balls, step, beyond, decide, total);
  with.crew.split(balls.moves.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    search(begin, end, found[worker]);
  });
}

}  // namespace beespace::motion
