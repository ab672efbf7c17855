#include "motion/passing_search.hpp"

#include "core/density.hpp"
#include "cpu/row_sweeps.hpp"
#include "motion/pass_check.hpp"
#include "motion/size_levels.hpp"
#include "search/frame.hpp"
#include "search/question_grids.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <utility>

namespace beespace::motion {

namespace {

// The balls of a set in the order of its grid.
class SortedBalls {
 public:
  SortedBalls(const MovingBalls& balls, const PointId* ids, const Step& step,
              const search::Frame& frame, const core::SortedGrid& grid, const core::Resources& with)
      : balls_(with.memory, grid.size), reach_(with.memory, grid.size + core::kPadding) {
    std::fill_n(reach_.data() + grid.size, core::kPadding, 0.0F);
    const std::array<std::size_t, 3> order = frame.order();
    const double units_per_m = grid.units_per_m;
    const double units_per_mps = units_per_m * step.half_s;
    const auto half_clearance = static_cast<float>(
        0.5 * (step.clearance_m * units_per_m + PassCheck::margin_in(grid)) * kUpward);
    with.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        constexpr std::size_t kAhead = 32;
        if (i + kAhead < end) __builtin_prefetch(&balls.moves[grid.id[i + kAhead]]);
        const Move& move = balls.moves[grid.id[i]];
        const std::array<float, 3> velocity{move.x, move.y, move.z};
        const BallInGrid ball{grid.x[i],
                              grid.y[i],
                              grid.z[i],
                              ids == nullptr ? grid.id[i] : ids[grid.id[i]],
                              static_cast<float>(velocity[order[0]] * units_per_mps),
                              static_cast<float>(velocity[order[1]] * units_per_mps),
                              static_cast<float>(velocity[order[2]] * units_per_mps),
                              static_cast<float>(move.radius_m * units_per_m)};
        balls_[i] = ball;
        reach_[i] = (length_of_move(ball) + ball.radius + half_clearance) * kUpward;
      }
    });
  }

  [[nodiscard]] const BallInGrid* balls() const { return balls_.data(); }
  // How far each gets from the middle of its step, with its radius and half of the clearance.
  [[nodiscard]] const float* reach() const { return reach_.data(); }

 private:
  static constexpr float kUpward = 1.0F + 0x1p-20F;  // roots and sums are rounded

  static float length_of_move(const BallInGrid& ball) {
    return std::sqrt(ball.move_x * ball.move_x + ball.move_y * ball.move_y +
                     ball.move_z * ball.move_z);
  }

  core::Buffer<BallInGrid> balls_;
  core::Buffer<float> reach_;
};

// How many all workers have found.
class Total {
 public:
  explicit Total(std::uint64_t most) : most_(most) {}
  // Whether to go on.
  bool add(std::uint64_t found) {
    return found_.fetch_add(found, std::memory_order_relaxed) + found <= most_;
  }

 private:
  std::uint64_t most_;
  std::atomic<std::uint64_t> found_ = 0;
};

// What one worker finds. The kernel writes down sorted places; whenever it has written some, they
// are looked at, and the ids of those who pass take their place.
class Passes {
 public:
  Passes(core::FoundPairs& found, const PassCheck& check, const DecidePass& decide, Total& total)
      : found_(found), check_(check), decide_(decide), total_(total) {
    open();
  }
  Passes(const Passes&) = delete;
  Passes& operator=(const Passes&) = delete;
  ~Passes() = default;

  cpu::PairSink& sink() { return sink_; }
  void close() {
    keep_those_who_pass();
    chunk_->size = kept_;
  }

 private:
  static constexpr std::uint32_t kLookAt =
      1024;  // at a time: so few are still in the nearest cache
  static constexpr std::uint32_t kAhead = 16;

  void open() {
    chunk_ = &found_.open_chunk();
    kept_ = 0;
    const auto make_room = [](void* context) { return static_cast<Passes*>(context)->make_room(); };
    sink_ = {chunk_->first.data(), chunk_->second.data(), 0, kLookAt, make_room, this};
  }

  bool make_room() {
    keep_those_who_pass();
    if (kept_ + kLookAt + PassCheck::kAtOnce > core::FoundPairs::kChunk) {
      chunk_->size = kept_;
      const bool go_on = total_.add(kept_);
      open();
      return go_on;
    }
    sink_.size = kept_;
    sink_.capacity = kept_ + kLookAt;
    return true;
  }

  void keep_those_who_pass() {
    // The last look is at some more than there are: any place will do.
    for (std::uint32_t k = 0; k < PassCheck::kAtOnce; ++k) {
      sink_.first[sink_.size + k] = sink_.second[sink_.size + k] = 0;
    }
    const bool asks = static_cast<bool>(decide_);
    std::uint32_t kept = kept_;
    for (std::uint32_t k = kept_; k < sink_.size; k += PassCheck::kAtOnce) {
      for (std::uint32_t ahead = k + kAhead; ahead < k + kAhead + PassCheck::kAtOnce; ++ahead) {
        if (ahead >= sink_.size) break;
        check_.prefetch(sink_.first[ahead]);
        check_.prefetch(sink_.second[ahead]);
      }
      const PassCheck::Known known = check_({sink_.first + k, sink_.second + k});
      // Who passes is as good as random: nothing to branch on.
      unsigned keep = known.possible & ~known.known_before;
      if (asks) keep = decided(keep, keep & ~known.near, k);
      if (sink_.size - k < PassCheck::kAtOnce) keep &= (1U << (sink_.size - k)) - 1U;
      for (std::uint32_t lane = 0; lane < PassCheck::kAtOnce; ++lane) {
        // Kept ones end before this one.
        const PointId first = check_.id_of(sink_.first[k + lane]);
        const PointId second = check_.id_of(sink_.second[k + lane]);
        sink_.first[kept] = first;
        sink_.second[kept] = second;
        kept += keep >> lane & 1U;
      }
    }
    kept_ = kept;
  }

