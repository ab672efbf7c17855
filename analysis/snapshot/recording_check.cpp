#include "analysis/snapshot/recording_check.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"
#include "io/load_recording.hpp"
#include "io/points/record_reading.hpp"
#include "io/points/record_source.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/header_words.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr char kBetweenTimes = '\x1F';  // no text has it
constexpr std::uint64_t kFewest = 3;    // records of which it is said that they have several times

// Whether the first record has a date or a time of day there.
bool has_clock_times(const io::RecordSource& source, std::size_t column) {
  io::RecordWalk walk(source.text, source.table->data_offset, *source.table);
  if (!walk.next()) return false;
  const std::string text =
      io::unquoted(io::field_at(walk.record(), source.table->delimiter, column));
  return text.find(':') != std::string::npos || std::count(text.begin(), text.end(), '-') == 2 ||
         std::count(text.begin(), text.end(), '/') == 2 ||
         std::count(text.begin(), text.end(), '.') == 2;
}

// The columns of a table as a recording has them.
struct Columns {
  std::vector<std::size_t> times = {};
  std::optional<std::size_t> id = {};
  std::vector<std::size_t> other_ids = {};  // that may be the id as well
};

Columns columns_of(const io::LoadedPoints& loaded) {
  Columns columns;
  if (loaded.records == nullptr || !loaded.records->table) return columns;
  const io::RecordSource& source = *loaded.records;
  const io::ColumnOptions options;
  const io::Header header(io::track_columns(), options, *source.table, {});
  for (const io::Role role :
       {io::Role::kTime, io::Role::kDate, io::Role::kFrame, io::Role::kPositionTime}) {
    const auto& found = header.columns(role);
    columns.times.insert(columns.times.end(), found.begin(), found.end());
  }
  const bool named = !columns.times.empty();
  for (std::size_t i = 0; !named && i < header.size(); ++i) {
    if (header.meaning(i).role == io::Role::kNone && has_clock_times(source, i)) {
      columns.times.push_back(i);
    }
  }
  // "drone" names no column of ids to a snapshot.
  columns.id = source.table->choice.id;
  if (!columns.id && header.has(io::Role::kId)) columns.id = header.columns(io::Role::kId).front();
  for (const std::size_t other : header.columns(io::Role::kId)) {
    if (other != columns.id) columns.other_ids.push_back(other);
  }
  return columns;
}

std::string text_at(const io::Record& record, char delimiter, std::size_t column) {
  return std::string(
      io::without_padding(io::unquoted(io::field_at(record.text, delimiter, column))));
}

// What a record says of its time; empty where it says nothing.
std::string time_of(const io::Record& record, char delimiter,
                    const std::vector<std::size_t>& columns) {
  std::string time;
  bool any = false;
  for (const std::size_t column : columns) {
    const std::string text = text_at(record, delimiter, column);
    any = any || !text.empty();
    if (column != columns.front()) time += kBetweenTimes;
    time += text;
  }
  return any ? time : std::string();
}

// Where two times differ, in the first of their columns that does; nothing where they do not.
std::optional<std::pair<std::string, std::string>> differing(std::string_view a,
                                                             std::string_view b) {
  while (true) {
    const std::string first(a.substr(0, a.find(kBetweenTimes)));
    const std::string second(b.substr(0, b.find(kBetweenTimes)));
    const auto number = io::parse_number(first);
    const bool same =
        first == second || (number && number == io::parse_number(second));  // "1" and "1.0"
    if (!same) return std::pair(first, second);
    if (first.size() == a.size() || second.size() == b.size()) return std::nullopt;
    a.remove_prefix(first.size() + 1);
    b.remove_prefix(second.size() + 1);
  }
}

