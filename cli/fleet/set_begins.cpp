#include "cli/fleet/set_begins.hpp"

#include "analysis/recorded/begins_in_air.hpp"
#include "analysis/recorded/take_off_offset.hpp"
#include "cli/fleet/fleet_errors.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recorded_noun.hpp"

#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace beespace::cli {
namespace {

using analysis::TakeOffOffset;

// Drones react late, and climb otherwise than they were set to, by less.
constexpr double kMostLate_s = 1.0;

bool is_dated(const io::Recording& recording) {
  return recording.since_1970 || recording.clock;
}

// What the take-offs say, and how many bees are in the air before any.
struct TakeOffs {
  std::vector<TakeOffOffset> flights = {};
  std::size_t in_air = 0;
  std::size_t bees = 0;
};

TakeOffs take_offs_of(const io::Recording& flown, const io::Recording& set,
                      const std::vector<Track>& set_tracks, const std::vector<Match>& matches) {
  TakeOffs take_offs;
  take_offs.bees = matches.size();
  std::vector<analysis::SetAndFlownFixes> bees;
  bees.reserve(matches.size());
  for (const Match& match : matches) {
    const bool stood = analysis::may_stand_at_first(flown, static_cast<PointId>(match.flown));
    if (!stood) ++take_offs.in_air;
    bees.push_back(
        {fixes_with_heights(set, set_tracks, match.set), flown.bees[match.flown].fixes, stood});
  }
  take_offs.flights = analysis::take_off_offsets(bees);
  return take_offs;
}

std::string typed_begins(double seconds, const io::Recording& flown) {
  const double begins_s = std::round(seconds * 1e3) / 1e3;
  return "--set-begins " +
         (flown.since_1970 ? io::calendar_of(flown).text(begins_s) : io::exact(begins_s));
}

// "--set-begins 2025-11-27T19:00:00.012Z", where that can be told by the take-off.
std::string begins_proposal(const io::Recording& flown, const TakeOffs& take_offs) {
  constexpr const char* kAsIn = ", as in --set-begins 2024-05-01T19:00:00Z";
  if (take_offs.flights.empty() && 2 * take_offs.in_air >= take_offs.bees && take_offs.in_air > 0) {
    return "; that must be known, as " + io::grouped(take_offs.in_air) + " of " +
           io::noun_of(flown).counted(take_offs.bees) +
           " may be in the air already at their first fixes, so that no take-off tells it" + kAsIn;
  }
  if (take_offs.flights.empty()) return kAsIn;
  const TakeOffOffset& first = take_offs.flights.front();
  std::string text = ": by the take-off of " + io::noun_of(flown).counted(first.bees) +
                     ", when they are first " + io::exact(analysis::kTakenOff_m) +
                     " m above where they began, that is " + typed_begins(first.seconds, flown);
  for (std::size_t i = 1; i < take_offs.flights.size(); ++i) {
    text += "; but they take off again: for flight " + std::to_string(i + 1) + " it is " +
            typed_begins(take_offs.flights[i].seconds, flown);
  }
  return text;
}

// Where take-offs say that it was begun at another time, or again.
void note_other_flights(const io::Recording& flown, const TakeOffs& take_offs, double begins_s,
                        bool may_be_said, std::vector<std::string>& notes) {
  if (take_offs.flights.empty()) return;
  const auto nearest =
      std::min_element(take_offs.flights.begin(), take_offs.flights.end(),
                       [&](const TakeOffOffset& a, const TakeOffOffset& b) {
                         return std::abs(a.seconds - begins_s) < std::abs(b.seconds - begins_s);
                       });
  const double late_s = nearest->seconds - begins_s;
  if (std::abs(late_s) > kMostLate_s) {
    notes.push_back(
        io::noun_of(flown).counted(nearest->bees) +
        (nearest->bees == 1 ? " takes off " : " take off ") + io::grouped(std::abs(late_s), 1) +
        " s " + (late_s > 0.0 ? "later" : "earlier") +
        " than set: if that is the clock and no delay, deviations are not those of "
        "flying" +
        (may_be_said ? "; by the take-off it is " + typed_begins(nearest->seconds, flown)
                     : std::string()));
  }
  for (auto other = take_offs.flights.begin(); other != take_offs.flights.end(); ++other) {
    if (other == nearest) continue;
    notes.push_back("what was flown has another flight, which is not compared: " +
                    io::noun_of(flown).counted(other->bees) + " take off for it " +
                    (other->seconds < nearest->seconds ? "before" : "after") + " this one" +
                    (may_be_said ? "; " + typed_begins(other->seconds, flown) + " compares that"
                                 : std::string()));
  }
}

// What was typed, by the clock of what was flown.
Result<double> typed_seconds(const io::Recording& flown, const io::Recording& set,
                             const SetBegins& typed) {
  if (is_dated(set)) {
    return to_be_said(
        "--set-begins is for times that count from the beginning of what was set, but these are "
        "dates or times of day; leave it out");
  }
  if (!typed.since_1970 || flown.since_1970) return typed.seconds;
  if (flown.clock && flown.clock->dated) {
    return to_be_said(
        "--set-begins is a date in a zone, and of the dates of what was flown it is not said in "
        "which zone they are: say it with --time-zone, as in --time-zone Europe/Madrid");
  }
  if (flown.clock) {
    return to_be_said(
        "--set-begins is a date, but what was flown has times of day; say it in seconds since "
        "midnight, as in --set-begins 68400");
  }
  return to_be_said(
      "--set-begins is a date, but times of what was flown are none; say it in seconds of that "
      "clock, as in --set-begins 12.5");
}

}  // namespace

Result<double> begins_of(const io::Recording& flown, const io::Recording& set,
                         const SetOptions& options, const std::vector<Track>& set_tracks,
                         const std::vector<Match>& matches, std::vector<std::string>& notes) {
  const TakeOffs take_offs = take_offs_of(flown, set, set_tracks, matches);
  if (options.begins) {
    auto typed = typed_seconds(flown, set, *options.begins);
    if (typed) note_other_flights(flown, take_offs, *typed, true, notes);
    return typed;
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
        begins_proposal(flown, take_offs));
  }
  if (set.show && !flown.show) {
    notes.emplace_back(
        "times of both are taken to count from one zero, the beginning of the show; otherwise say "
        "--set-begins, in seconds of what was flown");
  }
  note_other_flights(flown, take_offs, 0.0, !is_dated(set), notes);
  return 0.0;
}

}  // namespace beespace::cli
