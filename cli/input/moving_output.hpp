// What `predict` and `replay` both say: the input on the summary's lines and in the JSON document,
// conflicts as rows, and the answer written where it is wanted.
#pragma once

#include "analysis/recorded/apart.hpp"
#include "analysis/recorded/least_height.hpp"
#include "analysis/recorded/low_conflicts.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/output/rows.hpp"
#include "io/bytes/atomic_output.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

// What positions are in, and why where that is known; what heights are counted from.
void append_frame_lines(std::string& out, io::Frame frame, const std::string& reason,
                        io::HeightDatum heights, bool flat = false);

// The lines about what was read.
std::string input_summary(const io::Recording& recording, const MovingRequest& request);

// " --separation enroute", " --threshold 5NM --vertical 1000ft": as it was typed, to be typed
// again; empty where nothing was.
std::string separation_typed(const MovingRequest& request);

// "5 m (closer than), as the show declares". Of `aircraft` the default is hardly what is meant.
std::string separation_summary(const MovingRequest& request, double threshold_m,
                               const io::Recording& recording, bool aircraft = false);

// Of aircraft, of which only a distance is asked for: what would leave out those that flight levels
// keep apart.
void append_traffic_hint(std::string& out, const io::Recording& recording,
                         const MovingRequest& request, double threshold_m);

// Whether distances are told in nautical miles and feet too: where the thresholds or the heights of
// the input are, or --units says so.
bool in_aviation(const MovingRequest& request, const io::Recording& recording);

// How distances are told: with a vertical threshold horizontally and vertically, and perhaps in
// nautical miles and feet too.
struct Distances {
  analysis::ApartOf apart = {};               // where there is a vertical threshold
  analysis::WorstOf worst = {};               // likewise, where it is looked for
  analysis::LeastHeightOf least_height = {};  // or nothing
  bool aviation = false;
  bool feet = false;  // and what is too close is stated in feet, not in nautical miles
  io::Unit small = io::Unit::kUnstated;  // or in mm or cm, where the threshold or positions are
  // What they are shown beside: what is below one of these is never rounded up to it.
  double threshold_m = 0.0;
  std::optional<double> vertical_m = {};
  bool inclusive = false;  // who is just as far apart is in conflict, too

  [[nodiscard]] std::optional<analysis::Apart> of(const Conflict& conflict) const {
    return apart ? apart(conflict) : std::nullopt;
  }
};

Distances distances_of(const MovingRequest& request, const io::Recording& recording,
                       double threshold_m);

// "4.31 m", "0.002 NM (4.31 m)", "4.3 mm": a distance, horizontal with a vertical threshold.
std::string distance_text(double metres, const Distances& distances);

// What is said of conflicts in which one flies and the other stands.
inline const char* with_standing_words(const io::Recording& recording) {
  return recording.of_aircraft ? "with an aircraft that stands still"
                               : "with a drone on the ground";
}

// Whether what is told is a conflict: who is at a limit then was closer than it just before or
// after.
enum class Told : bool { kDistance, kConflict };

// "drone_01 and drone_02"; "drone_01 and drone_02, 4.31 m apart at 63.2 s": when they are closest,
// and of a conflict with a vertical threshold when they are worst in it.
std::string pair_text(const Conflict& conflict, const io::Recording& recording);
std::string encounter_text(const Conflict& conflict, const io::Recording& recording,
                           const Distances& distances, Told told = Told::kDistance);

// The line about conflicts that --ignore-below leaves out, where the option is given; where it is
// not, and `standing` are conflicts with drones on the ground, what to type: but for one so close
// that no grid of places of take-off explains it.
void append_low(std::string& out, const analysis::LowConflicts& low, const io::Recording& recording,
                const MovingRequest& request, const Distances& distances,
                const std::vector<Conflict>& standing);
// Members in JSON, where the option is given.
void write_low(io::JsonWriter& json, const analysis::LowConflicts& low,
               const MovingRequest& request);

// With a vertical threshold the columns of how far two are apart, and their values, which are empty
// where that is not known.
void add_apart_columns(std::vector<RowColumn>& columns, const Distances& distances);
void add_apart(std::vector<Value>& row, const std::optional<analysis::Apart>& apart,
               const Distances& distances);

// Likewise of when they are worst in it, where that is looked for.
void add_worst_columns(std::vector<RowColumn>& columns, const Distances& distances);
void add_worst(std::vector<Value>& row, const Conflict& conflict, const Distances& distances);

// The closest of these, as it was found; with a vertical threshold the worst.
std::optional<Conflict> told_as_closest(const std::vector<Conflict>& conflicts,
                                        const std::optional<Conflict>& closest,
                                        const Distances& distances);

// The columns of the worst of those conflicts; nothing where it is not looked for, or there is
// none.
std::optional<Rows> worst_row(const std::vector<Conflict>& conflicts,
                              const io::Recording& recording, const Distances& distances);

// first, second, begins_s, closest_s, closest_m, ends_s; certain, where there are tolerances; and
// with a vertical threshold how far apart they are horizontally and vertically then, and when they
// are worst in it.
Rows conflict_rows(const std::vector<Conflict>& conflicts, const io::Recording& recording,
                   bool with_certain, const Distances& distances);

// The first members of the JSON document, up to and with the separation.
void write_head(io::JsonWriter& json, const io::Recording& recording, const MovingRequest& request,
                double threshold_m);

// Writes the rows in the form wished for; in JSON under `key`, behind the members of `head`.
using JsonHead = std::function<void(io::JsonWriter&)>;
void write_answer(Rows rows, const MovingRequest& request, const JsonHead& head, const char* key,
                  io::AtomicOutput& output);

}  // namespace beespace::cli