std::string times_text(const std::pair<std::string, std::string>& times) {
  std::string text = "(";
  return text.append(io::excerpt(times.first)).append(" and ").append(io::excerpt(times.second)) +
         ")";
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

RecordingCheck::RecordingCheck(std::size_t most_bees, const io::LoadOptions& options)
    : most_bees_(most_bees), id_is_said_(false) {
  const auto said =
      io::read_column_overrides(io::position_columns(), options.columns, options.frame);
  id_is_said_ = said && std::any_of(said->begin(), said->end(), [](const io::ColumnOverride& one) {
                  return one.role == io::Role::kId;
                });
}

void RecordingCheck::count(const std::string& time) {
  if (time.empty()) return;
  ++file_.records;
  if (file_.first_time.empty()) file_.first_time = time;
  if (file_.other_time.empty() && differing(file_.first_time, time)) file_.other_time = time;
}

void RecordingCheck::add(const std::string& id, const std::string& time) {
  if (problem_ || id.empty()) return;
  count(time);
  auto known = first_times_.find(id);
  if (known == first_times_.end()) {
    const bool full = first_times_.size() >= most_bees_;
    if (!full) first_times_.emplace(id, time);
    file_.repeats_ids = file_.repeats_ids || full;  // it may
    return;
  }
  file_.repeats_ids = true;
  if (known->second.empty()) known->second = time;
  const auto times = time.empty() ? std::nullopt : differing(known->second, time);
  if (!times) return;
  problem_ = "this is a recording: bee " + io::excerpt(id) + " is in it at more than one time " +
             times_text(*times) + "; ask 'beespace replay' about it, or leave one time in it";
}

void RecordingCheck::add(const io::LoadedPoints& loaded) {
  const Columns columns = columns_of(loaded);
  if (problem_ || columns.times.empty()) return;
  const bool own_ids = io::has_id_column(loaded);
  const char delimiter = io::delimiter(loaded);
  if (columns.id) {
    const auto& names = loaded.records->table->names;
    file_.id_number = *columns.id + 1;
    file_.id_name = *columns.id < names.size() ? names[*columns.id] : std::string();
  }
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  first_times_.reserve(std::min(most_bees_, all.size()));
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    const std::string time = time_of(record, delimiter, columns.times);
    if (!columns.id) {
      count(time);
    } else {
      add(own_ids ? std::string(record.id) : text_at(record, delimiter, *columns.id), time);
    }
  });
  if (id_is_said_) look_at_others(loaded, columns.times, columns.other_ids);
}

// Whether one value of a column that may be the id, too, comes at several times.
void RecordingCheck::look_at_others(const io::LoadedPoints& loaded,
                                    const std::vector<std::size_t>& times,
                                    const std::vector<std::size_t>& ids) {
  const char delimiter = io::delimiter(loaded);
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  for (const std::size_t id : ids) {
    std::unordered_map<std::string, std::string> first_times;
    io::for_each_record(loaded, all, [&](const io::Record& record) {
      const std::string value = text_at(record, delimiter, id);
      const std::string time = time_of(record, delimiter, times);
      if (value.empty() || time.empty() || !file_.other_id.empty()) return;
      const bool full = first_times.size() >= most_bees_;
      auto known = first_times.find(value);
      if (known == first_times.end() && full) return;
      if (known == first_times.end()) known = first_times.emplace(value, time).first;
      if (!differing(known->second, time)) return;
      file_.other_id = "column " + std::to_string(id + 1) + " " +
                       io::excerpt(loaded.records->table->names[id]) + " has " + io::excerpt(value);
    });
  }
}

std::optional<Error> RecordingCheck::problem(const std::string& path) const {
  if (!problem_) return std::nullopt;
  return blamed_on(path, *problem_);
}

std::optional<Error> RecordingCheck::problem_of_file(const std::string& path) {
  const File file = std::exchange(file_, {});
  if (problem_) return problem(path);
  if (file.records < kFewest || file.other_time.empty() || file.repeats_ids) return std::nullopt;
  const std::string times = times_text(*differing(file.first_time, file.other_time));
  if (file.id_number == 0) {
    return blamed_on(path, "this is a recording: its records are of several times " + times +
                               "; ask 'beespace replay' about it, or leave one time in it");
  }
  if (io::speaks_of_aviation(file.id_name)) return std::nullopt;
  const std::string number = std::to_string(file.id_number);
  if (id_is_said_ && file.other_id.empty()) return std::nullopt;
  if (id_is_said_) {
    return blamed_on(path, "this is a recording: column " + number + " " +
                               io::excerpt(file.id_name) + " numbers its records, and " +
                               file.other_id + " at more than one time " + times +
                               "; ask 'beespace replay' about it, or leave one time in it");
  }
  return blamed_on(
      path, "this is a recording: its records are of several times " + times + ", and column " +
                number + " " + io::excerpt(file.id_name) +
                " numbers them; ask 'beespace replay' about it, leave one time in it, or, "
                "if each is of another bee, say --columns id=" +
                number);
}

std::optional<Error> recording_problem(const io::LoadedPoints& loaded, const std::string& path,
                                       const io::LoadOptions& options) {
  RecordingCheck check(loaded.points.size(), options);
  check.add(loaded);
  return check.problem_of_file(path);
}

bool has_several_times(const io::LoadedPoints& loaded) {
  const Columns columns = columns_of(loaded);
  if (columns.times.empty()) return false;
  std::vector<PointId> all(loaded.points.size());
  std::iota(all.begin(), all.end(), PointId{0});
  std::string first;
  bool several = false;
  io::for_each_record(loaded, all, [&](const io::Record& record) {
    if (several) return;
    const std::string time = time_of(record, io::delimiter(loaded), columns.times);
    if (first.empty()) first = time;
    several = !time.empty() && differing(first, time);
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
