#include "cli/fleet/set_beside_flown.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/recorded/unknown_while_set.hpp"
#include "cli/fleet/set_begins.hpp"
#include "cli/fleet/set_matches.hpp"
#include "cli/fleet/set_placement.hpp"

#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::cli {
namespace {

constexpr double kTolerance_m = 0.01;  // of shows, whose paths are curves

FixesByBee all_with_heights(const io::Recording& recording, const std::vector<Track>& tracks) {
  FixesByBee all;
  all.reserve(tracks.size());
  for (std::size_t bee = 0; bee < tracks.size(); ++bee) {
    all.push_back(fixes_with_heights(recording, tracks, bee));
  }
  return all;
}

// Those that are not among the matches.
void add_unmatched(const Matches& matches, const std::vector<std::string>& flown_ids,
                   const std::vector<std::string>& set_ids, const std::vector<Track>& set_tracks,
                   SetBesideFlown& both) {
  for (std::size_t i = 0; i < flown_ids.size(); ++i) {
    const bool is_set = std::any_of(matches.pairs.begin(), matches.pairs.end(),
                                    [i](const Match& match) { return match.flown == i; });
    if (!is_set) both.only_flown.push_back(flown_ids[i]);
  }
  for (std::size_t i = 0; i < set_ids.size(); ++i) {
    const bool is_flown = std::any_of(matches.pairs.begin(), matches.pairs.end(),
                                      [i](const Match& match) { return match.set == i; });
    if (is_flown) continue;
    const std::vector<Fix>& fixes = set_tracks[i].fixes;
    const double seconds = fixes.empty() ? 0.0 : fixes.back().time_s - fixes.front().time_s;
    both.only_set.push_back({set_ids[i], seconds});
  }
}

}  // namespace

Result<SetBesideFlown> set_beside_flown(const io::Recording& flown, const io::Recording& set,
                                        const SetOptions& options, const MaxGaps& max_gaps) {
  SetBesideFlown both;
  const std::vector<std::string> flown_ids = ids_of(flown);
  const std::vector<std::string> set_ids = ids_of(set);
  Matches matches = matches_of(flown_ids, set_ids);
  auto flown_tracks = tracks_of(flown, analysis::Geometry::kSpace, kTolerance_m);
  if (!flown_tracks) return flown_tracks.error();
  auto set_tracks = tracks_of(set, analysis::Geometry::kSpace, kTolerance_m);
  if (!set_tracks) return set_tracks.error();
  if (matches.pairs.empty()) {
    match_by_take_offs(all_with_heights(flown, *flown_tracks), all_with_heights(set, *set_tracks),
                       matches);
  }
  const auto begins_s = begins_of(flown, set, options, *set_tracks, matches.pairs, both.notes);
  if (Status together = bring_together(flown, set, options, matches.pairs, *set_tracks, both.notes);
      !together) {
    // Both are asked for at once where both are missing.
    Error error = together.error();
    if (!begins_s && !options.begins) error.message += "; and " + begins_s.error().message;
    return error;
  }
  if (!begins_s) return begins_s.error();
  analysis::keep_paths_whole(set, max_gaps.set.seconds, *set_tracks);
  for (Track& track : *set_tracks) {
    for (Fix& fix : track.fixes) fix.time_s += *begins_s;
  }
  if (Status settled =
          settle_matches(*flown_tracks, *set_tracks, flown_ids, set_ids, matches, both.notes);
      !settled) {
    return settled.error();
  }
  add_unmatched(matches, flown_ids, set_ids, *set_tracks, both);
  const std::vector<Gap> unknown = analysis::unknown_spans_of(flown, *flown_tracks, max_gaps.flown);
  for (const Match& match : matches.pairs) {
    Track& of_set = (*set_tracks)[match.set];
    Track& of_flown = (*flown_tracks)[match.flown];
    both.unknown.push_back(analysis::unknown_while_set(
        of_set, of_flown, static_cast<PointId>(match.flown), unknown, max_gaps.flown));
    both.bees.push_back({std::move(of_set), std::move(of_flown)});
    both.flown_ids.push_back(flown_ids[match.flown]);
    both.set_ids.push_back(set_ids[match.set]);
  }
  return both;
}

}  // namespace beespace::cli
