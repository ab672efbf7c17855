#include "cli/detect/out_of_core/large_input.hpp"

#include "analysis/geometry/ground_places.hpp"
#include "analysis/geometry/scale_doubt.hpp"
#include "analysis/recorded/default_threshold.hpp"
#include "analysis/snapshot/shown_ids.hpp"
#include "analysis/text/unit_notes.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/detect/answer_ids.hpp"
#include "cli/detect/load_inputs.hpp"
#include "io/bytes/byte_source.hpp"
#include "io/bytes/input_file.hpp"
#include "io/bytes/number_text.hpp"
#include "io/bytes/scratch_file.hpp"
#include "io/table/record_problems.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace beespace::cli {
namespace {

// What a search writes for each point at least, and what is written of points that are copied.
constexpr std::uint64_t kBytesInCells = 28;
constexpr std::uint64_t kBytesOfCopy = sizeof(Point);

Error apart(const std::string& why) {
  return usage_error("detect", "the files cannot be searched together: " + why);
}

// "'a.csv' has an id column, and 'b.csv' has none"
std::string one_has(const LargeFile& with, const LargeFile& without, const char* what) {
  return quoted_source(with.path) + " has " + what + " column, and " + quoted_source(without.path) +
         " has none";
}

}  // namespace

Result<LargeFile> LargeInput::open_file(const std::string& path) const {
  auto stream = io::PointStream::open(path, request_->load, block_bytes_);
  if (!stream) return std::move(stream).error();
  const io::TableLayout* const layout = stream->table();
  if (auto needed = analysis::threshold_needed(
          stream->facts(), layout != nullptr ? std::string_view(layout->header) : "",
          request_->threshold, request_->vertical)) {
    return *std::move(needed);
  }
  LargeFile file{.path = path};
  file.facts = stream->facts();
  file.state = stream->state();
  file.in_place = stream->in_place().has_value();
  if (const io::TableLayout* const table = stream->table()) {
    file.is_table = true;
    file.header = table->header;
    file.delimiter = table->delimiter;
    file.own_ids = table->choice.id.has_value();
  }
  file.stream = *std::move(stream);
  return file;
}

Result<LargeInput> LargeInput::open(const DetectRequest& request, std::size_t block_bytes) {
  LargeInput input(request, block_bytes);
  if (std::count(request.inputs.begin(), request.inputs.end(), "-") > 1) {
    return usage_error("detect", "standard input can be read once");
  }
  for (const std::string& path : request.inputs) {
    auto file = input.open_file(path);
    if (!file) return std::move(file).error();
    if (auto problem = input.mix_problem(*file)) return *std::move(problem);
    input.likely_sizes_.push_back(file->stream->likely_size());
    // Of many files not all are open at a time, but what cannot be opened again, or is searched
    // where it is, stays open.
    const bool stays = request.inputs.size() == 1 || path == "-" || file->in_place;
    if (!stays) file->stream.reset();
    input.files_.push_back(*std::move(file));
  }
  return input;
}

// Why a file cannot be taken together with those before.
std::optional<Error> LargeInput::mix_problem(const LargeFile& file) const {
  if (files_.empty()) return std::nullopt;
  const LargeFile& first = front();
  const auto& facts = file.facts;
  if (facts.frame != first.facts.frame) {
    return apart(taken_for(first.facts, first.path) + ", and " + taken_for(facts, file.path) +
                 "; convert one, or say with --crs what all are");
  }
  if (has_heights(facts) != has_heights(first.facts)) {
    const bool with = has_heights(facts);
    return apart(one_has(with ? file : first, with ? first : file,
                         facts.frame == io::Frame::kWgs84 ? "a height" : "a z"));
  }
  if (!can_compare(facts.heights, first.facts.heights)) {
    return apart("the heights of " + quoted_source(first.path) + " are " +
                 std::string(analysis::datum_text(first.facts.heights)) + ", those of " +
                 quoted_source(file.path) + " " + std::string(analysis::datum_text(facts.heights)) +
                 "; take the same of all with --heights or --columns");
  }
  if (file.own_ids != first.own_ids) {
    return apart(one_has(file.own_ids ? file : first, file.own_ids ? first : file, "an id") +
                 "; add it, or say with --columns where the position is in all of them");
  }
  const bool alike = file.is_table == first.is_table && file.header == first.header &&
                     file.delimiter == first.delimiter;
  if (!alike && !request_->load.columns.empty()) {
    return apart("--columns goes to all of them, but " + quoted_source(file.path) +
                 " has other columns than " + quoted_source(first.path));
  }
  if (!alike && request_->form.form == Form::kCsv) {
    return apart("--csv writes records as they stand, but " + quoted_source(file.path) +
                 " has other columns than " + quoted_source(first.path));
  }
  return std::nullopt;
}

