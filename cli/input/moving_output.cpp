#include "cli/input/moving_output.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/recorded/findings.hpp"
#include "analysis/text/bee_name.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/block_writer.hpp"
#include "cli/output/json_units.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/moment_text.hpp"
#include "io/units/units.hpp"

#include <beespace/version.hpp>

#include <cmath>

namespace beespace::cli {
namespace {

std::string inputs_of(const MovingRequest& request) {
  const std::string& first = request.inputs.front();
  std::string text = first == "-" ? "standard input" : first;
  if (request.inputs.size() > 1) text += " and " + io::grouped(request.inputs.size() - 1) + " more";
  return printable(text);
}

void append_skipped(std::string& out, const io::Recording& recording) {
  append_summary_line(out, "skipped",
                      io::counted(recording.skipped_count, "bad record", "bad records"));
  for (const Error& error : recording.skipped) {
    append_summary_line(out, "", printable(to_string(error)));
  }
  if (recording.skipped_count > recording.skipped.size()) {
    append_summary_line(
        out, "",
        "and " + io::grouped(recording.skipped_count - recording.skipped.size()) + " more");
  }
}

void write_input(io::JsonWriter& json, const io::Recording& recording,
                 const MovingRequest& request) {
  const std::string_view datum = analysis::datum_text(recording.heights);
  json.begin_object("input", io::JsonLayout::kLines).begin_array("files");
  for (const std::string& file : request.inputs) json.value(file == "-" ? "<stdin>" : file);
  json.end();
  json.member("format", recording.format_description);
  json.member("frame", recording.frame == io::Frame::kWgs84 ? "wgs84" : "metres");
  json.member("reason", recording.frame_reason);
  json.member("heights", io::known_if(!datum.empty(), datum));
  write_units(json.key("units"), recording.units);
  json.member("times", io::clock_text(recording));
  json.member("dimensions", recording.flat ? 2u : 3u);
  json.member("bees", recording.bees.size()).member("skipped", recording.skipped_count);
  json.member("notes", recording.notes);
  json.end();
}

}  // namespace

void append_frame_lines(std::string& out, io::Frame frame, const std::string& reason,
                        io::HeightDatum heights, bool flat) {
  const bool degrees = frame == io::Frame::kWgs84;
  std::string text = degrees ? "WGS84 longitude, latitude, height" : "metres";
  if (flat) text = degrees ? "WGS84 longitude, latitude, without heights" : "metres, in a plane";
  if (!reason.empty()) text += ": " + printable(reason);
  append_summary_line(out, "frame", text);
  const std::string_view datum = analysis::datum_text(heights);
  if (!datum.empty()) append_summary_line(out, "heights", datum);
}

std::string input_summary(const io::Recording& recording, const MovingRequest& request) {
  std::string out;
  append_summary_line(out, "input",
                      inputs_of(request) + " (" + io::byte_count(recording.bytes) + ", " +
                          recording.format_description + ")");
  append_frame_lines(out, recording.frame, recording.frame_reason, recording.heights,
                     recording.flat);
  append_units(out, recording.units);
  append_note(out, analysis::metres_note(recording.units, recording.frame, request.threshold));
  append_vertical(out, request.vertical, recording.height_unit);
  if (recording.flat && request.vertical) {
    append_summary_line(out, "note",
                        "there are no heights: all count as at the same one, so that --vertical "
                        "keeps no two apart");
  }
  for (const std::string& note : recording.notes) {
    append_summary_line(out, "note", printable(note));
  }
  if (recording.skipped_count > 0) append_skipped(out, recording);
  return out;
}

std::string separation_typed(const MovingRequest& request) {
  if (request.separation != nullptr) {
    return " --separation " + std::string(request.separation->name);
  }
  std::string text;
  const auto add = [&text](const char* option, const std::optional<io::StatedLength>& length) {
    if (!length) return;
    text.append(" ").append(option).append(" ").append(io::exact(length->value));
    if (!length->bare) text.append(io::symbol_of(length->unit));
  };
  add("--threshold", request.threshold);
  add("--vertical", request.vertical);
  return text;
}

std::string separation_summary(const MovingRequest& request, double threshold_m,
                               const io::Recording& recording, bool aircraft) {
  std::string text = separation_text(threshold_m, request.vertical_m, request.inclusive,
                                     request.threshold, request.vertical) +
                     usual_text(request.separation);
  if (request.threshold_m) return text;
  const std::string_view words = analysis::default_threshold(recording, threshold_m).words;
  if (!words.empty()) return text + std::string(words);
  return text + kDefaultThresholdWords +
         (aircraft ? "; of aircraft --separation has the usual ones" : "");
}

void append_traffic_hint(std::string& out, const io::Recording& recording,
                         const MovingRequest& request, double threshold_m) {
  constexpr double kLeastOfControl_m = 1'852.0;  // what keeps apart by flight levels, too
  if (request.vertical || recording.flat || recording.frame != io::Frame::kWgs84 ||
      !(recording.of_aircraft || recording.height_unit == io::Unit::kFoot) ||
      threshold_m < kLeastOfControl_m) {
    return;
  }
  append_summary_line(out, "note",
                      "the threshold is of the straight line, and flight levels 1000 ft apart are "
                      "closer than that: --vertical 1000ft leaves out who is kept apart by height");
}

std::string pair_text(const Conflict& conflict, const io::Recording& recording) {
  return printable(text_of(analysis::name_at(conflict.closest_s, conflict.first, recording))) +
         " and " +
         printable(text_of(analysis::name_at(conflict.closest_s, conflict.second, recording)));
}

bool in_aviation(const MovingRequest& request, const io::Recording& recording) {
  return in_aviation(request.load.units.convention, recording.height_unit, request.threshold,
                     request.vertical);
}

namespace {

// Whether a length is stated, or taken, in a unit of small things.
io::Unit if_small(io::Unit unit) {
  const bool small = unit == io::Unit::kMicrometre || unit == io::Unit::kMillimetre ||
                     unit == io::Unit::kCentimetre;
  return small ? unit : io::Unit::kUnstated;
}

io::Unit small_unit(const MovingRequest& request, const io::Recording& recording) {
  if (request.threshold) return if_small(request.threshold->unit);
  for (const io::UnitTaken& taken : recording.units) {
    if (taken.of.starts_with('x')) return if_small(taken.unit);
  }
  return io::Unit::kUnstated;
}

// Rather than in nautical miles, of which little is nothing.
bool in_feet(const MovingRequest& request, double threshold_m) {
  constexpr double kLeastInMiles = 0.1;
  if (request.threshold && request.threshold->unit == io::Unit::kFoot) return true;
  return !(request.threshold && request.threshold->unit == io::Unit::kNauticalMile) &&
         io::from_metric(threshold_m, io::Unit::kNauticalMile) < kLeastInMiles;
}

// Below a limit by what says nothing: a rounding, in units in which both are rounded.
bool is_just_under(double metres, double limit_m) {
  // Instants since 1970 are rounded to 0.2 us, in which heights change by some millionths of a
  // foot.
  constexpr double kNothing = 1e-7;
  return metres < limit_m && metres > limit_m - kNothing * limit_m;
}

std::string in_unit(double metres, double limit_m, io::Unit unit, int decimals) {
  const double value = io::from_metric(metres, unit);
  const double limit = io::from_metric(limit_m, unit);
  const std::string name = " " + std::string(io::symbol_of(unit));
  if (is_just_under(metres, limit_m)) {
    const int needed = limit == std::round(limit) ? 0 : limit < 10.0 ? 3 : 1;
    return "just under " + io::grouped(limit, needed) + name;
  }
  return io::grouped_below(limit, value, decimals) + name;
}

// A rounding of what would be 0 has many digits that say nothing.
std::string length_text(double metres, double limit_m) {
  if (is_just_under(metres, limit_m)) return "just under " + io::length(limit_m);
  return metres > 0.0 && metres < 0.001 ? std::string("under 1 mm")
                                        : io::length_below(limit_m, metres);
}

std::string horizontal_text(double metres, const Distances& distances) {
  const double limit_m = distances.threshold_m;
  if (distances.small != io::Unit::kUnstated) {
    // To a tenth of a millimetre, or of a micrometre.
    const bool centimetres = distances.small == io::Unit::kCentimetre;
    const std::string name = " " + std::string(io::symbol_of(distances.small));
    const double least = centimetres ? 0.01 : 0.1;
    if (metres == 0.0) return "0" + name;
    if (io::from_metric(metres, distances.small) < least) return "under " + io::exact(least) + name;
    return in_unit(metres, limit_m, distances.small, centimetres ? 2 : 1);
  }
  if (!distances.aviation) return length_text(metres, limit_m);
  const std::string miles_or_feet =
      distances.feet ? in_unit(metres, limit_m, io::Unit::kFoot,
                               io::decimals_around(io::from_metric(limit_m, io::Unit::kFoot)))
                     : in_unit(metres, limit_m, io::Unit::kNauticalMile, 3);
  return miles_or_feet + " (" + length_text(metres, limit_m) + ")";
}

std::string vertical_text(double metres, const Distances& distances) {
  const double limit_m = distances.vertical_m.value_or(0.0);
  if (!distances.aviation) return length_text(metres, limit_m);
  return in_unit(metres, limit_m, io::Unit::kFoot, 0) + " (" + length_text(metres, limit_m) + ")";
}

}  // namespace

Distances distances_of(const MovingRequest& request, const io::Recording& recording,
                       double threshold_m) {
  Distances distances;
  distances.aviation = in_aviation(request, recording);
  if (!distances.aviation) distances.small = small_unit(request, recording);
  distances.feet = in_feet(request, threshold_m);
  distances.threshold_m = threshold_m;
  distances.vertical_m = request.vertical_m;
  distances.inclusive = request.inclusive;
  return distances;
}

std::string distance_text(double metres, const Distances& distances) {
  return horizontal_text(metres, distances);
}

namespace {

// What it is at the end of a conflict at a limit that is not reached within.
double within(double metres, double limit_m, const Distances& distances, Told told) {
  const bool at_limit = told == Told::kConflict && !distances.inclusive && metres >= limit_m;
  return at_limit ? std::nextafter(limit_m, 0.0) : metres;
}

}  // namespace

std::string encounter_text(const Conflict& conflict, const io::Recording& recording,
                           const Distances& distances, Told told) {
  const auto worst =
      told == Told::kConflict && distances.worst ? distances.worst(conflict) : std::nullopt;
  Conflict moved = conflict;
  if (worst) moved.closest_s = worst->time_s;
  const auto apart = worst ? std::optional(worst->apart) : distances.of(conflict);
  const auto horizontal = [&](double metres) {
    return horizontal_text(within(metres, distances.threshold_m, distances, told), distances);
  };
  const auto vertical = [&](double metres) {
    return vertical_text(within(metres, distances.vertical_m.value_or(0.0), distances, told),
                         distances);
  };
  std::string text = pair_text(moved, recording) + ", ";
  text += apart ? horizontal(apart->horizontal_m) + " horizontally and " +
                      vertical(apart->vertical_m) + " vertically apart"
                : horizontal(conflict.closest_m) + " apart";
  return text + " at " + io::moment_text(moved.closest_s, recording);
}

void append_low(std::string& out, const analysis::LowConflicts& low, const io::Recording& recording,
                const MovingRequest& request, const Distances& distances,
                const std::vector<Conflict>& standing) {
  if (!request.ignore_below_m) {
    const bool of_grid = std::all_of(standing.begin(), standing.end(), [&](const Conflict& one) {
      return analysis::may_be_of_grid(one.closest_m, distances.threshold_m);
    });
    const bool with_standing = !standing.empty() && of_grid && !recording.of_aircraft;
    if (!with_standing && low.would_leave_out == 0) return;
    return append_summary_line(
        out, "",
        "--ignore-below " + io::exact(distances.threshold_m) + " leaves out " +
            (low.would_leave_out > 0 ? io::counted(low.would_leave_out, "conflict", "conflicts")
                                     : std::string("conflicts")) +
            " of two that are both lower than that above where they took off");
  }
  const auto closest = low.closest();
  std::string text = analysis::low_text(low) + " (--ignore-below)";
  if (closest) text = red(text) + ", the closest " + encounter_text(*closest, recording, distances);
  append_summary_line(out, "left out", text);
  const std::string unknown = analysis::takeoff_unknown_text(low);
  if (!unknown.empty()) append_summary_line(out, "", unknown);
}

void write_low(io::JsonWriter& json, const analysis::LowConflicts& low,
               const MovingRequest& request) {
  if (!request.ignore_below_m) return;
  json.member("ignore_below_m", low.below_m).member("ignored_count", low.left_out.size());
  json.member("take_off_not_known_count", low.bees_not_known);
}

void add_apart_columns(std::vector<RowColumn>& columns, const Distances& distances) {
  if (!distances.apart) return;
  columns.push_back({"horizontal_m"});
  columns.push_back({"vertical_m"});
  if (!distances.aviation) return;
  columns.push_back({"horizontal_NM"});
  columns.push_back({"vertical_ft"});
}

void add_apart(std::vector<Value>& row, const std::optional<analysis::Apart>& apart,
               const Distances& distances) {
  if (!distances.apart) return;
  if (!apart) {
    row.resize(row.size() + (distances.aviation ? 4 : 2));
    return;
  }
  row.emplace_back(apart->horizontal_m);
  row.emplace_back(apart->vertical_m);
  if (!distances.aviation) return;
  row.emplace_back(io::from_metric(apart->horizontal_m, io::Unit::kNauticalMile));
  row.emplace_back(io::from_metric(apart->vertical_m, io::Unit::kFoot));
}

void add_worst_columns(std::vector<RowColumn>& columns, const Distances& distances) {
  if (!distances.worst) return;
  columns.insert(columns.end(), {{"worst_s", nullptr, "worst"},
                                 {"worst_share"},
                                 {"worst_horizontal_m"},
                                 {"worst_vertical_m"}});
  if (!distances.aviation) return;
  columns.insert(columns.end(), {{"worst_horizontal_NM"}, {"worst_vertical_ft"}});
}

void add_worst(std::vector<Value>& row, const Conflict& conflict, const Distances& distances) {
  if (!distances.worst) return;
  const auto worst = distances.worst(conflict);
  if (!worst) {
    row.resize(row.size() + 2);
    return add_apart(row, std::nullopt, distances);
  }
  row.insert(row.end(), {worst->time_s, worst->share});
  add_apart(row, worst->apart, distances);
}

std::optional<Conflict> told_as_closest(const std::vector<Conflict>& conflicts,
                                        const std::optional<Conflict>& closest,
                                        const Distances& distances) {
  if (!distances.worst || conflicts.empty()) return closest;
  return analysis::pairs_in_conflict(conflicts, distances.worst).front().worst;
}

std::optional<Rows> worst_row(const std::vector<Conflict>& conflicts,
                              const io::Recording& recording, const Distances& distances) {
  if (!distances.worst || conflicts.empty()) return std::nullopt;
  const Conflict worst = *told_as_closest(conflicts, std::nullopt, distances);
  const auto moment = distances.worst(worst);
  if (!moment) return std::nullopt;
  Rows rows{
      {{"first", "first_label"}, {"second", "second_label"}, {"time_s"}, {"share"}},
      {{analysis::name_at(moment->time_s, worst.first, recording),
        analysis::name_at(moment->time_s, worst.second, recording), moment->time_s, moment->share}},
      analysis::has_labels(recording)};
  add_apart_columns(rows.columns, distances);
  add_apart(rows.rows.front(), moment->apart, distances);
  set_labels_apart(rows);
  return rows;
}

Rows conflict_rows(const std::vector<Conflict>& conflicts, const io::Recording& recording,
                   bool with_certain, const Distances& distances) {
  Rows rows{{{"first", "first_label"},
             {"second", "second_label"},
             {"begins_s", nullptr, "begins"},
             {"closest_s", nullptr, "closest"},
             {"closest_m"},
             {"ends_s", nullptr, "ends"}},
            {},
            analysis::has_labels(recording),
            io::calendar_of(recording)};
  if (with_certain) rows.columns.push_back({"certain"});
  add_apart_columns(rows.columns, distances);
  rows.columns.push_back({"lasts_s"});
  add_worst_columns(rows.columns, distances);
  rows.rows.reserve(conflicts.size());
  for (const Conflict& c : conflicts) {
    rows.rows.push_back({analysis::name_at(c.closest_s, c.first, recording),
                         analysis::name_at(c.closest_s, c.second, recording), c.begins_s,
                         c.closest_s, c.closest_m, c.ends_s});
    if (with_certain) rows.rows.back().emplace_back(c.certain);
    add_apart(rows.rows.back(), distances.of(c), distances);
    rows.rows.back().emplace_back(c.ends_s - c.begins_s);
    add_worst(rows.rows.back(), c, distances);
  }
  return rows;
}

void write_head(io::JsonWriter& json, const io::Recording& recording, const MovingRequest& request,
                double threshold_m) {
  json.member("version", version()).member("command", request.command);
  write_input(json, recording, request);
  json.member("threshold_m", threshold_m).member("vertical_m", request.vertical_m);
  write_vertical(json.key("vertical"), request.vertical, recording.height_unit);
  json.member("inclusive", request.inclusive);
}

void write_answer(Rows rows, const MovingRequest& request, const JsonHead& head, const char* key,
                  io::AtomicOutput& output) {
  if (request.form.form != Form::kText) set_labels_apart(rows);
  switch (request.form.form) {
    case Form::kText:
      return write_rows_as_text(rows, output);
    case Form::kCsv:
      add_dates(rows);
      return write_rows_as_csv(rows, output);
    case Form::kGeoJson:  // refused before: answering_request
      return;
    case Form::kJson: {
      BlockWriter out(output);
      io::JsonWriter json(out.text);
      json.begin_object(io::JsonLayout::kLines);
      head(json);
      json.begin_array(key, io::JsonLayout::kRows);
      for (const auto& row : rows.rows) {
        write_row(json, rows.columns, row);
        out.pass_on();
      }
      json.end().end();
      out.text += '\n';
      return;
    }
  }
}

}  // namespace beespace::cli
