#include "analysis/recorded/jump_spans.hpp"

#include "analysis/recorded/own_gaps.hpp"

#include "io/recording/jumped_stretches.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace beespace::analysis {
namespace {

auto order_of_gap(const Gap& gap) {
  return std::tuple(gap.track, gap.begins_s, gap.ends_s);
}

io::JumpsOf jumps_of(const io::Recording& recording) {
  return {recording.frame, recording.of_aircraft};
}

}  // namespace

std::vector<Gap> jump_spans(const io::Recording& recording) {
  std::vector<Gap> spans;
  if (recording.missing.jumping == 0) return spans;
  for (std::size_t track = 0; track < recording.bees.size(); ++track) {
    const io::RecordedBee& bee = recording.bees[track];
    for (const io::JumpedStretch& stretch : io::jumped_stretches(bee, jumps_of(recording))) {
      spans.push_back({static_cast<PointId>(track), bee.fixes[stretch.before].time_s,
                       bee.fixes[stretch.behind].time_s});
    }
  }
  return spans;
}

void leave_out_jumps(const io::Recording& recording, std::vector<Conflict>& conflicts) {
  if (recording.missing.jumping == 0 || conflicts.empty()) return;
  std::unordered_map<PointId, std::vector<TimeSpan>> legs;  // of those in conflict
  const auto jumps_all_the_time = [&](PointId bee, const Conflict& conflict) {
    auto known = legs.find(bee);
    if (known == legs.end()) {
      known = legs.emplace(bee, io::jumping_legs(recording.bees[bee], jumps_of(recording))).first;
    }
    return std::any_of(known->second.begin(), known->second.end(), [&](const TimeSpan& leg) {
      return leg.begins_s < conflict.begins_s && conflict.ends_s < leg.ends_s;
    });
  };
  std::erase_if(conflicts, [&](const Conflict& conflict) {
    return jumps_all_the_time(conflict.first, conflict) ||
           jumps_all_the_time(conflict.second, conflict);
  });
}

std::vector<Gap> lost_spans(const io::Recording& recording, const MaxGap& max_gap) {
  std::vector<Gap> spans;
  if (max_gap.asked) return spans;
  for (std::size_t track = 0; track < recording.bees.size(); ++track) {
    for (const TimeSpan& lost : recording.bees[track].lost) {
      spans.push_back({static_cast<PointId>(track), lost.begins_s, lost.ends_s});
    }
  }
  return joined_gaps(std::move(spans), own_gaps(recording, max_gap));
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
