#include "cli/fleet/set_beside_flown.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/take_off_offset.hpp"
#include "analysis/recorded/tracks.hpp"
#include "analysis/scene/place_on_earth.hpp"
#include "analysis/scene/placed_tracks.hpp"
#include "cli/fleet/set_matches.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr double kTolerance_m = 0.01;  // of shows, whose paths are curves

Error cannot_compare(std::string what) {
  return {ErrorCode::kUnsupportedFormat, std::move(what), {}};
}

Error to_be_said(std::string what) {
  return {ErrorCode::kInvalidArgument, std::move(what), {}};
}

double middle_of(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// How high z = 0 of what was set lies where bees stand as they were set to when they were first
// heard of, in the heights of what was flown.
std::optional<double> height_of_ground_m(const io::Recording& flown, const std::vector<Track>& set,
                                         const std::vector<Match>& matches) {
  std::vector<double> heights;
  for (const Match& match : matches) {
    const std::vector<Fix>& fixes = flown.bees[match.flown].fixes;
    if (fixes.empty() || set[match.set].fixes.empty()) continue;
    heights.push_back(fixes.front().position.z - set[match.set].fixes.front().position.z);
  }
  if (heights.empty()) return std::nullopt;
  return std::round(middle_of(std::move(heights)) * 10.0) / 10.0;
}

std::string origin_text(const io::ShowPlace& place, double height_m) {
  return "--origin " + io::exact(place.longitude_deg) + "," + io::exact(place.latitude_deg) + "," +
         io::exact(height_m) + "," + io::exact(place.heading_deg);
}

// What the show says of its place that cannot be taken.
std::string about_place(const io::Recording& set) {
  const auto note = std::find_if(set.notes.begin(), set.notes.end(), [](const auto& text) {
    return text.starts_with("the location of the show is not taken");
  });
  return note == set.notes.end() ? std::string() : " (" + *note + ")";
}

std::string_view datum_text(io::HeightDatum heights) {
  if (heights == io::HeightDatum::kEllipsoid) return "above the WGS84 ellipsoid";
  if (heights == io::HeightDatum::kPressure) return "by pressure";
  if (heights == io::HeightDatum::kMeanSeaLevel) return "above mean sea level";
  return "as they are";
}

// What was set in metres by where it says itself that it is.
Result<report::Placement> own_placement(const io::Recording& flown, const io::ShowPlace& place,
                                        const std::optional<double>& ground_m,
                                        std::vector<std::string>& notes) {
  report::Placement placement = analysis::placement_of(place);
  if (flown.heights == io::HeightDatum::kHome) {
    placement.origin.height_m = 0.0;
    placement.words = ", as the show says; heights of both count from the place of take-off";
    return placement;
  }
  const bool above_sea = flown.heights == io::HeightDatum::kMeanSeaLevel ||
                         flown.heights == io::HeightDatum::kUnstated;
  if (place.height_m && above_sea) {
    if (flown.heights == io::HeightDatum::kUnstated) {
      notes.emplace_back(
          "what heights of what was flown count from is not said: they are taken to be above mean "
          "sea level, as that of the show's place is; otherwise say --origin");
    }
    return placement;
  }
  std::string message =
      place.height_m ? "the show says how high its place is above mean sea level, but heights of "
                       "what was flown are " +
                           std::string(datum_text(flown.heights))
                     : std::string(
                           "the show says where it is, but not how high; heights of what was "
                           "flown are ") +
                           std::string(datum_text(flown.heights));
  message += ": say with --origin lon,lat,height,heading how high z = 0 is by these";
  if (ground_m && !place.y_to_the_right) {
    message += "; where drones stood on the ground at their first fixes that is " +
               origin_text(place, *ground_m);
  }
  return to_be_said(std::move(message));
}

Result<report::Placement> placement_of_set(const io::Recording& flown, const io::Recording& set,
                                           const SetOptions& options,
                                           const std::optional<double>& ground_m,
                                           std::vector<std::string>& notes) {
  if (flown.flat) {
    return cannot_compare(
        "what was flown has no heights, and what was set is in metres with heights: name the "
        "column of heights of what was flown with --columns");
  }
  if (options.origin) {
    report::Placement placement = *options.origin;
    placement.words = " (--origin), by heights as those of what was flown";
    return placement;
  }
  if (set.show && set.show->place) {
    return own_placement(flown, *set.show->place, ground_m, notes);
  }
  std::string message =
      "what was flown is in degrees, and what was set in metres: say with --origin "
      "lon,lat,height,heading where x = y = z = 0 of what was set is, how high by the heights of "
      "what was flown, and where x points (in degrees from north: 90 where x is east)";
  if (ground_m) {
    message += "; the height is about " + io::exact(*ground_m) +
               " m, where bees stood as set at their first fixes: as in --origin lon,lat," +
               io::exact(*ground_m) + ",90";
  }
  return to_be_said(message + about_place(set));
}

// Brings what was set into the frame of what was flown.
Status bring_together(const io::Recording& flown, const io::Recording& set,
                      const SetOptions& options, const std::vector<Match>& matches,
                      std::vector<Track>& set_tracks, std::vector<std::string>& notes) {
  if (flown.frame == set.frame) {
    if (!options.origin) return std::monostate{};
    return to_be_said(
        "--origin is for what was set in metres and flown in degrees, but both are in the same "
        "frame; leave it out");
  }
  if (flown.frame == io::Frame::kMetres) {
    return cannot_compare(
        "what was flown is in metres, and what was set in degrees; give both in the same frame");
  }
  const auto ground_m = height_of_ground_m(flown, set_tracks, matches);
  const auto placement = placement_of_set(flown, set, options, ground_m, notes);
  if (!placement) return placement.error();
  if (Status placed = analysis::place_tracks(set_tracks, *placement); !placed) return placed;
  notes.push_back("what was set is " + analysis::placement_text(*placement));
  return std::monostate{};
}

bool is_dated(const io::Recording& recording) {
  return recording.since_1970 || recording.clock;
}

// "--set-begins 2025-11-27T19:00:00.012Z", where that can be told by the take-off.
std::string begins_proposal(const io::Recording& flown, const std::vector<Track>& set,
                            const std::vector<Match>& matches) {
  std::vector<analysis::SetAndFlownFixes> bees;
  bees.reserve(matches.size());
  for (const Match& match : matches) {
    bees.push_back({set[match.set].fixes, flown.bees[match.flown].fixes});
  }
  const auto offset = analysis::take_off_offset(bees);
  if (!offset) return ", as in --set-begins 2024-05-01T19:00:00Z";
  const double begins_s = std::round(offset->seconds * 1e3) / 1e3;
  const std::string moment =
      flown.since_1970 ? io::calendar_of(flown).text(begins_s) : io::exact(begins_s);
  return ": by the take-off of " + io::noun_of(flown).counted(offset->bees) +
         ", when they are first " + io::exact(analysis::kTakenOff_m) +
         " m above where they began, that is --set-begins " + moment;
}

// By how much times of what was set are to be moved.
Result<double> begins_of(const io::Recording& flown, const io::Recording& set,
                         const SetOptions& options, const std::vector<Track>& set_tracks,
                         const std::vector<Match>& matches, std::vector<std::string>& notes) {
  if (options.begins) {
    if (is_dated(set)) {
      return to_be_said(
          "--set-begins is for times that count from the beginning of what was set, but these are "
          "dates or times of day; leave it out");
    }
    if (options.begins->since_1970 && !flown.since_1970) {
      return to_be_said(
          "--set-begins is a date, but times of what was flown are none; say it in seconds of that "
          "clock");
    }
    return options.begins->seconds;
  }
  if (is_dated(set) && !is_dated(flown)) {
    return cannot_compare(
        "what was set has dates or times of day, and times of what was flown count from a zero of "
        "their own; bring both to the same clock");
  }
  if (is_dated(flown) && !is_dated(set)) {
    return to_be_said(
        "times of what was set count from its beginning, and what was flown has dates or times of "
        "day: say with --set-begins when 0 s was" +
        begins_proposal(flown, set_tracks, matches));
  }
  if (set.show && !flown.show) {
    notes.emplace_back(
        "times of both are taken to count from one zero, the beginning of the show; otherwise say "
        "--set-begins, in seconds of what was flown");
  }
  return 0.0;
}

}  // namespace

