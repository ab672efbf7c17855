#include "avoidance/vicinity.hpp"

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "motion/passing/passing_search.hpp"
#include "search/pair_answer.hpp"
#include "search/tuning_overrides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::avoidance {

namespace {

// As far as floats are accurate, however small the units in which they count.
constexpr double kFarthest_m = 0x1p+60;

float rounded_up(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

}  // namespace

// As balls that do not move: in a grid, or where they are much larger than nearly all others,
// compared with all of them.
Status Vicinity::find(const AgentStates& agents, Crew& crew) {
  memory_.start_call();
  const core::Resources with{crew, memory_};
  const std::size_t size = agents.size();
  look_for_far(agents);
  const auto bounds = core::measure(agents.middles(), with);
  if (!bounds) return bounds.error();
  core::Buffer<motion::Move> balls(memory_, size);
  crew.split(size, [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t bee = begin; bee < end; ++bee) {
      const bool far = reaches_far(static_cast<PointId>(bee));
      balls[bee] = {0.0F, 0.0F, 0.0F, far ? 0.0F : rounded_up(agents.reach(bee))};
    }
  });
  const double farthest_m = std::min(agents.farthest_reach(), kFarthest_m);
  const auto found = motion::find_passing(
      {agents.middles(), *bounds, {balls.data(), size}, double{rounded_up(farthest_m)}},
      {.half_s = 0.0, .clearance_m = agents.meet(0.0, 0.0)}, with, search::TuningOverrides{});
  search::RowVectors rows(rows_, size);
  rows.open(2 * core::size_of(found), with);
  core::order_pairs(found, core::Direction::kBothWays, size, with, rows.place(),
                    [&](const core::SortedPairs& sorted) { rows.take(sorted); });
  return std::monostate{};
}

void Vicinity::look_for_far(const AgentStates& agents) {
  agents_ = agents.size();
  far_.clear();
  is_far_.clear();
  if (agents.farthest_reach() <= kFarthest_m) return;
  for (PointId bee = 0; bee < agents_; ++bee) {
    is_far_.push_back(agents.reach(bee) > kFarthest_m ? 1 : 0);
    if (is_far_.back() != 0) far_.push_back(bee);
  }
}

Status Vicinity::find_within(const PointsView& places, double within_m, const RunOptions& run) {
  far_.clear();
  const SearchOptions around{.threshold_m = within_m, .threads = run.threads, .stop = run.stop};
  return engine_.find_neighbors(places, around, rows_);
}

}  // namespace beespace::avoidance
