#include "cli/fleet/set_placement.hpp"

#include "analysis/recorded/begins_in_air.hpp"
#include "analysis/scene/place_on_earth.hpp"
#include "analysis/scene/placed_tracks.hpp"
#include "cli/fleet/fleet_errors.hpp"
#include "io/bytes/number_text.hpp"
#include "report/placement.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr std::string_view kNoGround =
    "; that is not told by what was flown, in which no take-off is seen: it must be known";

// How high z = 0 of what was set lies, in the heights of what was flown, and what tells it.
struct Ground {
  double height_m = 0.0;
  std::string told_by = {};
};

double middle_of(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// By where bees took off as they say themselves, or stood as they were set to when they were first
// heard of: nothing where no more than half of them tell it.
std::optional<Ground> ground_of(const io::Recording& flown, const std::vector<Track>& set,
                                const std::vector<Match>& matches) {
  std::vector<double> heights;
  heights.reserve(matches.size());
  bool all_stood = true;
  for (const Match& match : matches) {
    const io::RecordedBee& bee = flown.bees[match.flown];
    if (bee.fixes.empty() || set[match.set].fixes.empty()) continue;
    const bool stood = analysis::may_stand_at_first(flown, static_cast<PointId>(match.flown));
    if (!stood && !bee.took_off_at_m) continue;
    all_stood = all_stood && stood;
    const double height_m = stood ? bee.fixes.front().position.z : *bee.took_off_at_m;
    heights.push_back(height_m - set[match.set].fixes.front().position.z);
  }
  if (heights.empty() || 2 * heights.size() <= matches.size()) return std::nullopt;
  const double height_m = std::round(middle_of(std::move(heights)) * 10.0) / 10.0;
  return Ground{height_m, all_stood ? "where drones stood on the ground at their first fixes"
                                    : "by the heights from which drones took off, as they say,"};
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
                                        const std::optional<Ground>& ground,
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
  if (!ground) {
    message += kNoGround;
  } else if (!place.y_to_the_right) {
    message += "; " + ground->told_by + " that is " + origin_text(place, ground->height_m);
  }
  return to_be_said(std::move(message));
}

Result<report::Placement> placement_of_set(const io::Recording& flown, const io::Recording& set,
                                           const SetOptions& options,
                                           const std::optional<Ground>& ground,
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
    return own_placement(flown, *set.show->place, ground, notes);
  }
  std::string message =
      "what was flown is in degrees, and what was set in metres: say with --origin "
      "lon,lat,height,heading where x = y = z = 0 of what was set is, how high by the heights of "
      "what was flown, and where x points (in degrees from north: 90 where x is east)";
  if (!ground) {
    message += kNoGround;
  } else {
    message += "; the height is about " + io::exact(ground->height_m) + " m, " + ground->told_by +
               ": as in --origin lon,lat," + io::exact(ground->height_m) + ",90";
  }
  return to_be_said(message + about_place(set));
}

}  // namespace

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
  const auto ground = ground_of(flown, set_tracks, matches);
  const auto placement = placement_of_set(flown, set, options, ground, notes);
  if (!placement) return placement.error();
  if (Status placed = analysis::place_tracks(set_tracks, *placement); !placed) return placed;
  notes.push_back("what was set is " + analysis::placement_text(*placement));
  return std::monostate{};
}

}  // namespace beespace::cli
