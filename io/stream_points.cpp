#include "io/stream_points.hpp"

#include "io/bytes/gzip.hpp"
#include "io/load_points.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/sides.hpp"
#include "io/tracks/utm_zone.hpp"
#include "io/units/heights.hpp"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

std::uint64_t lines_in(std::string_view text, char line_end) {
  return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), line_end));
}

Bytes joined(std::string_view before, std::string_view text) {
  GrowingBytes bytes;
  bytes.make_room(before.size() + text.size());
  for (const std::string_view part : {before, text}) {
    std::copy(part.begin(), part.end(), bytes.free_begin());
    bytes.add(part.size());
  }
  return bytes.release();
}

// Of rows that lie column by column.
std::string gathered(const ArrayLayout& array, std::uint64_t begin, std::uint64_t count) {
  std::string rows;
  rows.reserve(count * 3 * array.item_bytes);
  for (std::uint64_t row = begin; row < begin + count; ++row) {
    for (std::uint64_t axis = 0; axis < 3; ++axis) {
      rows.append(array.data.data() + (axis * array.rows + row) * array.item_bytes,
                  array.item_bytes);
    }
  }
  return rows;
}

}  // namespace

PointStream::PointStream(std::string path, const LoadOptions& options, std::size_t block_bytes,
                         ByteStream stream)
    : path_(std::move(path)),
      options_(options),
      block_bytes_(block_bytes),
      stream_(std::move(stream)) {
  options_.progress = nullptr;
  options_.part_of_more = true;
}

Result<PointStream> PointStream::open(const std::string& path, const LoadOptions& options,
                                      std::size_t block_bytes) {
  auto bytes = ByteStream::open(path);
  if (!bytes) return std::move(bytes).error();
  PointStream stream(path, options, block_bytes, *std::move(bytes));
  if (auto status = stream.settle(); !status) return stream.placed(std::move(status).error());
  auto first = stream.next();
  if (!first) return std::move(first).error();
  if (!*first) {
    return stream.placed({ErrorCode::kNoPoints, "no record is there; at least one is needed", {}});
  }
  stream.keep_first(**std::move(first));
  return stream;
}

// What the input is: also told by its first block.
void PointStream::keep_first(LoadedPoints first) {
  auto points = std::exchange(first.points, {});
  auto records = std::exchange(first.records, nullptr);
  facts_ = first;
  facts_.skipped.clear();
  facts_.skipped_count = 0;
  if (array_) facts_.format_description = array_->description;
  if (stream_.is_compressed())
    facts_.format_description +=
        std::string(", ").append(stream_.packed_by()).append("-compressed");
  const auto read = static_cast<double>(first.bytes);
  const auto unpacked = read + static_cast<double>(pending().size());
  const auto taken = static_cast<double>(stream_.taken());
  const double size = ended_ ? taken : static_cast<double>(stream_.file().size());
  if (array_ && array_->rows > 0) {
    likely_size_ = array_->rows;
  } else if (size > 0.0 && read > 0.0) {
    likely_size_ = static_cast<std::uint64_t>(static_cast<double>(points.size()) *
                                              (unpacked / read) * (size / taken));
  }
  if (!mapped_.view.empty()) {
    rows_ = 0;  // read once more, if at all
    return;
  }
  first.points = std::move(points);
  first.records = std::move(records);
  first_ = std::move(first);
}

Error PointStream::placed(Error error) const {
  error.location.source = source_name(path_);
  return error;
}

Status PointStream::want(std::size_t bytes) {
  if (pending().size() >= bytes || ended_) return std::monostate{};
  pending_->drop(std::exchange(at_, 0));
  pending_->make_room(bytes - pending_->size());
  auto status = stream_.read(*pending_);
  ended_ = pending_->free_size() > 0;
  return status;
}

Status PointStream::settle() {
  if (auto status = want(kHeadBytes); !status) return status;
  const Format format = format_of(pending(), path_, options_.format);
  if (format != Format::kText) return settle_array(format);
  if (stream_.is_compressed() && is_packed(pending())) return compressed_twice(path_);
  return settle_table();
}

Status PointStream::settle_frame(const FrameEvidence& evidence, bool names_are_enough) {
  const FrameDecision known = frame_before_values(options_.frame, evidence);
  if (known.frame == Frame::kAuto || (options_.frame == Frame::kAuto && !names_are_enough)) {
    return Error{
        ErrorCode::kUnknownFrame,
        "degrees or metres? Only all values together could tell, and they are not in memory "
        "together; say --crs metres or --crs wgs84",
        {}};
  }
  if (options_.frame == Frame::kAuto && known.frame == Frame::kWgs84 && table_ &&
      table_->choice.datum == HeightDatum::kHome) {
    return Error{ErrorCode::kInvalidArgument, std::string(kOwnGrounds), {}};
  }
  if (options_.frame == Frame::kAuto && table_ && table_->choice.naming == Naming::kBareAxes) {
    witness_.emplace();
  }
  frame_ = known;
  options_.frame = known.frame;
  return std::monostate{};
}

