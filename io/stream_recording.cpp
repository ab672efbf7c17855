#include "io/stream_recording.hpp"

#include "io/aircraft/base_station_reading.hpp"
#include "io/ardupilot/dataflash_walk.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/bytes/windows_1252.hpp"
#include "io/bytes/zip_archive.hpp"
#include "io/encounters/bluesky_scenario.hpp"
#include "io/encounters/daidalus_encounter.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/text_check.hpp"
#include "io/px4/ulog_walk.hpp"
#include "io/recording/left_out_files.hpp"
#include "io/recording/recording_sources.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/ethovision_table.hpp"
#include "io/tracks/motive_table.hpp"
#include "io/tracks/pose_table.hpp"
#include "io/tracks/qtm_table.hpp"
#include "io/tracks/record_numbers.hpp"
#include "io/tracks/trackmate_table.hpp"
#include "io/tracks/vicon_table.hpp"
#include "io/tracks/wide_table.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace beespace::io {
namespace {

Status list_files(const std::string& path, std::vector<std::string>& files, bool& several) {
  if (!is_folder(path)) {
    files.push_back(path);
    return std::monostate{};
  }
  const auto inside = recordings_in(path);
  if (!inside) return inside.error();
  several = several || inside->size() > 1;
  files.insert(files.end(), inside->begin(), inside->end());
  return std::monostate{};
}

// Where the line begins that comes behind so many.
std::size_t behind_lines(std::string_view text, std::uint64_t lines, char line_end) {
  std::size_t at = 0;
  for (std::uint64_t i = 0; i < lines; ++i) {
    const std::size_t found = text.find(line_end, at);
    if (found == std::string_view::npos) return text.size();
    at = found + 1;
  }
  return at;
}

Error not_as_it_comes(const std::string& what) {
  return {ErrorCode::kUnsupportedFormat,
          "this is " + what +
              ", which is read as a whole; leave --memory out, or export the recording as CSV",
          {}};
}

std::optional<Error> format_problem(std::string_view beginning, const RecordingOptions& options) {
  const RecordingFormat format = options.format;
  if (is_zip(beginning)) return not_as_it_comes("a zip archive");
  if (is_packed(beginning)) return not_as_it_comes("compressed twice");
  const std::string_view text = without_byte_order_mark(beginning);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool json =
      first != std::string_view::npos &&
      (text[first] == '{' || (text[first] == '[' && format == RecordingFormat::kAuto));
  const bool table = format == RecordingFormat::kTable || format == RecordingFormat::kSkybrushCsv;
  if (format == RecordingFormat::kSkybrushShow) return not_as_it_comes("said to be a show");
  if (json && !table) return not_as_it_comes("JSON");
  if (format != RecordingFormat::kAuto) return std::nullopt;
  if (is_ulog(beginning)) return not_as_it_comes("a PX4 log");
  if (is_dataflash_log(beginning)) return not_as_it_comes("a DataFlash log of ArduPilot");
  if (is_stream_without_times(beginning)) {
    return Error{ErrorCode::kUnsupportedFormat, "this is " + std::string(kStreamWithoutTimes), {}};
  }
  if (is_telemetry_log(beginning)) return not_as_it_comes("a MAVLink telemetry log");
  if (is_base_station(beginning)) return not_as_it_comes("a list of BaseStation messages");
  if (is_daidalus_encounter(text)) return not_as_it_comes("an encounter of DAIDALUS");
  if (options.columns.empty() && is_trackmate_table(text)) {
    return not_as_it_comes("a table of spots of TrackMate");
  }
  if (is_pose_table(text)) return not_as_it_comes("a table of poses");
  if (options.columns.empty() && is_ethovision_table(text)) {
    return not_as_it_comes("raw data of EthoVision");
  }
  if (options.columns.empty() &&
      (is_motive_table(text) || is_vicon_table(text) || is_qtm_table(text))) {
    return not_as_it_comes("an export of motion capture");
  }
  if (options.columns.empty() && is_wide_table(text)) {
    return not_as_it_comes("a table with columns for each animal");
  }
  if (is_bluesky_scenario(text)) {
    return Error{
        ErrorCode::kUnsupportedFormat,
        "this is a scenario of BlueSky, which says where aircraft begin and not where they "
        "fly; ask 'beespace predict' about it",
        {}};
  }
  return std::nullopt;
}

}  // namespace

RecordingStream::RecordingStream(const RecordingOptions& options)
    : options_(std::make_unique<RecordingOptions>(options)),
      progress_(std::exchange(options_->progress, nullptr)) {
  assembly_ = std::make_unique<RecordingAssembly>(*options_);
}

Result<RecordingStream> RecordingStream::open(const std::vector<std::string>& paths,
                                              const RecordingOptions& options,
                                              std::size_t block_bytes) {
  if (paths.empty()) {
    return Error{ErrorCode::kInvalidArgument, "no input is named; name a file, a folder, or -", {}};
  }
  RecordingStream stream(options);
  stream.block_bytes_ = block_bytes;
  bool several = paths.size() > 1;
  for (const std::string& path : paths) {
    if (auto status = list_files(path, stream.files_, several); !status) {
      return std::move(status).error();
    }
  }
  if (several) stream.assembly_->expect_several();
  std::vector<std::string> sources;
  for (const std::string& file : stream.files_) sources.push_back(source_name(file));
  stream.assembly_->expect_sources(sources);
  count_left_out(paths, *stream.assembly_);
  return stream;
}

