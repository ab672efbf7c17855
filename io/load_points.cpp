#include "io/load_points.hpp"
#include "io/bytes/characters.hpp"
#include "io/bytes/progress.hpp"
#include "io/frames/coordinate_frame.hpp"
#include "io/units/heights.hpp"
#include "io/units/unit_taken.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/bytes/worker_threads.hpp"
#include "io/frames/frame_decision.hpp"
#include "io/frames/to_metres.hpp"
#include "io/points/array_layout.hpp"
#include "io/points/piece_reading.hpp"
#include "io/points/record_source.hpp"
#include "io/points/table_reading.hpp"
#include "io/points/zero_points.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/signatures.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/decimal_comma.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/scaled_degrees.hpp"
#include "io/tracks/sides.hpp"
#include "io/tracks/utm_zone.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

// Explains a point that is no position in its frame, by where it came from.
Error explain(const RecordSource& source, std::uint64_t row, const Point& point,
              const RangeProblem& problem) {
  if (source.table) {
    const TableLayout& layout = *source.table;
    Error error = range_error_in_text(source.text.substr(layout.data_offset), layout, row, point,
                                      problem.axis, problem.code);
    *error.location.line += layout.lines_before;
    return error;
  }
  Error error = range_error(problem, point, source.array->coordinate_text(row, problem.axis),
                            symbol_of(source.array->units[problem.axis]));
  error.location.record = row;
  return error;
}

// Where loggers write zeros, no place is known.
Error no_place(const RecordSource& source, std::uint64_t row) {
  Error error = explain(source, row, {}, {0, 0, ErrorCode::kInvalidLongitude});
  error.message =
      "longitude 0 and latitude 0 exactly, or -180 and -90, are written where no place is known, "
      "and nothing else is near; correct it" +
      std::string(kOrLeaveOut);
  return error;
}

// Errors: kInvalidLongitude, where such records are not to be left out.
std::optional<Error> leave_out_zeros(LoadedPoints& loaded, RecordSource& source, bool skip_bad) {
  if (loaded.frame != Frame::kWgs84) return std::nullopt;
  ZeroPoints looked;
  std::vector<std::size_t> zeros = looked.look_at(loaded.points);
  std::erase_if(zeros, [&](std::size_t zero) { return !looked.is_none(loaded.points[zero]); });
  if (zeros.empty()) return std::nullopt;
  if (!skip_bad) return no_place(source, source.skipped.row_of(zeros.front()));
  SkippedRecords found;
  for (const std::size_t zero : zeros) {
    const std::uint64_t row = source.skipped.row_of(zero);
    const bool listed = found.errors.size() < kMostSkippedListed;
    found.add(row, listed ? no_place(source, row) : Error());
  }
  auto zero = zeros.begin();
  std::size_t index = 0;
  std::erase_if(loaded.points, [&](const Point&) {
    const bool is_one = zero != zeros.end() && *zero == index++;
    if (is_one) ++zero;
    return is_one;
  });
  source.skipped.merge(std::move(found));
  return std::nullopt;
}

// The frame of points that are still as they were read, and the points in metres.
std::optional<Error> settle_by_values(LoadedPoints& loaded, RecordSource& source,
                                      const Extent& extent, const LoadOptions& options) {
  if (loaded.frame == Frame::kAuto) {
    const bool table = source.table.has_value();
    auto decision =
        frame_from_values(loaded.points, extent, table ? source.table->choice.dimensions : 3,
                          table ? source.table->choice.naming : Naming::kNone);
    if (!decision) {
      Error error = std::move(decision).error();
      if (error.location.record) {
        const std::uint64_t row = source.skipped.row_of(*error.location.record);
        const Point& point = loaded.points[*error.location.record];
        const RangeProblem odd{0, std::abs(point.x) <= 360.0 ? std::size_t{1} : 0, error.code};
        error.location = explain(source, row, point, odd).location;
      }
      return error;
    }
    loaded.frame = decision->frame;
    loaded.frame_reason = decision->reason;
    if (!decision->note.empty()) loaded.notes.push_back(decision->note);
  }
  if (!surely_in_range(extent, loaded.frame)) {
    const auto problem = find_out_of_range(loaded.points, 0, loaded.frame);
    if (problem && !options.skip_bad) {
      return explain(source, source.skipped.row_of(problem->index), loaded.points[problem->index],
                     *problem);
    }
    if (problem) {
      skip_out_of_range(
          loaded.points, loaded.frame, source.skipped,
          [&source](std::uint64_t row, const Point& point, const RangeProblem& found) {
            return explain(source, row, point, found);
          });
    }
  }
  const Status status =
      convert_to_metres(loaded.points, loaded.frame, thread_count(options.threads));
  if (!status) return status.error();
  return std::nullopt;
}

