#include "analysis/recorded/unknown_while_set.hpp"

#include "analysis/recorded/coverage.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace beespace::analysis {
namespace {

// Who is so near to where it begins or ends has hardly left it.
constexpr double kStillThere_m = 1.0;

bool is_there(const Fix& fix, const Point& place) {
  return distance(fix.position, place) <= kStillThere_m;
}

// When it is set to leave where it begins, and when to be where it ends. What stands all the time
// never leaves.
TimeSpan set_to_move(const std::vector<Fix>& set) {
  const Point& first = set.front().position;
  const Point& last = set.back().position;
  const auto leaves =
      std::find_if(set.begin(), set.end(), [&](const Fix& fix) { return !is_there(fix, first); });
  if (leaves == set.end()) return {set.back().time_s, set.back().time_s};
  const auto arrives =
      std::find_if(set.rbegin(), set.rend(), [&](const Fix& fix) { return !is_there(fix, last); });
  // The fix before it is away, and the one behind it.
  const double leaves_s = std::prev(leaves)->time_s;
  const double arrives_s = std::prev(arrives)->time_s;
  return {leaves_s, std::max(leaves_s, arrives_s)};
}

// In ascending order, those that touch joined.
std::vector<TimeSpan> joined(std::vector<TimeSpan> spans) {
  std::sort(spans.begin(), spans.end(),
            [](const TimeSpan& a, const TimeSpan& b) { return a.begins_s < b.begins_s; });
  std::vector<TimeSpan> apart;
  for (const TimeSpan& next : spans) {
    if (!apart.empty() && next.begins_s <= apart.back().ends_s) {
      apart.back().ends_s = std::max(apart.back().ends_s, next.ends_s);
    } else {
      apart.push_back(next);
    }
  }
  return apart;
}

}  // namespace

std::vector<Gap> unknown_spans_of(const io::Recording& recording, const std::vector<Track>& tracks,
                                  const MaxGap& max_gap) {
  std::vector<Gap> gaps;
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    const std::vector<Fix>& fixes = tracks[bee].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      if (fixes[i].time_s - fixes[i - 1].time_s <= max_gap.seconds) continue;
      gaps.push_back({static_cast<PointId>(bee), fixes[i - 1].time_s, fixes[i].time_s});
    }
  }
  return unknown_spans(recording, gaps, max_gap);
}

std::vector<TimeSpan> unknown_while_set(const Track& set, const Track& flown, PointId bee,
                                        const std::vector<Gap>& unknown, const MaxGap& max_gap) {
  std::vector<TimeSpan> spans;
  if (set.fixes.empty()) return spans;
  const TimeSpan all{set.fixes.front().time_s, set.fixes.back().time_s};
  if (flown.fixes.empty()) return {all};
  const auto add = [&](double begins_s, double ends_s) {
    const TimeSpan within{std::max(begins_s, all.begins_s), std::min(ends_s, all.ends_s)};
    if (within.begins_s < within.ends_s) spans.push_back(within);
  };
  const double first_s = flown.fixes.front().time_s;
  const double last_s = flown.fixes.back().time_s;
  for (const Gap& gap : unknown) {
    // Those beside its fixes are of others that were recorded then; what was set counts here.
    if (gap.track == bee) add(std::max(gap.begins_s, first_s), std::min(gap.ends_s, last_s));
  }
  const TimeSpan moves = set_to_move(set.fixes);
  if (first_s - moves.begins_s > max_gap.seconds) add(moves.begins_s, first_s);
  if (moves.ends_s - last_s > max_gap.seconds) add(last_s, moves.ends_s);
  return joined(std::move(spans));
}

double length_of(const std::vector<TimeSpan>& spans) {
  double seconds = 0.0;
  for (const TimeSpan& span : spans) seconds += span.ends_s - span.begins_s;
  return seconds;
}

}  // namespace beespace::analysis