bool LargeInput::heights_are_apart() const {
  return request_->vertical && (front().facts.frame == io::Frame::kWgs84 ||
                                io::compares_as_stated(request_->vertical, height_unit()));
}

io::Unit LargeInput::height_unit() const {
  const io::Unit unit = front().facts.height_unit;
  const bool alike = std::all_of(files_.begin(), files_.end(), [unit](const LargeFile& file) {
    return file.facts.height_unit == unit;
  });
  return alike ? unit : io::Unit::kMetre;
}

Status LargeInput::check_room(const std::string& folder, bool records) const {
  std::uint64_t needed = 0;
  for (std::size_t number = 0; number < files_.size(); ++number) {
    const LargeFile& file = files_[number];
    const std::uint64_t points = likely_sizes_[number].value_or(0);
    const std::uint64_t height = heights_are_apart() ? sizeof(double) : 0;
    needed += points * (kBytesInCells + height + (file.in_place ? 0 : kBytesOfCopy + height));
    if (records) needed += file.facts.bytes;
  }
  const auto free = io::free_bytes_in(folder);
  if (!free) return free.error();
  if (*free >= needed) return std::monostate{};
  return Error{ErrorCode::kWriteFailed,
               "the search needs " + io::byte_count(needed) +
                   " of disk or more for a while, and '" + folder + "' has " +
                   io::byte_count(*free) + ": name a folder with more room with --temporary",
               {}};
}

Status LargeInput::read(const LargeInputSinks& sinks, ProgressBar& bar) {
  bar.enter_stage(ProgressBar::kReading);
  io::Progress& progress = bar.reading();
  const bool known = std::all_of(likely_sizes_.begin(), likely_sizes_.end(),
                                 [](const auto& size) { return size.has_value(); });
  for (const LargeFile& file : files_) {
    if (known) progress.total += file.facts.bytes;
  }
  std::uint64_t first_point = 0;
  for (LargeFile& file : files_) {
    if (!file.stream) {
      auto again = open_file(file.path);
      if (!again) return std::move(again).error();
      if (again->state != file.state) return io::written_meanwhile(file.path);
      file = *std::move(again);
    }
    file.first_point = first_point;
    if (auto status = read_file(file, sinks, progress); !status) return status;
    first_point += file.points;
    rows_before_ += file.points + file.facts.skipped_count;
    if (!file.in_place) file.stream.reset();
  }
  return std::monostate{};
}

Status LargeInput::skip(LargeFile& file, std::uint64_t row, io::LoadedPoints& block) {
  if (block.skipped_count == 0) return std::monostate{};
  for (const std::uint64_t skipped : io::skipped_rows(block)) {
    skipped_.rows.push_back(rows_before_ + row + skipped);
  }
  file.facts.skipped_count += block.skipped_count;
  for (Error& error : block.skipped) {
    if (file.facts.skipped.size() == io::kMostSkippedListed) break;
    file.facts.skipped.push_back(std::move(error));
  }
  if (skipped_.rows.size() * sizeof(std::uint64_t) <= *request_->memory_bytes / 16) {
    return std::monostate{};
  }
  Error error{ErrorCode::kMalformedRecord,
              "too many records are bad, " + io::grouped(skipped_.rows.size()) +
                  " up to here, to remember them within --memory; correct the file",
              {}};
  error.location.source = io::source_name(file.path);
  return error;
}

