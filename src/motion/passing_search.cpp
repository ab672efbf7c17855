#include "motion/passing_search.hpp"

#include "cpu/passing.hpp"
#include "search/frame.hpp"
#include "search/question_grids.hpp"

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
  return std::sqrt(x * x + y * y + z * z) * half_s + double{move.radius_m};
}

// The moves of a set in the order of its grid.
class SortedMoves {
 public:
  SortedMoves(const MovingBalls& balls, const search::Frame& frame, const core::SortedGrid& grid,
              double half_s, const core::Resources& with)
      : padded_(grid.size + core::kPadding), values_(with.memory, kArrays * padded_) {
    const std::array<std::size_t, 3> order = frame.order();
    const double units_per_m = grid.units_per_m;
    for (std::size_t part = 0; part < kArrays; ++part) {
      std::fill_n(values_.data() + part * padded_ + grid.size, core::kPadding, 0.0F);
    }
    with.crew.split(grid.size, [&](std::size_t begin, std::size_t end, unsigned) {
      for (std::size_t i = begin; i < end; ++i) {
        const Move& move = balls.moves[grid.id[i]];
        const std::array<float, 3> velocity{move.x, move.y, move.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          values_[axis * padded_ + i] =
              static_cast<float>(velocity[order[axis]] * half_s * units_per_m);
        }
        values_[3 * padded_ + i] = static_cast<float>(move.radius_m * units_per_m);
        values_[4 * padded_ + i] = static_cast<float>(reach_of(move, half_s) * units_per_m);
      }
    });
  }

  [[nodiscard]] cpu::Moves moves() const {
    const float* const first = values_.data();
    return {first, first + padded_, first + 2 * padded_, first + 3 * padded_, first + 4 * padded_};
  }

 private:
  static constexpr std::size_t kArrays = 5;

  std::size_t padded_;
  core::Buffer<float> values_;
};

// How far from the middle of its step a ball of the set reaches at most.
double farthest_reach(const MovingBalls& balls, double half_s, const core::Resources& with) {
  core::PerWorker<double> farthest(with);
  with.crew.split(balls.moves.size(), [&](std::size_t begin, std::size_t end, unsigned worker) {
    double most = 0.0;
    for (std::size_t i = begin; i < end; ++i)
      most = std::max(most, reach_of(balls.moves[i], half_s));
    farthest[worker].push_back(most);
  });
  double most = 0.0;
  for (const double reach : std::move(farthest).joined()) most = std::max(most, reach);
  return double{most} * (1.0 + 0x1p-20);  // floats have been rounded on the way
}

// Pairs of one worker, in chunks.
class Chunks {
 public:
  explicit Chunks(core::FoundPairs& found) : found_(found) { open(); }
  Chunks(const Chunks&) = delete;
  Chunks& operator=(const Chunks&) = delete;
  ~Chunks() { close(); }

  cpu::PairSink& sink() { return sink_; }

 private:
  void close() { chunk_->size = sink_.size; }
  void open() {
    chunk_ = &found_.open_chunk();
    const auto make_room = [](void* context) {
      auto& self = *static_cast<Chunks*>(context);
      self.close();
      self.open();
      return true;
    };
    sink_ = {
        chunk_->first.data(), chunk_->second.data(), 0, core::FoundPairs::kChunk, make_room, this};
  }

  core::FoundPairs& found_;
  core::FoundPairs::Chunk* chunk_ = nullptr;
  cpu::PairSink sink_{};
};

core::Vector<core::FoundPairs> sweep(const search::Frame& frame, const MovingBalls& balls,
                                     double farthest_m, const Step& step,
                                     const core::Resources& with, const search::Choices& choices) {
  core::Vector<core::FoundPairs> found(&with.memory);
  found.reserve(with.crew.size());
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
    found.emplace_back(with.memory.of(worker));
  }
  // Rounded sums and roots, and then some.
  constexpr double kUpward = 1.0 + 0x1p-30;
  const double reach_m = (step.clearance_m + 2.0 * farthest_m) * kUpward;
  const search::QuestionGrids grids(frame, {.threshold_m = reach_m}, with, choices);
  const cpu::Question question = grids.question();
  const core::SortedGrid& asked = question.asked.grid;
  const SortedMoves sorted(balls, frame, asked, step.half_s, with);
  const cpu::Moves moves = sorted.moves();
  // Positions are cut to whole units, as in core::SquaredLimits; moves and what the kernel makes of
  // them are wrong by some 2^-20 of a cell.
  const double margin = 3.0 + std::ldexp(1.0, static_cast<int>(asked.fraction_bits) - 17);
  const cpu::Clearance clearance{static_cast<float>(step.clearance_m * asked.units_per_m + margin),
                                 static_cast<float>(farthest_m * kUpward * asked.units_per_m)};
  const cpu::CollectPassing collect = cpu::collect_passing(choices.instruction_set);
  with.crew.split(asked.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
    if (begin == end) return;
    Chunks chunks(found[worker]);
    cpu::RowSweeps(question, cpu::decided_by(question))
        .for_each(static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                  [&](const cpu::Sweep& swept) {
                    return collect(swept, moves, moves, clearance, chunks.sink());
                  });
  });
  return found;
}

}  // namespace

core::Vector<core::FoundPairs> find_passing(const MovingBalls& balls, const Step& step,
                                            const core::Resources& with,
                                            const search::Choices& choices) {
  const Result<search::Frame> frame = search::Frame::of(balls.middles, with);
  const double farthest_m = farthest_reach(balls, step.half_s, with);
  return sweep(*frame, balls, farthest_m, step, with, choices);
}

}  // namespace beespace::motion
