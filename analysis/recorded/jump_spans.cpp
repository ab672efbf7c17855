#include "analysis/recorded/jump_spans.hpp"

#include "io/recording/jumps.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

auto order_of_gap(const Gap& gap) {
  return std::tuple(gap.track, gap.begins_s, gap.ends_s);
}

const Velocity* velocity_at(const io::RecordedBee& bee, std::size_t fix) {
  return bee.velocities.empty() ? nullptr : &bee.velocities[fix];
}

// To which of its fixes it jumps.
std::vector<std::size_t> jumps_of(const io::RecordedBee& bee, io::Frame frame) {
  std::vector<std::size_t> found;
  io::Jumps jumps(bee.fixes, bee.velocities, frame);
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    if (jumps.take(bee.fixes[i], velocity_at(bee, i), frame)) found.push_back(i);
  }
  return found;
}

// With which of the next jumps it comes back to where it can have got from before jump `out`: what
// lies between was somewhere else. `out` itself where there is none.
std::size_t way_back(const io::RecordedBee& bee, io::Frame frame,
                     const std::vector<std::size_t>& jumps, std::size_t out) {
  constexpr std::size_t kMostBetween = 8;
  const std::size_t before = jumps[out] - 1;
  io::Jumps from(bee.fixes, bee.velocities, frame);
  from.take(bee.fixes[before], velocity_at(bee, before), frame);
  const std::size_t end = std::min(jumps.size(), out + 1 + kMostBetween);
  for (std::size_t i = out + 1; i < end; ++i) {
    const std::size_t fix = jumps[i];
    if (!from.jumps_to(bee.fixes[fix], velocity_at(bee, fix), frame)) return i;
  }
  return out;
}

}  // namespace

std::vector<Gap> jump_spans(const io::Recording& recording) {
  std::vector<Gap> spans;
  if (recording.missing.jumping == 0) return spans;
  for (std::size_t track = 0; track < recording.bees.size(); ++track) {
    const io::RecordedBee& bee = recording.bees[track];
    const std::vector<std::size_t> jumps = jumps_of(bee, recording.frame);
    for (std::size_t i = 0; i < jumps.size(); ++i) {
      const std::size_t back = way_back(bee, recording.frame, jumps, i);
      spans.push_back({static_cast<PointId>(track), bee.fixes[jumps[i] - 1].time_s,
                       bee.fixes[jumps[back]].time_s});
      i = back;
    }
  }
  return spans;
}

std::vector<Gap> lost_spans(const io::Recording& recording, const MaxGap& max_gap) {
  std::vector<Gap> spans;
  if (max_gap.asked) return spans;
  for (std::size_t track = 0; track < recording.bees.size(); ++track) {
    for (const TimeSpan& lost : recording.bees[track].lost) {
      spans.push_back({static_cast<PointId>(track), lost.begins_s, lost.ends_s});
    }
  }
  return spans;
}

std::vector<Gap> doubtful_spans(const io::Recording& recording, const MaxGap& max_gap) {
  return joined_gaps(jump_spans(recording), lost_spans(recording, max_gap));
}

bool is_within(const std::vector<Gap>& spans, PointId track, double time_s) {
  const auto behind = std::lower_bound(spans.begin(), spans.end(), std::pair(track, time_s),
                                       [](const Gap& gap, const std::pair<PointId, double>& at) {
                                         return std::pair(gap.track, gap.begins_s) < at;
                                       });
  if (behind == spans.begin()) return false;
  const Gap& gap = *std::prev(behind);
  return gap.track == track && time_s < gap.ends_s;
}

std::vector<Gap> joined_gaps(std::vector<Gap> some, const std::vector<Gap>& more) {
  if (more.empty()) return some;
  some.insert(some.end(), more.begin(), more.end());
  std::sort(some.begin(), some.end(),
            [](const Gap& a, const Gap& b) { return order_of_gap(a) < order_of_gap(b); });
  some.erase(std::unique(some.begin(), some.end()), some.end());
  return some;
}

}  // namespace beespace::analysis
