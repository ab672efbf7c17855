#include "cli/detect/load_inputs.hpp"

#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/snapshot/recording_check.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/summary_line.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/load_points.hpp"
#include "io/points/loaded_points.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/feet_doubt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/position_columns.hpp"
#include "io/units/stated_length.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// Of one moment heights alone bear out that they are in feet, as names tell.
std::optional<Error> doubt_of_feet(const io::LoadedPoints& loaded, const std::string& path) {
  if (loaded.frame != io::Frame::kWgs84 || !io::FeetDoubt::concerns(loaded.units)) {
    return std::nullopt;
  }
  io::FeetDoubt feet;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  io::for_each_record(loaded, all, [&feet](const io::Record& record) {
    feet.take_height(record.geographic.height_m);
  });
  auto doubt = feet.doubt();
  if (doubt) doubt->location.source = io::source_name(path);
  return doubt;
}

Result<io::LoadedPoints> load_snapshot(const std::string& path, const io::LoadOptions& options,
                                       const std::optional<io::StatedLength>& threshold,
                                       const std::optional<io::StatedLength>& vertical) {
  auto loaded = io::load_points(path, options);
  if (!loaded) return analysis::or_recording(std::move(loaded).error(), path, options);
  if (auto problem = analysis::recording_problem(*loaded, path, options))
    return *std::move(problem);
  if (auto needed = analysis::threshold_needed(*loaded, threshold, vertical)) {
    return *std::move(needed);
  }
  const bool is_said = options.units.convention == io::UnitConvention::kAviation;
  if (auto doubt = doubt_of_feet(*loaded, path); doubt && !is_said) return *std::move(doubt);
  return loaded;
}

// Refused where they are to be unique.
Result<io::RepeatedIds> unless_repeated(const io::LoadedPoints& loaded, const std::string& path,
                                        bool unique) {
  io::RepeatedIds repeated = io::find_repeated_ids(loaded);
  if (!unique || repeated.count == 0) return repeated;
  return repeated_error(repeated, path);
}

std::optional<Error> datum_problem(const io::LoadedPoints& ours, const io::LoadedPoints& others) {
  if (can_compare(ours.heights, others.heights)) return std::nullopt;
  return usage_error("detect", "the heights of the two swarms cannot be compared: ours are " +
                                   std::string(analysis::datum_text(ours.heights)) + ", theirs " +
                                   std::string(analysis::datum_text(others.heights)) +
                                   "; take the same of both with --heights or --columns");
}

// Of 0 m for whatever has no height nothing follows beside heights that are known.
std::optional<Error> height_problem(const Inputs& inputs, const io::LoadedPoints& others,
                                    const DetectRequest& request) {
  if (has_heights(inputs.ours) == has_heights(others)) return std::nullopt;
  const std::string& without = has_heights(others) ? request.input() : *request.others;
  const std::string& with = has_heights(others) ? *request.others : request.input();
  const bool degrees = others.frame == io::Frame::kWgs84;
  return usage_error(
      "detect",
      "the two swarms cannot be compared: " + quoted_source(without) + " has no " +
          (degrees ? "height" : "z") + " column, and " + quoted_source(with) +
          " has one; add it to the first, or take it from the second to compare both at 0 m");
}

// The columns of a header by their numbers.
std::vector<std::string> names_in(const io::LoadedPoints& loaded) {
  std::vector<std::string> names;
  io::FieldCursor cursor(io::header_line(loaded), io::delimiter(loaded));
  io::Field field;
  while (!io::header_line(loaded).empty() && cursor.next(field)) {
    names.push_back(io::lower_case(io::without_padding(io::unquoted(field))));
  }
  return names;
}

