#include "report/map/map_tracks.hpp"

#include "report/number_label.hpp"
#include "report/shown_fixes.hpp"

#include <algorithm>

namespace beespace::report {
namespace {

// Ascending.
std::vector<PointId> chosen_bees(const RecordingFacts& facts, std::size_t most) {
  std::vector<bool> chosen(facts.tracks.size());
  std::size_t count = 0;
  const auto choose = [&](PointId bee) {
    if (count >= most || chosen[bee] || facts.tracks[bee].fixes.empty()) return;
    chosen[bee] = true;
    ++count;
  };
  for (const AtRisk& at_risk : facts.at_risk) choose(at_risk.bee);
  for (PointId bee = 0; bee < facts.tracks.size(); ++bee) choose(bee);
  std::vector<PointId> bees;
  for (PointId bee = 0; bee < facts.tracks.size(); ++bee) {
    if (chosen[bee]) bees.push_back(bee);
  }
  return bees;
}

// With the numbers that the chosen ones have among themselves.
std::vector<Gap> gaps_of(const std::vector<PointId>& bees, const std::vector<Gap>& all) {
  std::vector<Gap> gaps;
  for (const Gap& gap : all) {
    const auto at = std::lower_bound(bees.begin(), bees.end(), gap.track);
    if (at == bees.end() || *at != gap.track) continue;
    gaps.push_back({static_cast<PointId>(at - bees.begin()), gap.begins_s, gap.ends_s});
  }
  return gaps;
}

}  // namespace

MapTracks map_tracks(const RecordingFacts& facts, std::size_t most_tracks, std::size_t most_fixes) {
  const std::vector<PointId> bees = chosen_bees(facts, most_tracks);
  std::vector<Track> tracks;
  tracks.reserve(bees.size());
  for (const PointId bee : bees) tracks.push_back(facts.tracks[bee]);
  const ShownFixes shown = shown_fixes(tracks, gaps_of(bees, facts.gaps), most_fixes);
  MapTracks map;
  for (const ShownRun& run : runs_of(shown)) {
    const PointId bee = bees[run.bee];
    if (map.tracks.empty() || map.tracks.back().bee != bee) map.tracks.push_back({bee, {}});
    std::vector<Fix>& fixes = map.tracks.back().runs.emplace_back();
    for (std::size_t i = run.begin; i < run.end; ++i) {
      fixes.push_back({shown.times_s[i], shown.positions[i]});
    }
  }
  const auto with_fixes = static_cast<std::size_t>(
      std::count_if(facts.tracks.begin(), facts.tracks.end(),
                    [](const Track& track) { return !track.fixes.empty(); }));
  if (bees.size() < with_fixes) {
    map.notes.push_back("of " + count_label(with_fixes) + " paths, " + count_label(bees.size()) +
                        " are in the file, those in conflict first");
  }
  if (shown.every > 1) {
    map.notes.push_back("one fix in " + count_label(shown.every) + " is in the file");
  }
  return map;
}

std::size_t marks_shown(std::size_t count, const std::string& what,
                        std::vector<std::string>& notes) {
  if (count <= kMostMarks) return count;
  notes.push_back("of " + count_label(count) + " " + what + ", " + count_label(kMostMarks) +
                  " are in the file");
  return kMostMarks;
}

}  // namespace beespace::report
