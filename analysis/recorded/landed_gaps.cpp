#include "analysis/recorded/landed_gaps.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>

namespace beespace::analysis {
namespace {

// What of the time between two moments at which a bee is known lies between two such moments that
// are more than `max_gap_s` apart: the bee is known in `landed`, too.
void add_unknown(PointId track, const TimeSpan& between, const std::vector<TimeSpan>& landed,
                 double max_gap_s, std::vector<Gap>& unknown) {
  double known_s = between.begins_s;
  const auto until = [&](double next_s) {
    if (next_s - known_s > max_gap_s) unknown.push_back({track, known_s, next_s});
  };
  for (const TimeSpan& span : landed) {
    if (span.ends_s <= between.begins_s || span.begins_s >= between.ends_s) continue;
    until(span.begins_s);
    known_s = std::max(known_s, span.ends_s);
  }
  until(between.ends_s);
}

}  // namespace

std::vector<Gap> unknown_gaps(const io::Recording& recording, const std::vector<Gap>& gaps,
                              double max_gap_s) {
  const auto& bees = recording.bees;
  if (std::all_of(bees.begin(), bees.end(),
                  [](const io::RecordedBee& bee) { return bee.landed.empty(); })) {
    return gaps;
  }
  std::vector<Gap> unknown;
  for (const Gap& gap : gaps) {
    add_unknown(gap.track, {gap.begins_s, gap.ends_s}, bees[gap.track].landed, max_gap_s, unknown);
  }
  for (std::size_t track = 0; track < bees.size(); ++track) {
    const auto& landed = bees[track].landed;
    if (landed.empty() || bees[track].fixes.empty()) continue;
    const double first_s = bees[track].fixes.front().time_s;
    const double last_s = bees[track].fixes.back().time_s;
    const auto add = [&](auto from, auto to) {
      const TimeSpan between{from->ends_s, to->begins_s};
      add_unknown(static_cast<PointId>(track), between, landed, max_gap_s, unknown);
    };
    // From the last time on the ground to the first fix it is in the air, and so at the end.
    const auto flies = std::find_if(landed.begin(), landed.end(),
                                    [&](const TimeSpan& span) { return span.begins_s >= first_s; });
    const auto ends = std::find_if(landed.begin(), landed.end(),
                                   [&](const TimeSpan& span) { return span.ends_s > last_s; });
    if (flies != landed.begin()) add(landed.begin(), std::prev(flies));
    if (ends != landed.end()) add(ends, std::prev(landed.end()));
  }
  std::sort(unknown.begin(), unknown.end(), [](const Gap& a, const Gap& b) {
    return std::tuple(a.track, a.begins_s, a.ends_s) < std::tuple(b.track, b.begins_s, b.ends_s);
  });
  unknown.erase(std::unique(unknown.begin(), unknown.end()), unknown.end());
  return unknown;
}

bool stand_throughout(const io::Recording& recording, const Conflict& conflict) {
  const auto stands = [&](PointId track) {
    const auto& landed = recording.bees[track].landed;
    return std::any_of(landed.begin(), landed.end(), [&](const TimeSpan& span) {
      return span.begins_s <= conflict.begins_s && conflict.ends_s <= span.ends_s;
    });
  };
  return stands(conflict.first) && stands(conflict.second);
}

bool has_landed(const io::Recording& recording, PointId track, double time_s, double max_gap_s) {
  if (track >= recording.bees.size()) return false;
  const io::RecordedBee& bee = recording.bees[track];
  const auto behind =
      std::upper_bound(bee.landed.begin(), bee.landed.end(), time_s,
                       [](double at_s, const TimeSpan& span) { return at_s < span.begins_s; });
  const bool before =
      behind != bee.landed.begin() && time_s - std::prev(behind)->ends_s <= max_gap_s;
  return before || (behind != bee.landed.end() && behind->begins_s - time_s <= max_gap_s);
}

}  // namespace beespace::analysis