Status PointStream::settle_table() {
  auto beginning = find_points_table(pending(), options_);
  // Blank lines only, so far.
  while (!beginning && beginning.error().code == ErrorCode::kNoPoints && !ended_) {
    if (auto status = want(2 * pending().size()); !status) return status;
    beginning = find_points_table(pending(), options_);
  }
  if (!beginning) return std::move(beginning).error();
  table_ = std::move(beginning->layout);
  header_ = std::make_shared<const std::string>(table_->header);
  table_->header = *header_;
  at_ += pending().size() - beginning->text.size() + table_->data_offset;
  utm_column_ = find_utm_zone(beginning->text, *table_);
  sides_ = find_sides(beginning->text, *table_);
  table_->data_offset = 0;
  const ColumnChoice& choice = table_->choice;
  return settle_frame({choice.evidence, choice.reason},
                      choice.naming == Naming::kSure || choice.naming == Naming::kBareAxes);
}

Status PointStream::settle_array(Format format) {
  if (!options_.columns.empty()) {
    return Error{ErrorCode::kInvalidArgument, "--columns is for text tables", {}};
  }
  if (options_.skip_bad) {
    return Error{ErrorCode::kInvalidArgument,
                 "of arrays no records are left out where they are not in memory together; leave "
                 "--skip-bad out",
                 {}};
  }
  const bool npy = format == Format::kNpy;
  if (npy && !is_npy(pending())) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this is no .npy file: it does not begin with \\x93NUMPY",
                 {}};
  }
  if (!stream_.is_compressed()) mapped_ = stream_.file().map().value_or(Bytes());
  if (!mapped_.view.empty()) {
    auto layout = npy ? npy_layout(mapped_.view) : raw_layout(mapped_.view);
    if (!layout) return std::move(layout).error();
    array_ = *std::move(layout);
  } else if (npy) {
    auto layout = npy_beginning(pending());
    if (!layout) return std::move(layout).error();
    if (layout->column_by_column) {
      return Error{ErrorCode::kUnsupportedFormat,
                   "this array lies column by column (Fortran order), which cannot be read as it "
                   "comes; name the unpacked file, or save it with numpy.ascontiguousarray(array)",
                   {}};
    }
    at_ += pending().size() - layout->data.size();
    array_ = *std::move(layout);
  } else {
    array_ = ArrayLayout{};
    array_->description = "raw float64";
  }
  is_npy_ = npy;
  options_.format = Format::kNpy;
  return settle_frame({}, true);
}

std::uint64_t PointStream::bytes_read() const {
  return mapped_.view.empty() ? stream_.taken() : rows_ * 3 * array_->item_bytes;
}

std::optional<PointsView> PointStream::in_place() const {
  if (mapped_.view.empty() || options_.frame != Frame::kMetres || options_.units.any()) {
    return std::nullopt;
  }
  const char* const data = array_->data.data();
  const auto item = static_cast<std::ptrdiff_t>(array_->item_bytes);
  if (reinterpret_cast<std::uintptr_t>(data) % array_->item_bytes != 0) return std::nullopt;
  const std::ptrdiff_t row = array_->column_by_column ? item : 3 * item;
  const std::ptrdiff_t axis =
      array_->column_by_column ? item * static_cast<std::ptrdiff_t>(array_->rows) : item;
  const auto view = [&]<class Number>(const Number* first) {
    const auto at = [&](std::ptrdiff_t number) {
      return reinterpret_cast<const Number*>(data + number * axis);
    };
    return PointsView::strided({first, at(1), at(2)}, array_->rows, {row, row, row});
  };
  return array_->item_bytes == sizeof(float) ? view(reinterpret_cast<const float*>(data))
                                             : view(reinterpret_cast<const double*>(data));
}

// Whole lines, about a block of them; none at the end.
Result<Bytes> PointStream::next_lines() {
  std::size_t wanted = block_bytes_;
  while (true) {
    if (auto status = want(wanted); !status) return std::move(status).error();
    const std::string_view all = pending();
    std::size_t end = all.size();
    if (all.size() > wanted || !ended_) {
      const std::size_t last = all.substr(0, wanted).rfind(table_->line_end);
      const std::size_t next =
          last != std::string_view::npos ? last : all.find(table_->line_end, wanted);
      if (next == std::string_view::npos && !ended_) {
        if (all.size() > kLongestLine) {
          Error error = line_without_end(all);
          error.location.line = table_->lines_before + 1;
          return error;
        }
        wanted = all.size() + block_bytes_;
        continue;
      }
      if (next != std::string_view::npos) end = next + 1;
    }
    Bytes lines = joined({}, all.substr(0, end));
    at_ += end;
    return lines;
  }
}