void note_columns(const TableLayout& layout, Frame frame, std::vector<std::string>& notes) {
  const auto& choice = layout.choice;
  const bool geographic = frame == Frame::kWgs84;
  if (choice.naming == Naming::kNone && !layout.header.empty()) {
    notes.push_back("line " + std::to_string(layout.lines_before) +
                    " is taken as the header: " + excerpt(layout.header));
  }
  if (choice.dimensions == 2) {
    notes.emplace_back(geographic ? "no height column: every height is taken as 0 m"
                                  : "no z column: every z is taken as 0 m");
  }
  bool in_order = true;
  std::string text = geographic ? "longitude, latitude" : "x, y";
  if (choice.dimensions == 3) text += geographic ? ", height" : ", z";
  text += " are read from columns";
  for (std::size_t axis = 0; axis < choice.dimensions; ++axis) {
    const std::size_t column = choice.axes[axis];
    in_order = in_order && column == axis;
    text.append(axis == 0 ? " " : ", ").append(std::to_string(column + 1));
    if (column < layout.names.size()) text.append(" ").append(excerpt(layout.names[column]));
  }
  if (!in_order) notes.push_back(std::move(text));
}

// What is to be said of units: where the values have told that positions are in degrees, of
// heights.
std::vector<UnitTaken> units_in(Frame frame, const ColumnChoice& choice) {
  if (frame != Frame::kWgs84 || choice.units_taken.size() != 1) return choice.units_taken;
  if (choice.dimensions < 3) return {};
  UnitTaken heights = choice.units_taken.front();
  heights.of = "heights";
  return {heights};
}

// How what is no text may be read all the same.
std::string_view or_raw(const LoadOptions& options) {
  return options.format_can_be_said ? "; for raw float64 say --format bin"
                                    : ", or let the name of raw float64 end in .bin";
}

// The records behind what `source` says of the layout.
std::optional<Error> read_records(LoadedPoints& loaded, RecordSource& source,
                                  const FrameDecision& known, const LoadOptions& options) {
  const auto& choice = source.table->choice;
  loaded.frame = known.frame;
  loaded.frame_reason = known.reason;
  TableOptions table_options;
  table_options.frame = known.frame;
  table_options.skip_bad = options.skip_bad;
  table_options.threads = options.threads;
  table_options.progress = options.progress;
  auto content = read_table(source.text, *source.table, table_options);
  if (!content) return content.error();
  loaded.points = std::move(content->points);
  source.skipped = std::move(content->skipped);
  loaded.repeated_headers = content->headers;
  loaded.format_description =
      "text, " + std::string(delimiter_name(source.table->delimiter)) + "-separated";
  if (known.frame == Frame::kAuto && !loaded.points.empty()) {
    if (auto error = settle_by_values(loaded, source, content->extent, options)) return error;
  }
  loaded.units = units_in(loaded.frame, choice);
  loaded.height_unit = choice.height_unit();
  loaded.heights = choice.datum;
  if (options.frame == Frame::kAuto && loaded.frame == Frame::kWgs84 &&
      choice.datum == HeightDatum::kHome && loaded.points.size() > 1) {
    return Error{ErrorCode::kInvalidArgument, std::string(kOwnGrounds), {}};
  }
  if (options.frame == Frame::kAuto && choice.naming == Naming::kBareAxes) {
    auto error = contradiction_to_metres(loaded.points, content->extent, choice.dimensions);
    if (error) return error;
  }
  if (!options.part_of_more) {
    if (auto error = leave_out_zeros(loaded, source, options.skip_bad)) return error;
  }
  loaded.notes.insert(loaded.notes.end(), source.table->notes.begin(), source.table->notes.end());
  note_columns(*source.table, loaded.frame, loaded.notes);
  return std::nullopt;
}

// Longitude and latitude that are whole numbers of 1e-7 degrees by their size.
std::optional<Error> settle_scaled_degrees(std::string_view text, const LoadOptions& options,
                                           TableLayout& layout) {
  ColumnChoice& choice = layout.choice;
  const Frame frame = frame_before_values(options.frame, {choice.evidence, choice.reason}).frame;
  if (frame == Frame::kMetres) return scaled_degrees_as_metres(text, layout, choice);
  if (frame != Frame::kWgs84 || !are_scaled_degrees(text, layout, choice)) return std::nullopt;
  choice.scaled_degrees = true;
  layout.notes.emplace_back(kScaledDegreesNote);
  return settle_heights_beside(text, layout, choice);
}