Error RecordingStream::placed(Error error) const {
  if (error.location.source.empty()) error.location.source = assembly_->source_name();
  return error;
}

Status RecordingStream::want(std::size_t bytes) {
  if (pending().size() >= bytes || ended_) return std::monostate{};
  pending_->drop(std::exchange(at_, 0));
  pending_->make_room(bytes - pending_->size());
  auto status = stream_->read(*pending_);
  ended_ = pending_->free_size() > 0;
  return status;
}

Status RecordingStream::begin_source() {
  const std::string& path = files_[next_file_++];
  auto bytes = ByteStream::open(path);
  if (!bytes) return std::move(bytes).error();
  assembly_->begin_source(source_name(path));
  stream_.emplace(*std::move(bytes));
  if (progress_ != nullptr) progress_->total += stream_->file().size();
  ended_ = false;
  fixes_before_ = fixes_;
  bees_before_ = assembly_->tracks().size();
  first_s_.reset();
  several_times_ = false;
  pending_->drop(pending_->size());
  at_ = 0;
  if (auto status = want(kHeadBytes); !status) return placed(std::move(status).error());
  if (auto problem = format_problem(pending(), *options_)) return placed(*problem);
  auto status = begin_table(path);
  return status ? std::move(status) : Status(placed(std::move(status).error()));
}

std::string_view RecordingStream::readable(std::string_view text, std::optional<Bytes>& converted) {
  converted = text_problem(text) ? std::nullopt : from_windows_1252(text);
  if (!converted) return text;
  assembly_->note(std::string(kTakenForWindows1252));
  return converted->view;
}

// What is pending, without a piece of a line.
std::string_view RecordingStream::beginning() const {
  const std::string_view all = pending();
  const std::size_t last = ended_ ? std::string_view::npos : all.find_last_of("\r\n");
  return last == std::string_view::npos ? all : all.substr(0, last + 1);
}

Status RecordingStream::begin_table(const std::string& path) {
  const bool bare = options_->format == RecordingFormat::kSkybrushCsv;
  std::optional<Bytes> converted;
  const auto begin = [&] {
    const std::string_view text = readable(beginning(), converted);
    return TrackTableReader::begin(
        {text, stem_of(path), bare, ended_ ? SeenRecords::kWhole : SeenRecords::kBeginning},
        *assembly_);
  };
  auto table = begin();
  // Blank lines only, so far.
  while (!table && table.error().code == ErrorCode::kNoPoints && !ended_) {
    if (auto status = want(2 * pending().size()); !status) return status;
    table = begin();
  }
  if (!table) return std::move(table).error();
  // Drones that stand are in the way as long as any other flies, which only all of it tells.
  if (assembly_->is_show()) return not_as_it_comes("a drone show");
  at_ += converted ? behind_lines(pending(), table->lines_before(), table->line_end())
                   : table->data_offset();
  table_.emplace(*std::move(table));
  if (frame() == Frame::kAuto) {
    return Error{
        ErrorCode::kUnknownFrame,
        "degrees or metres? Only all values together could tell, and they are not in memory "
        "together; say --crs metres or --crs wgs84",
        {}};
  }
  const bool bare_axes =
      options_->frame == Frame::kAuto && assembly_->facts()->naming == Naming::kBareAxes;
  if (bare_axes && !witness_) witness_.emplace();
  return std::monostate{};
}

// Errors: kMissingColumn for ids that number the records.
Status RecordingStream::end_source() {
  const std::uint64_t bytes = std::max(stream_->taken(), stream_->file().size());
  assembly_->add_bytes(bytes);
  const std::uint64_t fixes = fixes_ - fixes_before_;
  const std::size_t bees = assembly_->tracks().size() - bees_before_;
  const auto& numbers = table_->perhaps_numbers();
  if (numbers && several_times_ && fixes >= kFewestNumbered && bees >= fixes) {
    return placed(*numbers);
  }
  stream_.reset();
  table_.reset();
  return std::monostate{};
}

// About a block of whole lines.
Status RecordingStream::read_lines() {
  std::size_t wanted = block_bytes_;
  while (true) {
    if (auto status = want(wanted); !status) return placed(std::move(status).error());
    const std::string_view all = pending();
    std::size_t end = all.size();
    if (all.size() > wanted || !ended_) {
      const std::size_t last = all.substr(0, wanted).rfind(table_->line_end());
      const std::size_t next =
          last != std::string_view::npos ? last : all.find(table_->line_end(), wanted);
      if (next == std::string_view::npos && !ended_) {
        if (all.size() > kLongestLine) {
          Error error = line_without_end(all);
          error.location.line = table_->lines_before() + 1;
          return placed(std::move(error));
        }
        wanted = all.size() + block_bytes_;
        continue;
      }
      if (next != std::string_view::npos) end = next + 1;
    }
    std::optional<Bytes> converted;
    const std::string_view lines = readable(all.substr(0, end), converted);
    if (auto error = table_->read(lines)) return placed(*std::move(error));
    at_ += end;
    return std::monostate{};
  }
}