// --columns goes to both files; by number only where these call the same columns the same.
std::optional<Error> columns_problem(const Inputs& inputs, const io::LoadedPoints& others,
                                     const DetectRequest& request) {
  const auto ours = names_in(inputs.ours);
  const auto theirs = names_in(others);
  if (request.load.columns.empty() || ours.empty() || theirs.empty()) return std::nullopt;
  const io::ColumnSchema& schema = io::position_columns();
  const auto overrides =
      io::read_column_overrides(schema, request.load.columns, request.load.frame);
  if (!overrides) return overrides.error();
  for (const io::ColumnOverride& wanted : *overrides) {
    std::size_t number = 0;
    const char* const end = wanted.column.data() + wanted.column.size();
    const auto read = std::from_chars(wanted.column.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number == 0) continue;
    if (number > ours.size() || number > theirs.size()) continue;
    if (ours[number - 1] == theirs[number - 1]) continue;
    const io::Role role = io::read_column_name(schema, ours[number - 1]).role;
    const bool alike = role == io::read_column_name(schema, theirs[number - 1]).role;
    if (alike && role != io::Role::kNone) continue;
    return usage_error("detect",
                       "--columns goes to both files, but column " + wanted.column + " is " +
                           io::excerpt(ours[number - 1]) + " in " + quoted_source(request.input()) +
                           " and " + io::excerpt(theirs[number - 1]) + " in " +
                           quoted_source(*request.others) +
                           "; name the columns instead of numbering them, or leave --columns out");
  }
  return std::nullopt;
}

}  // namespace

std::string quoted_source(const std::string& path) {
  return path == "-" ? "standard input" : "'" + path + "'";
}

std::string taken_for(const io::LoadedPoints& loaded, const std::string& path) {
  return quoted_source(path) + " was taken for " +
         (loaded.frame == io::Frame::kWgs84 ? "degrees" : "metres") + " (" + loaded.frame_reason +
         ")";
}

bool has_heights(const io::LoadedPoints& loaded) {
  return std::none_of(loaded.notes.begin(), loaded.notes.end(), [](const std::string& note) {
    return note.starts_with("no height column") || note.starts_with("no z column");
  });
}

bool can_compare(io::HeightDatum some, io::HeightDatum others) {
  const auto none = io::HeightDatum::kUnstated;
  return some == others || some == none || others == none;
}

Error repeated_error(const io::RepeatedIds& repeated, const std::string& path) {
  Error error{
      ErrorCode::kMalformedRecord,
      analysis::text_of(repeated) + "; give each bee an id of its own, or leave --unique-ids out",
      {}};
  error.location.source = io::source_name(path);
  error.location.record = repeated.second_row;
  return error;
}

Result<Inputs> load_inputs(const DetectRequest& request, ProgressBar& progress) {
  io::LoadOptions options = request.load;
  options.progress = &progress.reading();
  auto ours = load_snapshot(request.input(), options, request.threshold, request.vertical);
  if (!ours) return std::move(ours).error();
  if (auto doubt = analysis::doubt_of_scale(*ours, options.frame, request.threshold)) {
    return *std::move(doubt);
  }
  if (request.form.form == Form::kGeoJson && ours->frame != io::Frame::kWgs84) {
    return usage_error(
        "detect", "--geojson needs longitude and latitude, but the input was taken for metres: " +
                      ours->frame_reason);
  }
  auto our_repeated = unless_repeated(*ours, request.input(), request.unique_ids);
  if (!our_repeated) return std::move(our_repeated).error();
  Inputs inputs{*std::move(ours), std::nullopt};
  inputs.our_repeated = *std::move(our_repeated);
  if (!request.others) return inputs;
  auto others = load_snapshot(*request.others, options, request.threshold, request.vertical);
  if (!others) return std::move(others).error();
  if (auto doubt = analysis::doubt_of_scale(*others, options.frame, request.threshold)) {
    return *std::move(doubt);
  }
  if (others->frame != inputs.ours.frame) {
    return usage_error("detect", "the two swarms are not in the same frame: " +
                                     taken_for(inputs.ours, request.input()) + ", and " +
                                     taken_for(*others, *request.others) +
                                     "; convert one, or say with --crs what both are");
  }
  if (auto problem = columns_problem(inputs, *others, request)) return *std::move(problem);
  if (auto problem = height_problem(inputs, *others, request)) return *std::move(problem);
  if (auto problem = datum_problem(inputs.ours, *others)) return *std::move(problem);
  auto their_repeated = unless_repeated(*others, *request.others, request.unique_ids);
  if (!their_repeated) return std::move(their_repeated).error();
  inputs.their_repeated = *std::move(their_repeated);
  inputs.others = *std::move(others);
  return inputs;
}

}  // namespace beespace::cli