std::optional<Error> load_table(LoadedPoints& loaded, RecordSource& source,
                                const LoadOptions& options) {
  auto beginning = find_points_table(source.bytes.view, options);
  if (!beginning) return beginning.error();
  source.text = beginning->text;
  source.table = std::move(beginning->layout);
  if (options.progress != nullptr) {
    // Everything before the records.
    options.progress->done +=
        source.bytes.view.size() - source.text.size() + source.table->data_offset;
  }
  const auto& choice = source.table->choice;
  const std::string_view records = source.text.substr(source.table->data_offset);
  if (auto error =
          southern_or_western(records, *source.table, find_sides(source.text, *source.table))) {
    *error->location.line += source.table->lines_before;
    return *std::move(error);
  }
  if (const auto column = find_utm_zone(source.text, *source.table)) {
    std::optional<std::string> zone;
    auto error = other_zone(records, *source.table, *column, zone);
    if (error) {
      *error->location.line += source.table->lines_before;
      return error;
    }
    loaded.notes.push_back("eastings and northings are of UTM zone " + excerpt(zone.value_or("")) +
                           ", all of them");
  }
  auto error =
      read_records(loaded, source,
                   frame_before_values(options.frame, {choice.evidence, choice.reason}), options);
  if (!error && loaded.repeated_headers > 0) {
    loaded.notes.push_back(repeated_headers_note(loaded.repeated_headers));
  }
  return error;
}

// All points of the array, as they are.
std::optional<Error> read_array(LoadedPoints& loaded, RecordSource& source,
                                const LoadOptions& options) {
  const ArrayLayout& layout = *source.array;
  if (layout.rows > kMaxPoints) {
    return Error{
        ErrorCode::kTooManyPoints, "more than 4,294,963,200 points; split the file into parts", {}};
  }
  loaded.points.reserve(layout.rows);
  for (std::uint64_t row = 0; row < layout.rows; ++row) {
    const Point point{in_metric(layout.coordinate(row, 0), layout.units[0]),
                      in_metric(layout.coordinate(row, 1), layout.units[1]),
                      in_metric(layout.coordinate(row, 2), layout.units[2])};
    if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) {
      loaded.points.push_back(point);
      continue;
    }
    Error error{ErrorCode::kNotFinite,
                layout.coordinate_text(row, 0) + ", " + layout.coordinate_text(row, 1) + ", " +
                    layout.coordinate_text(row, 2) + " is no position; correct it" +
                    std::string(kOrLeaveOut),
                {}};
    error.location.record = row;
    if (!options.skip_bad) return error;
    source.skipped.add(row, std::move(error));
  }
  return std::nullopt;
}

std::optional<Error> load_array(LoadedPoints& loaded, RecordSource& source, Format format,
                                const LoadOptions& options) {
  if (format == Format::kNpy && !is_npy(source.bytes.view)) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this is no .npy file: it does not begin with \\x93NUMPY",
                 {}};
  }
  if (!options.columns.empty()) {
    return Error{ErrorCode::kInvalidArgument,
                 "--columns is for text tables; the columns of an array are x, y, z or longitude, "
                 "latitude, height",
                 {}};
  }
  TableLayout table;
  table.columns = 3;
  ColumnChoice choice;
  if (auto error = settle_coordinate_units(position_columns(), table, options, choice)) {
    return error;
  }
  auto layout =
      format == Format::kNpy ? npy_layout(source.bytes.view) : raw_layout(source.bytes.view);
  if (!layout) return layout.error();
  source.array = std::move(layout).value();
  loaded.format_description = source.array->description;
  source.array->units = choice.units;
  loaded.height_unit = choice.height_unit();
  const FrameDecision known = frame_before_values(options.frame, {choice.evidence, choice.reason});
  loaded.frame = known.frame;
  loaded.frame_reason = known.reason;
  if (auto error = read_array(loaded, source, options)) return error;
  if (options.progress != nullptr) options.progress->done += source.bytes.view.size();
  if (loaded.points.empty()) return std::nullopt;
  auto error = settle_by_values(loaded, source, extent_of(loaded.points), options);
  if (!error && !options.part_of_more) error = leave_out_zeros(loaded, source, options.skip_bad);
  loaded.units = units_in(loaded.frame, choice);
  return error;
}

