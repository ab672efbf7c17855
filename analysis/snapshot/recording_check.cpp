#include "analysis/snapshot/recording_check.hpp"

#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

std::optional<std::size_t> find_column(const io::LoadedPoints& loaded, io::Role role) {
  io::FieldCursor cursor(io::header_line(loaded), io::delimiter(loaded));
  io::Field name;
  for (std::size_t column = 0; cursor.next(name); ++column) {
    if (io::read_column_name(io::track_columns(), io::unquoted(name)).role == role) return column;
  }
  return std::nullopt;
}

bool is_same_time(const std::string& a, const std::string& b) {
  if (a == b) return true;
  const auto first = io::parse_number(a);
  return first && first == io::parse_number(b);  // "1" and "1.0"
}

Error blamed_on(const std::string& path, std::string message) {
  Error error{ErrorCode::kUnsupportedFormat, std::move(message), {}};
  error.location.source = path == "-" ? "<stdin>" : path;
  return error;
}

}  // namespace

bool is_about_data(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidThreshold:
    case ErrorCode::kInvalidArgument:
    case ErrorCode::kCannotOpen:
    case ErrorCode::kReadFailed:
    case ErrorCode::kWriteFailed:
      return false;
    default:
      return true;
  }
}

void RecordingCheck::add(const std::string& id, const std::string& time) {
  if (problem_ || id.empty() || time.empty()) return;
  auto known = first_times_.find(id);
  if (known == first_times_.end()) {
    if (first_times_.size() < most_bees_) first_times_.emplace(id, time);
    return;
  }
  if (is_same_time(known->second, time)) return;
  problem_ = "this is a recording: bee " + io::excerpt(id) + " is in it at more than one time (" +
             io::excerpt(known->second) + " and " + io::excerpt(time) +
             "); ask 'beespace replay' about it, or leave one time in it";
}

void RecordingCheck::add(const io::LoadedPoints& loaded) {
  const auto time = find_column(loaded, io::Role::kTime);
  if (problem_ || !time) return;
  // "drone" names no column of ids to a snapshot.
  const bool own_ids = io::has_id_column(loaded);
  const auto id = find_column(loaded, io::Role::kId);
  if (!own_ids && !id) return;
  const char delimiter = io::delimiter(loaded);
  const auto field = [delimiter](const io::Record& record, std::size_t column) {
    return io::unquoted(io::field_at(record.text, delimiter, column));
  };
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  first_times_.reserve(std::min(most_bees_, all.size()));
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    add(own_ids ? std::string(record.id) : field(record, *id), field(record, *time));
  });
}

std::optional<Error> RecordingCheck::problem(const std::string& path) const {
  if (!problem_) return std::nullopt;
  return blamed_on(path, *problem_);
}

std::optional<Error> recording_problem(const io::LoadedPoints& loaded, const std::string& path) {
  RecordingCheck check(loaded.points.size());
  check.add(loaded);
  return check.problem(path);
}

bool has_several_times(const io::LoadedPoints& loaded) {
  const auto column = find_column(loaded, io::Role::kTime);
  if (!column) return false;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  std::string first;
  bool several = false;
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    const std::string time(io::unquoted(io::field_at(record.text, io::delimiter(loaded), *column)));
    if (several || time.empty()) return;
    if (first.empty()) first = time;
    several = !is_same_time(first, time);
  });
  return several;
}

Error or_recording(Error error, const std::string& path, const io::LoadOptions& options) {
  const bool asked = options.format != io::Format::kAuto || !options.columns.empty();
  const bool bad_input = is_about_data(error.code);
  // What is no file, as a pipe, is read up.
  std::error_code unknown;
  const bool file = path != "-" && std::filesystem::is_regular_file(path, unknown);
  if (asked || !bad_input || !file) return error;
  const auto recording = io::load_recording({path});
  if (!recording) {
    // It is known for what it is to be, but damaged: that says more than that it is no table.
    const ErrorCode code = recording.error().code;
    if (recording.error().message.find("are of a video") != std::string::npos ||
        recording.error().message.find("the frames of a video") != std::string::npos) {
      return blamed_on(path,
                       "this is a recording of animals that move, frame by frame; ask 'beespace "
                       "replay' about it");
    }
    const bool damaged = code == ErrorCode::kTruncated || code == ErrorCode::kCorrupt ||
                         code == ErrorCode::kMalformedRecord;
    if (error.code != ErrorCode::kUnsupportedFormat || !damaged) return error;
    Error known = recording.error();
    known.message += "; a whole one is for 'beespace replay'";
    return known;
  }
  // Of a table the reader of snapshots knows better what is wrong; a zip of tables it does not
  // know.
  const bool table = recording->format_description.starts_with("text");
  const auto moves = std::find_if(recording->bees.begin(), recording->bees.end(),
                                  [](const io::RecordedBee& bee) { return bee.fixes.size() > 1; });
  if (table && moves != recording->bees.end()) {
    return blamed_on(path, "this is a recording: bee " + io::excerpt(moves->id) +
                               " is in it at more than one time; ask 'beespace replay' about it, "
                               "or leave one time in it");
  }
  if (table && error.code != ErrorCode::kUnsupportedFormat) return error;
  const bool at_an_instant =
      std::all_of(recording->bees.begin(), recording->bees.end(),
                  [](const io::RecordedBee& bee) { return !bee.path && bee.fixes.size() <= 1; });
  if (at_an_instant) {
    return blamed_on(path, "this is a look at bees that move (" + recording->format_description +
                               "), not a table or an array of places; ask 'beespace predict' about "
                               "it, with --horizon 0 for now only");
  }
  return blamed_on(path,
                   "this is a recording of bees that move (" + recording->format_description +
                       "), not a table or an array of places; ask 'beespace replay' about it");
}

}  // namespace beespace::analysis