Result<std::optional<LoadedPoints>> PointStream::next_of_table() {
  while (true) {
    auto lines = next_lines();
    if (!lines) return std::move(lines).error();
    if (lines->view.empty()) break;
    const std::uint64_t count = lines_in(lines->view, table_->line_end);
    if (auto error = southern_or_western(lines->view, *table_, sides_)) {
      *error->location.line += table_->lines_before;
      return *std::move(error);
    }
    if (utm_column_) {
      if (auto error = other_zone(lines->view, *table_, *utm_column_, utm_zone_)) {
        *error->location.line += table_->lines_before;
        return *std::move(error);
      }
    }
    auto block = load_lines(*std::move(lines), *table_, frame_, options_);
    if (!block) return std::move(block).error();
    table_->lines_before += count;
    if (block->points.empty() && block->skipped_count == 0) continue;  // blank lines
    look_at_values(*block);
    return std::optional(*std::move(block));
  }
  if (auto problem = contradiction()) return *std::move(problem);
  return std::optional<LoadedPoints>();
}

Result<std::optional<LoadedPoints>> PointStream::next_of_array() {
  const std::size_t row_bytes = 3 * array_->item_bytes;
  const std::size_t most = std::max<std::size_t>(1, block_bytes_ / row_bytes);
  if (!mapped_.view.empty()) {
    const std::uint64_t count = std::min<std::uint64_t>(most, array_->rows - rows_);
    if (count == 0) return std::optional<LoadedPoints>();
    const std::string rows =
        array_->column_by_column
            ? gathered(*array_, rows_, count)
            : std::string(array_->data.substr(rows_ * row_bytes, count * row_bytes));
    return load_rows(rows, count);
  }
  if (auto status = want(most * row_bytes); !status) return std::move(status).error();
  const std::uint64_t left = is_npy_ ? array_->rows - rows_ : most;
  const std::uint64_t count = std::min<std::uint64_t>({most, pending().size() / row_bytes, left});
  if (count == 0) {
    // What follows is too much, or too little for a row.
    std::uint64_t bytes = rows_ * row_bytes;
    while (!pending().empty()) {
      bytes += pending().size();
      at_ += pending().size();
      if (auto status = want(block_bytes_); !status) return std::move(status).error();
    }
    auto problem = is_npy_ ? npy_length_problem(*array_, bytes) : raw_length_problem(bytes);
    if (problem) return *std::move(problem);
    return std::optional<LoadedPoints>();
  }
  const std::string rows(pending().substr(0, count * row_bytes));
  at_ += rows.size();
  return load_rows(rows, count);
}

Result<std::optional<LoadedPoints>> PointStream::load_rows(std::string_view rows,
                                                           std::uint64_t count) const {
  const std::string header = npy_header_for(*array_, count);
  auto block = load_points_from_memory(joined(header, rows).view, path_, options_);
  if (!block) return std::move(block).error();
  return std::optional(*std::move(block));
}

Result<std::optional<LoadedPoints>> PointStream::next() {
  if (first_) {
    row_ = 0;
    auto first = std::move(first_);
    first_.reset();
    return first;
  }
  auto block = table_ ? next_of_table() : next_of_array();
  if (!block) {
    Error error = std::move(block).error();
    if (error.location.record) *error.location.record += rows_;
    return placed(std::move(error));
  }
  row_ = rows_;
  if (!*block) {
    if (auto problem = nothing_left()) return placed(*std::move(problem));
    if (auto problem = no_place()) return placed(*std::move(problem));
    return block;
  }
  LoadedPoints& points = **block;
  look_for_zeros(points);
  for (Error& error : points.skipped) {
    *error.location.record += rows_;
    error = placed(std::move(error));
  }
  if (!bad_ && !points.skipped.empty()) bad_ = points.skipped.front();
  points_ += points.points.size();
  rows_ += points.points.size() + points.skipped_count;
  return block;
}

// At the end: as load_points() says it.
std::optional<Error> PointStream::nothing_left() const {
  if (points_ > 0 || !bad_) return std::nullopt;
  return Error{ErrorCode::kNoPoints, all_bad_text(rows_, *bad_), {}};
}

void PointStream::look_for_zeros(const LoadedPoints& block) {
  if (block.frame != Frame::kWgs84) return;
  for (const std::size_t zero : zeros_.look_at(block.points)) {
    const Point& at = block.points[zero];
    const bool known = std::any_of(first_zeros_.begin(), first_zeros_.end(), [&](const Zero& one) {
      return (one.at.z < 0.0) == (at.z < 0.0);
    });
    if (known) continue;
    Error error = no_place_error(block, zero);
    if (error.location.record) *error.location.record += rows_;
    first_zeros_.push_back({at, std::move(error)});
  }
}

// At the end: those that were handed out cannot be left out any more.
std::optional<Error> PointStream::no_place() const {
  const auto none = std::find_if(first_zeros_.begin(), first_zeros_.end(),
                                 [&](const Zero& zero) { return zeros_.is_none(zero.at); });
  if (none == first_zeros_.end()) return std::nullopt;
  if (!options_.skip_bad) return none->error;
  Error error = without_advice(none->error);
  error.code = ErrorCode::kInvalidArgument;
  error.message += ", or leave --memory out, as with it --skip-bad does not leave it out";
  return error;
}

void PointStream::look_at_values(const LoadedPoints& block) {
  if (witness_) witness_->look_at(block.points);
}

std::optional<Error> PointStream::contradiction() const {
  return witness_ ? witness_->contradiction(table_->choice.dimensions) : std::nullopt;
}

}  // namespace beespace::io