Result<LoadedPoints> load_bytes(Bytes bytes, const std::string& path, const LoadOptions& options) {
  const std::string name = source_name(path);
  const auto placed = [&name](Error error) {
    error.location.source = name;
    return error;
  };
  LoadedPoints loaded;
  loaded.bytes = bytes.view.size();
  Progress* const progress = options.progress;
  const bool compressed = is_packed(bytes.view);
  const bool zstd = is_zstd(bytes.view);
  if (progress != nullptr) {
    progress->done = 0;
    progress->total = bytes.view.size();
  }
  if (compressed) {
    auto unpacked = gunzip(bytes.view, name, progress);
    if (!unpacked) return placed(unpacked.error());
    bytes = std::move(unpacked).value();
    if (progress != nullptr) progress->total = progress->done + bytes.view.size();
  }
  auto source = std::make_shared<RecordSource>();
  source->bytes = std::move(bytes);
  bool decimal_commas = false;
  const Format format = format_of(source->bytes.view, path, options.format);
  if (compressed && format == Format::kText && is_packed(source->bytes.view)) {
    return compressed_twice(name);
  }
  if (auto points = format == Format::kText
                        ? with_decimal_points(without_byte_order_mark(source->bytes.view))
                        : std::nullopt) {
    source->bytes = *std::move(points);
    decimal_commas = true;
  }
  auto error = format == Format::kText ? load_table(loaded, *source, options)
                                       : load_array(loaded, *source, format, options);
  if (error) return placed(*std::move(error));

  loaded.skipped = source->skipped.errors;
  loaded.skipped_count = source->skipped.rows.size();
  for (Error& skipped : loaded.skipped) skipped.location.source = name;
  if (loaded.points.empty()) {
    std::string message = "no record is left";
    if (!loaded.skipped.empty()) {
      message = all_bad_text(loaded.skipped_count, loaded.skipped.front());
    }
    return placed({ErrorCode::kNoPoints, std::move(message), {}});
  }
  if (decimal_commas) loaded.format_description += ", with decimal commas";
  if (compressed) loaded.format_description += zstd ? ", zstd-compressed" : ", gzip-compressed";
  loaded.records = std::move(source);
  return loaded;
}

}  // namespace

Format format_of(std::string_view bytes, const std::string& path, Format asked) {
  if (asked != Format::kAuto) return asked;
  if (is_npy(bytes)) return Format::kNpy;
  const std::string name = lower_case(path);
  // Logs of drones may be called so, too.
  const bool raw =
      (ends_with(name, ".bin") || ends_with(name, ".bin.gz") || ends_with(name, ".bin.zst")) &&
      !is_foreign_file(bytes);
  return raw ? Format::kRawFloat64 : Format::kText;
}

Result<TableBeginning> find_points_table(std::string_view bytes, const LoadOptions& options) {
  if (auto problem = text_problem(bytes, or_raw(options))) return *std::move(problem);
  const std::string_view text = without_byte_order_mark(bytes);
  auto layout = find_layout(text, options);
  if (!layout) return std::move(layout).error();
  if (auto error = settle_scaled_degrees(text, options, *layout)) {
    return at_first_line(*std::move(error), *layout);
  }
  return TableBeginning{*std::move(layout), text};
}

std::string all_bad_text(std::uint64_t records, const Error& first) {
  const std::string all = "all " + std::to_string(records) + " records are bad; the first: ";
  return (records == 1 ? "the only record is bad: " : all) + first.message;
}

Error no_place_error(const LoadedPoints& loaded, std::size_t point) {
  return no_place(*loaded.records, loaded.records->skipped.row_of(point));
}

Result<LoadedPoints> load_points(const std::string& path, const LoadOptions& options) {
  auto bytes = open_bytes(path, options.progress);
  if (!bytes) return bytes.error();
  return load_bytes(std::move(bytes).value(), path, options);
}

Result<LoadedPoints> load_lines(Bytes lines, const TableLayout& layout, const FrameDecision& frame,
                                const LoadOptions& options) {
  LoadedPoints loaded;
  auto source = std::make_shared<RecordSource>();
  source->bytes = std::move(lines);
  source->text = source->bytes.view;
  source->table = layout;
  if (auto error = read_records(loaded, *source, frame, options)) return *std::move(error);
  loaded.bytes = source->text.size();
  loaded.skipped = source->skipped.errors;
  loaded.skipped_count = source->skipped.rows.size();
  loaded.records = std::move(source);
  return loaded;
}

Result<LoadedPoints> load_points_from_memory(std::string_view content, const std::string& name,
                                             const LoadOptions& options) {
  return load_bytes(copy_of(content), name, options);
}

}  // namespace beespace::io