void LargeInput::add_places(const std::vector<Point>& points, const analysis::GroundPlaces& places,
                            TextStore& store) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool apart = !places.ground.empty();
    const LargePlace place{points[i], apart ? places.ground[i] : points[i],
                           apart ? places.heights_m[i] : points[i].z};
    store.add({reinterpret_cast<const char*>(&place), sizeof place});
  }
}

Status LargeInput::read_file(LargeFile& file, const LargeInputSinks& sinks,
                             io::Progress& progress) {
  io::PointStream& stream = *file.stream;
  const std::uint64_t bytes_before = progress.done;
  const auto in_place = stream.in_place();
  if (in_place) {
    if (auto status = sinks.search.refer(*in_place); !status) return status;
    file.points = in_place->size();
  }
  OddIds odd_ids;
  analysis::Spread spread;
  const bool doubtful =
      analysis::may_be_pixels(file.facts.units, file.facts.frame, request_->threshold);
  for (std::size_t i = 0; in_place && doubtful && i < in_place->size(); ++i) {
    spread.add((*in_place)[i]);
  }
  std::uint64_t headers = 0;
  std::vector<PointId> all;
  // What lies in place is read where its text is wanted.
  const bool goes_through = !in_place || sinks.records != nullptr || sinks.places != nullptr;
  while (goes_through) {
    auto block = stream.next();
    if (!block) return std::move(block).error();
    if (!*block) break;
    io::LoadedPoints& points = **block;
    recording_.add(points);
    headers += points.repeated_headers;
    if (auto status = skip(file, stream.row(), points); !status) return status;
    if (auto problem = recording_.problem(file.path)) return *std::move(problem);
    if (doubtful) {
      for (const Point& place : points.points) spread.add(place);
    }
    if (sinks.ids != nullptr || sinks.records != nullptr) {
      all.resize(points.points.size());
      std::iota(all.begin(), all.end(), PointId{0});
      io::for_each_record(points, all, [&](const io::Record& record) {
        if (sinks.ids != nullptr) {
          sinks.ids->add(record.id);
          odd_ids.empty += analysis::is_empty_id(record.id) ? 1U : 0U;
          odd_ids.broken += analysis::is_broken_id(record.id) ? 1U : 0U;
        }
        if (sinks.records != nullptr) sinks.records->add(record.text);
      });
    }
    const analysis::GroundPlaces places =
        analysis::ground_places(points, request_->vertical, height_unit());
    if (sinks.places != nullptr) add_places(points.points, places, *sinks.places);
    for (const TextStore* const store : {sinks.ids, sinks.records, sinks.places}) {
      if (store != nullptr && !store->status()) return store->status();
    }
    if (!in_place) {
      if (auto status = sinks.search.add(places.view(points.points)); !status) return status;
      file.points += points.points.size();
    }
    progress.done = bytes_before + stream.bytes_read();
  }
  if (auto problem = recording_.problem_of_file(file.path)) return *std::move(problem);
  const io::LoadedPoints& facts = file.facts;
  if (auto doubt = analysis::doubt_of_scale(
          {facts.units, facts.frame, request_->load.frame == io::Frame::kMetres}, spread,
          request_->threshold, analysis::kWithoutScale)) {
    return *std::move(doubt);
  }
  note_ids(odd_ids, {}, request_->form.form, file.facts.notes);
  if (headers > 0) file.facts.notes.push_back(io::repeated_headers_note(headers));
  file.facts.bytes = std::max(stream.file_bytes(), stream.bytes_read());
  return std::monostate{};
}

Error LargeInput::placed(Error error) const {
  if (!error.location.record || !error.location.source.empty()) return error;
  for (const LargeFile& file : files_) {
    if (*error.location.record >= file.first_point + file.points) continue;
    error.location.source = io::source_name(file.path);
    *error.location.record -= file.first_point;
    break;
  }
  return error;
}

Status LargeInput::check_unchanged() const {
  for (const LargeFile& file : files_) {
    if (!file.stream) continue;
    if (auto status = file.stream->check_unchanged(); !status) return status;
  }
  return std::monostate{};
}

}  // namespace beespace::cli