Status RecordingStream::next(std::vector<StreamedFix>& fixes) {
  fixes.clear();
  while (fixes.empty()) {
    if (!stream_) {
      if (next_file_ == files_.size()) {
        if (auto problem = restart_problem()) return *std::move(problem);
        return std::monostate{};
      }
      if (auto status = begin_source(); !status) return status;
    }
    if (auto status = read_lines(); !status) return status;
    assembly_->tracks().drain([&](const TrackGathering::Taken& taken) {
      const auto& [bee, fix, velocity, stated, origin] = taken;
      if (is_nowhere(fix)) {
        assembly_->leave_out(kZeroPlace, id(bee));
        assembly_->unplaced(id(bee), fix.time_s);
        return;
      }
      if (assembly_->may_begin_again()) {
        if (bee >= clocks_.size()) clocks_.resize(bee + 1);
        clocks_[bee].take(fix, origin, frame());
      }
      if (bee >= stale_.size()) stale_.resize(bee + 1);
      if (stale_[bee].take(fix, velocity)) {
        assembly_->stale(id(bee), fix);
        return;
      }
      if (frame() == Frame::kMetres) {
        if (bee >= zero_runs_.size()) zero_runs_.resize(bee + 1);
        zero_runs_[bee].take(fix, fixes_);
      }
      look_whether_frozen(bee, fix, velocity);
      const bool follows =
          last_ && last_->source == origin.source && last_->line + 1 == origin.line;
      if (!follows) places_.push_back({fixes_, origin});
      last_ = origin;
      ++fixes_;
      several_times_ = several_times_ || (first_s_ && *first_s_ != fix.time_s);
      first_s_ = fix.time_s;
      look_for_doubt(bee, fix, velocity, origin);
      look_whether_lost(bee, fix);
      assembly_->reach(fix.position.z);
      if (witness_) witness_->look_at(std::span(&fix.position, 1));
      fixes.push_back({bee, fix, stated});
    });
    const bool over = ended_ && pending().empty();
    if (progress_ != nullptr) progress_->done = bytes_before_ + stream_->taken();
    if (!over) continue;
    bytes_before_ += stream_->taken();
    if (auto status = end_source(); !status) return status;
  }
  return std::monostate{};
}

// Of fixes in the order of the input; those that go back in time count for nothing.
void RecordingStream::look_for_doubt(std::size_t bee, const Fix& fix, const Velocity* velocity,
                                     Origin origin) {
  if (bee >= shared_.size()) {
    shared_.resize(bee + 1);
    jumps_.resize(bee + 1);
    excursions_.resize(bee + 1);
    jumping_.resize(bee + 1);
  }
  const bool leaps = !assembly_->facts()->of_aircraft && excursions_[bee].take(fix, frame());
  if (!jumping_[bee] && (jumps_[bee].take(fix, velocity, frame()) || leaps)) {
    jumping_[bee] = true;
    assembly_->jump({id(bee), fix.time_s, origin});
  }
  if (shared_[bee].found()) return;
  shared_[bee].take(fix, frame());
  if (shared_[bee].found()) assembly_->share({id(bee), fix.time_s, origin});
}

// Judged by what came before.
bool RecordingStream::is_nowhere(const Fix& fix) {
  if (frame() != Frame::kWgs84) return false;
  zeros_.look_at(fix.position);
  return zeros_.is_none(fix.position);
}

Origin RecordingStream::origin_of(std::uint64_t fix) const {
  auto place =
      std::upper_bound(places_.begin(), places_.end(), fix,
                       [](std::uint64_t number, const Place& at) { return number < at.fix; });
  --place;
  Origin origin = place->origin;
  origin.line = (origin.line + (fix - place->fix)) & 0xFF'FFFF'FFFFu;
  return origin;
}

Error RecordingStream::clash(std::size_t bee, double time_s, std::uint64_t first,
                             std::uint64_t second) const {
  Error error = assembly_->conflict_error({id(bee), time_s, origin_of(first), origin_of(second)});
  const std::size_t advice = error.message.rfind(kOrLeaveOut);
  if (advice != std::string::npos) error.message.erase(advice, kOrLeaveOut.size());
  if (options_->skip_bad) error.message += " (with --memory, --skip-bad does not leave it out)";
  return error;
}

Result<Recording> RecordingStream::finish(std::uint64_t repeated) {
  if (witness_) {
    if (auto error = witness_->contradiction(assembly_->facts()->dimensions)) {
      error->location.source = source_name(files_.front());
      return *std::move(error);
    }
  }
  if (auto problem = zero_run_problem()) return *std::move(problem);
  if (auto problem = frozen_problem()) return *std::move(problem);
  lose_unordered();
  assembly_->tracks().add_repeated(repeated);
  assembly_->settled_frame();  // of each bee only the last fix is there
  return assembly_->finish();
}

}  // namespace beespace::io
