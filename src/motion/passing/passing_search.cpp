#include "motion/passing/passing_search.hpp"

#include "base/stopping.hpp"
#include "motion/passing/oversized_balls.hpp"
#include "motion/passing/pass_check.hpp"
#include "search/query_grids.hpp"
#include "search/search_domain.hpp"
#include "sweep/row_sweeps.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace beespace::motion {

namespace {

// The balls of a set in the order of its grid.
class SortedBalls {
 public:
  SortedBalls(const MovingBalls& balls, const PointId* ids, const Step& step,
              const search::SearchDomain& domain, const core::SortedGrid& grid,
              const core::Resources& with)
      : balls_(with.memory, grid.size), reach_(with.memory, grid.size + core::kPadding) {
    std::fill_n(reach_.data() + grid.size, core::kPadding, 0.0F);
    const std::array<std::size_t, 3> order = domain.order();
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
  // How far each gets from the midpoint of its step, with its radius and half of the clearance.
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

// What one worker finds. The kernel writes down sorted places; whenever it has written some, they
// are checked, and replaced by the ids of those that pass.
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
  // So few at a time are still in the nearest cache.
  static constexpr std::uint32_t kLookAt = 1024;
  static constexpr std::uint32_t kAhead = 16;

  void open() {
    chunk_ = &found_.open_chunk();
    kept_ = 0;
    const auto make_room = [](void* context) { return static_cast<Passes*>(context)->make_room(); };
    sink_ = {chunk_->first.data(), chunk_->second.data(), 0, kLookAt, make_room, this};
  }

  bool make_room() {
    keep_those_who_pass();
    if (kept_ + kLookAt + PassCheck::kAtOnce > chunk_->capacity) {
      chunk_->size = kept_;
      const bool go_on = total_.add(kept_);
      open();
      return go_on && !core::is_stopping();
    }
    sink_.size = kept_;
    sink_.capacity = kept_ + kLookAt;
    // A row may be all of the swarm, and is swept at once.
    return !core::is_stopping();
  }

  void keep_those_who_pass() {
    // The last group may be longer than the list: any place will do.
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
      unsigned keep = known.possible & ~known.known_before;
      if (asks) keep = decided(keep, keep & ~known.near, k);
      if (sink_.size - k < PassCheck::kAtOnce) keep &= (1U << (sink_.size - k)) - 1U;
      if (keep == 0) continue;  // nearly always where steps are long
      // Which of them pass is as good as random: nothing to branch on.
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

  // Those to keep, less the unsure ones that do not pass.
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

// Pairs of balls in a grid; `ids` has their ids, or is null where they are numbered as such.
void search_grid(const MovingBalls& balls, const PointId* ids, const Step& step,
                 const core::Resources& with, const search::TuningOverrides& tuning,
                 const DecidePass& decide, Total& total, core::Vector<core::FoundPairs>& found) {
  const search::SearchDomain domain = search::SearchDomain::of(balls.middles, balls.bounds, with);
  // Rounded sums and roots, and then some.
  constexpr double kUpward = 1.0 + 0x1p-20;
  const double reach_m = (step.clearance_m + 2.0 * balls.reach_m) * kUpward;
  const search::QueryGrids grids(domain, {.threshold_m = reach_m}, with, tuning);
  cpu::SweepQuery question = grids.question();
  question.limits = {-1.0F, -1.0F};  // the radii decide which meet
  const core::SortedGrid& grid = question.asked.grid;
  const SortedBalls sorted(balls, ids, step, domain, grid, with);
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

}  // namespace

core::Vector<core::FoundPairs> find_passing(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with,
                                            const search::TuningOverrides& tuning,
                                            const DecidePass& decide) {
  core::Vector<core::FoundPairs> found(&with.memory);
  found.reserve(with.crew.size());
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    found.emplace_back(with.memory.of(worker));
  }
  Total total(step.most);
  const double reach_m = reach_in_grid(balls, step, with);
  if (!(reach_m < balls.reach_m)) {
    search_grid(balls, nullptr, step, with, tuning, decide, total, found);
    return found;
  }
  const Partition partition(balls, step, reach_m, with);
  search_grid(partition.grid(), partition.in_grid(), step, with, tuning, decide, total, found);
  search_beyond(balls, step, partition.beyond(), with, decide, total, found);
  return found;
}

}  // namespace beespace::motion