Result<SetBesideFlown> set_beside_flown(const io::Recording& flown, const io::Recording& set,
                                        const SetOptions& options, double max_gap_s) {
  SetBesideFlown both;
  const std::vector<std::string> flown_ids = ids_of(flown);
  const std::vector<std::string> set_ids = ids_of(set);
  Matches matches = matches_of(flown_ids, set_ids);
  auto flown_tracks = tracks_of(flown, analysis::Geometry::kSpace, kTolerance_m);
  if (!flown_tracks) return flown_tracks.error();
  auto set_tracks = tracks_of(set, analysis::Geometry::kSpace, kTolerance_m);
  if (!set_tracks) return set_tracks.error();
  if (matches.pairs.empty() && flown.frame != set.frame) {
    return cannot_compare(
        "no bee was both set and flown: their ids differ, and so do their numbers");
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
  analysis::keep_paths_whole(set, max_gap_s, *set_tracks);
  for (Track& track : *set_tracks) {
    for (Fix& fix : track.fixes) fix.time_s += *begins_s;
  }
  if (Status settled =
          settle_matches(*flown_tracks, *set_tracks, flown_ids, set_ids, matches, both.notes);
      !settled) {
    return settled.error();
  }
  for (const Match& match : matches.pairs) {
    both.bees.push_back(
        {std::move((*set_tracks)[match.set]), std::move((*flown_tracks)[match.flown])});
    both.flown_ids.push_back(flown_ids[match.flown]);
    both.set_ids.push_back(set_ids[match.set]);
  }
  both.only_one = flown.bees.size() + set.bees.size() - 2 * both.bees.size();
  return both;
}

}  // namespace beespace::cli
