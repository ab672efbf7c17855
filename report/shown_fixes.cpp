#include "report/shown_fixes.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::report {
namespace {

// How far a fix lies from where a bee is at its time that flies straight from one to another.
double off_the_line(const Fix& from, const Fix& to, const Fix& fix) {
  const double share = (fix.time_s - from.time_s) / (to.time_s - from.time_s);
  const Point& p = from.position;
  const Point& q = to.position;
  return std::hypot(p.x + share * (q.x - p.x) - fix.position.x,
                    p.y + share * (q.y - p.y) - fix.position.y,
                    p.z + share * (q.z - p.z) - fix.position.z);
}

class Shown {
 public:
  Shown(std::size_t every, ShownFixes& shown) : every_(every), shown_(shown) {}

  // `gaps` are those of the track.
  void add(const Track& track, std::span<const Gap> gaps) {
    const std::vector<Fix>& fixes = track.fixes;
    const std::size_t begin = shown_.times_s.size();
    std::size_t last = 0;
    for (std::size_t i = 0; i < fixes.size(); ++i) {
      const bool gap_begins = !gaps.empty() && gaps.front().begins_s == fixes[i].time_s;
      const bool gap_ended = i > 0 && gap_ended_;
      gap_ended_ = gap_begins;
      if (i % every_ != 0 && i + 1 != fixes.size() && !gap_begins && !gap_ended) continue;
      for (std::size_t left_out = last + 1; left_out < i; ++left_out) {
        bend_m_ = std::max(bend_m_, off_the_line(fixes[last], fixes[i], fixes[left_out]));
      }
      if (i > 0) {
        shown_.shortest_s = std::min(shown_.shortest_s, fixes[i].time_s - fixes[last].time_s);
      }
      shown_.times_s.push_back(fixes[i].time_s);
      shown_.positions.push_back(fixes[i].position);
      if (gap_begins) {
        shown_.absent_after.push_back(static_cast<std::uint32_t>(shown_.times_s.size() - 1));
        gaps = gaps.subspan(1);
      }
      last = i;
    }
    gap_ended_ = false;
    shown_.counts.push_back(static_cast<std::uint32_t>(shown_.times_s.size() - begin));
    tolerance_m_ = std::max(tolerance_m_, track.tolerance_m);
  }

  [[nodiscard]] double error_m() const { return bend_m_ + tolerance_m_; }

 private:
  std::size_t every_;
  ShownFixes& shown_;
  bool gap_ended_ = false;
  double bend_m_ = 0.0;
  double tolerance_m_ = 0.0;
};

}  // namespace

ShownFixes shown_fixes(std::span<const Track> tracks, std::span<const Gap> gaps, std::size_t most) {
  std::size_t all = 0;
  for (const Track& track : tracks) all += track.fixes.size();
  ShownFixes shown;
  shown.every = std::max<std::size_t>(1, (all + most - 1) / most);
  Shown adding(shown.every, shown);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const auto of_track =
        std::find_if(gaps.begin(), gaps.end(), [i](const Gap& gap) { return gap.track != i; });
    const auto count = static_cast<std::size_t>(of_track - gaps.begin());
    adding.add(tracks[i], gaps.first(count));
    gaps = gaps.subspan(count);
  }
  shown.error_m = adding.error_m();
  return shown;
}

std::vector<ShownRun> runs_of(const ShownFixes& shown) {
  std::vector<ShownRun> runs;
  auto absent = shown.absent_after.begin();
  std::size_t begin = 0;
  for (std::size_t bee = 0; bee < shown.counts.size(); ++bee) {
    const std::size_t end = begin + shown.counts[bee];
    for (; absent != shown.absent_after.end() && *absent < end; ++absent) {
      runs.push_back({bee, begin, *absent + std::size_t{1}});
      begin = runs.back().end;
    }
    if (begin < end) runs.push_back({bee, begin, end});
    begin = end;
  }
  return runs;
}

}  // namespace beespace::report