  // Those to keep, less the unsure ones about whom the answer is no.
  unsigned decided(unsigned keep, unsigned unsure, std::uint32_t k) const {
    for (; unsure != 0; unsure &= unsure - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(unsure));
      const PointId first = check_.id_of(sink_.first[k + lane]);
      const PointId second = check_.id_of(sink_.second[k + lane]);
      if (k + lane < sink_.size && !decide_(first, second)) keep &= ~(1U << lane);
    }
    return keep;
  }

  core::FoundPairs& found_;
  const PassCheck check_;
  const DecidePass& decide_;
  Total& total_;
  core::FoundPairs::Chunk* chunk_ = nullptr;
  std::uint32_t kept_ = 0;
  cpu::PairSink sink_{};
};

// How far a ball gets from the middle of its step.
double reach_of(const Move& move, double half_s) {
  const double x = move.x;
  const double y = move.y;
  const double z = move.z;
  return (std::sqrt(x * x + y * y + z * z) * half_s + double{move.radius_m}) * (1.0 + 0x1p-40);
}

// The reach up to which balls come into the grid: all, unless that costs more than to compare a few
// with everybody.
double reach_in_grid(const MovingBalls& balls, const Step& step, const core::Resources& with) {
  const auto levels =
      size_levels(balls.moves.size(), balls.reach_m, with.memory,
                  [&](std::size_t i) { return reach_of(balls.moves[i], step.half_s); });
  if (levels.size() == 1) return balls.reach_m;
  const core::DensitySample sample(balls.middles, with.memory);
  const auto cost = [&](const SizeLevel& level) {
    // Rows around, as far as the reach; see PredictionSteps.
    constexpr double kComparing = 0.25;
    return 0.5 * kComparing * sample.mates(2.6 * (step.clearance_m + 2.0 * level.size)) +
           kComparingBeyond * static_cast<double>(level.beyond);
  };
  return std::min_element(levels.begin(), levels.end(),
                          [&](const SizeLevel& a, const SizeLevel& b) { return cost(a) < cost(b); })
      ->size;
}

// Those who reach beyond the grid, and those in it by themselves.
class Divided {
 public:
  Divided(const MovingBalls& balls, const Step& step, double reach_m, const core::Resources& with)
      : in_grid_(&with.memory),
        beyond_(&with.memory),
        middles_(&with.memory),
        moves_(&with.memory) {
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

  [[nodiscard]] const MovingBalls& grid() const { return grid_; }
  // Who they are among all.
  [[nodiscard]] const PointId* in_grid() const { return in_grid_.data(); }
  [[nodiscard]] std::span<const PointId> beyond() const { return beyond_; }

 private:
  core::Vector<PointId> in_grid_;
  core::Vector<PointId> beyond_;
  core::Vector<Point> middles_;
  core::Vector<Move> moves_;
  MovingBalls grid_{};
};

// Pairs of balls in a grid; `ids` says who they are, or is null where they are numbered as such.
void search_grid(const MovingBalls& balls, const PointId* ids, const Step& step,
                 const core::Resources& with, const search::Choices& choices,
                 const DecidePass& decide, Total& total, core::Vector<core::FoundPairs>& found) {
  const search::Frame frame = search::Frame::of(balls.middles, balls.bounds, with);
  // Rounded sums and roots, and then some.
  constexpr double kUpward = 1.0 + 0x1p-20;
  const double reach_m = (step.clearance_m + 2.0 * balls.reach_m) * kUpward;
  const search::QuestionGrids grids(frame, {.threshold_m = reach_m}, with, choices);
  cpu::Question question = grids.question();
  question.limits = {-1.0F, -1.0F};  // it is the radii that say who meets
  const core::SortedGrid& grid = question.asked.grid;
  const SortedBalls sorted(balls, ids, step, frame, grid, with);
  const PassCheck check(grid, sorted.balls(), step);
  with.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    Passes passes(found[worker], check, decide, total);
    const cpu::MeetingSink meeting{sorted.reach(), passes.sink()};
    cpu::RowSweeps(question, cpu::decided_by(question))
        .for_each(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                  [&](const cpu::Sweep& swept) {
                    return question.kernels.collect_meeting(swept, meeting);
                  });
    passes.close();
  });
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
        if (chunk == nullptr || chunk->size == core::FoundPairs::kChunk) {
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

core::Vector<core::FoundPairs> find_passing(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with,
                                            const search::Choices& choices,
                                            const DecidePass& decide) {
  core::Vector<core::FoundPairs> found(&with.memory);
  found.reserve(with.crew.size());
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    found.emplace_back(with.memory.of(worker));
  }
  Total total(step.most);
  const double reach_m = reach_in_grid(balls, step, with);
  if (!(reach_m < balls.reach_m)) {
    search_grid(balls, nullptr, step, with, choices, decide, total, found);
    return found;
  }
  const Divided divided(balls, step, reach_m, with);
  search_grid(divided.grid(), divided.in_grid(), step, with, choices, decide, total, found);
  const SearchBeyond search(balls, step, divided.beyond(), decide, total);
  with.crew.split(balls.moves.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    search(begin, end, found[worker]);
  });
  return found;
}

}  // namespace beespace::motion
