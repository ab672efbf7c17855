// What is settled of times once all is read: their order, clocks that begin again, and days alone.
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/left_out.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/recording/moment_text.hpp"
#include "io/recording/recording_assembly.hpp"
#include "io/recording/restarted_clock.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// Two bees of one id, or times that stand still.
constexpr LeftOutReason kElsewhere = {
    "with another place for a time at which the same bee has been heard elsewhere, farther away "
    "than it gets while times are rounded,",
    "if another column has the time of the position, name it with --columns time=..."};

}  // namespace

Error RecordingAssembly::conflict_error(const TimeConflict& conflict) const {
  const std::string first = place_text(conflict.first);
  std::string message = "bee " + excerpt(conflict.id) + " is at another place at the same time";
  if (facts_ && facts_->has_time) {
    const Calendar calendar{facts_->since_1970, options_.time_zone, facts_->clock};
    const std::string date = calendar.text(conflict.time_s);
    message += ", " + (date.empty() ? exact(conflict.time_s) + " s" : date) + ", in " + first +
               "; correct one of them, or name the column that tells the bees apart with "
               "--columns id=...";
  } else {
    message = "bee " + excerpt(conflict.id) + " comes twice, before in " + first +
              "; without a time each bee has one record";
  }
  return {ErrorCode::kTimeOrder, message + std::string(kOrLeaveOut), location_of(conflict.second)};
}

std::optional<Error> RecordingAssembly::settle_times() {
  std::vector<TimeConflict> conflicts;
  tracks_.settle(
      facts_ ? facts_->frame : recording_.frame,
      [&conflicts](const TimeConflict& conflict) { conflicts.push_back(conflict); },
      [this](const TimeConflict& conflict) { leave_out(kElsewhere, conflict.id); });
  std::sort(conflicts.begin(), conflicts.end(), [](const TimeConflict& a, const TimeConflict& b) {
    if (a.second.source != b.second.source) return a.second.source < b.second.source;
    return a.second.line < b.second.line;
  });
  for (const TimeConflict& conflict : conflicts) {
    if (auto error = bad(conflict_error(conflict), conflict.id)) return error;
  }
  return std::nullopt;
}

// Of dates it is known which are the same time.
bool RecordingAssembly::may_begin_again() const {
  const bool own_zero = facts_ && facts_->has_time && !facts_->since_1970 && !facts_->clock;
  return own_zero && !options_.one_clock && !tracks_.rounds_times();
}

Error RecordingAssembly::restart_error(const RestartedClock& restarted) const {
  const ErrorLocation place = location_of(restarted.begins);
  const std::string back =
      "from " + exact(restarted.from_s) + " s to " + exact(restarted.to_s) + " s, ";
  const bool of_two_files = restarted.before.source != restarted.begins.source;
  std::string message = "times begin again here: ";
  if (restarted.at_once) {
    message += counted(restarted.bees, "bee", "bees") + " go back at once, " + back;
  } else {
    message += "those of bee " + excerpt(tracks_.id(restarted.bee)) + " go back, " + back;
  }
  if (of_two_files) {
    message += "and are in " + place_text(restarted.before) +
               ", at other places at these times, as of two runs: then they cannot be compared; "
               "read the files each for itself";
  } else {
    message += "and go through the same times once more";
    if (restarted.bees > 1 && !restarted.at_once) {
      message += " (so do those of all " + std::to_string(restarted.bees) + " bees of this file)";
    }
    message += std::string(", as where a ") +
               (restarted.at_once ? "simulation was started again"
                                  : "simulation or a recording was started again, or two have one "
                                    "id") +
               ": two runs cannot be compared with each other; ";
    const bool splits_there = restarted.at_once || restarted.alone;
    message += splits_there ? "read each for itself"
                            : "write each run into a file of its own, and read each for itself";
    if (splits_there && place.line) {
      message += ", the first as 'head -n " + std::to_string(*place.line - 1) +
                 "' of this file gives it, the second with the header and what follows from here";
    }
  }
  if (!restarted.at_once) {
    message += "; if two have one id, name the column that tells them apart with --columns id=...";
  }
  return {ErrorCode::kTimeOrder, message + ", or, if all have one clock, say so with --one-clock",
          place};
}

std::optional<Error> RecordingAssembly::settle_restart() const {
  if (!may_begin_again() || frame_is_settled_) return std::nullopt;
  const auto restarted = tracks_.restarted(facts_->frame);
  if (!restarted) return std::nullopt;
  return restart_error(*restarted);
}

// Of one id in several files at once: two trials, or two animals, are not one.
std::optional<Error> RecordingAssembly::settle_files() const {
  if (!facts_ || frame_is_settled_ || tracks_.rounds_times()) return std::nullopt;
  const std::vector<TimeConflict> conflicts = tracks_.contradicting(facts_->frame);
  if (conflicts.empty()) return std::nullopt;
  const TimeConflict& conflict = conflicts.front();
  return Error{ErrorCode::kTimeOrder,
               "bee " + excerpt(conflict.id) +
                   " is in several files at the same time, and its place here, at " +
                   exact(conflict.time_s) + " s, does not go with that in " +
                   place_text(conflict.first) +
                   ": are they two? Give each an id of its own; files that are of different "
                   "trials are read each for itself",
               location_of(conflict.second)};
}

// Days without a time of day that may not be their midnights.
std::optional<Error> RecordingAssembly::settle_midnights() const {
  const auto doubt = bare_midnights_.doubt(tracks_);
  if (!doubt) return std::nullopt;
  return Error{ErrorCode::kNotANumber,
               "the time is a day alone, as R writes midnight, but " + doubt->why +
                   ": is it midnight? Write times out, as 2015-09-10 00:00:00 (in R: format(time, "
                   "\"%Y-%m-%d %H:%M:%S\")), or take the record out",
               location_of(doubt->origin)};
}

}  // namespace beespace::io
