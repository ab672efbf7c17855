#include "io/stream_points.hpp"

#include "io/bytes/gzip.hpp"
#include "io/load_points.hpp"
#include "io/problems/text_check.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

namespace beespace::io {
namespace {

Error unsupported(std::string message) {
  return {ErrorCode::kUnsupportedFormat, std::move(message), {}};
}

std::uint64_t lines_in(std::string_view text, char line_end) {
  return static_cast<std::uint64_t>(std::count(text.begin(), text.end(), line_end));
}

bool is_raw(const std::string& path, Format format) {
  return format == Format::kRawFloat64 || (format == Format::kAuto && path.ends_with(".bin"));
}

}  // namespace

Error PointStream::placed(Error error) const {
  error.location.source = source_name(path_);
  return error;
}

Result<PointStream> PointStream::open(const std::string& path, const LoadOptions& options,
                                      std::size_t block_bytes) {
  auto bytes = open_bytes(path, options.progress);
  if (!bytes) return std::move(bytes).error();
  PointStream stream;
  stream.path_ = path;
  stream.block_bytes_ = block_bytes;
  stream.bytes_ = *std::move(bytes);
  stream.options_ = options;
  stream.options_.progress = nullptr;
  const std::string_view view = stream.bytes_.view;
  if (is_gzip(view)) {
    return stream.placed(
        unsupported("compressed files are not read block by block; unpack it first: gzip -d"));
  }
  const bool npy =
      options.format == Format::kNpy || (options.format == Format::kAuto && is_npy(view));
  auto settled = npy                            ? stream.settle_array(Format::kNpy)
                 : is_raw(path, options.format) ? stream.settle_array(Format::kRawFloat64)
                                                : stream.settle_table();
  if (!settled) return stream.placed(std::move(settled).error());
  return stream;
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
  options_.frame = known.frame;
  frame_reason_ = known.reason;
  return std::monostate{};
}

Status PointStream::settle_table() {
  if (auto problem = text_problem(bytes_.view)) return *std::move(problem);
  text_ = without_byte_order_mark(bytes_.view);
  auto layout = find_layout(text_, options_);
  if (!layout) return std::move(layout).error();
  table_ = *std::move(layout);
  const ColumnChoice& choice = table_->choice;
  if (choice.id) {
    return unsupported(
        "the records have ids, and block by block they are told by their rows, counted from 0; say "
        "with --columns where the position stands, and leave the id out");
  }
  format_description_ = "text, " + std::string(delimiter_name(table_->delimiter)) + "-separated";
  at_ = table_->data_offset;
  lines_ = table_->lines_before;
  return settle_frame({choice.evidence, choice.reason}, choice.naming == Naming::kSure);
}

Status PointStream::settle_array(Format format) {
  auto layout = format == Format::kNpy ? npy_layout(bytes_.view) : raw_layout(bytes_.view);
  if (!layout) return std::move(layout).error();
  array_ = *std::move(layout);
  format_description_ = array_->description;
  if (!options_.columns.empty()) {
    return Error{ErrorCode::kInvalidArgument, "--columns is for text tables", {}};
  }
  options_.format = Format::kRawFloat64;
  return settle_frame({}, true);
}

std::optional<PointsView> PointStream::in_place() const {
  if (!array_ || options_.frame != Frame::kMetres || options_.units.any()) return std::nullopt;
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

// The header, and as many whole lines behind it as fit; or so many rows as raw float64.
std::string PointStream::next_block() {
  std::string block;
  if (table_) {
    std::size_t end = std::min(text_.size(), at_ + block_bytes_);
    if (end < text_.size()) {
      const std::size_t line_end = text_.find(table_->line_end, end - 1);
      end = line_end == std::string_view::npos ? text_.size() : line_end + 1;
    }
    block.append(text_.substr(0, table_->data_offset)).append(text_.substr(at_, end - at_));
    at_ = end;
    return block;
  }
  const std::size_t count =
      std::min<std::uint64_t>(block_bytes_ / sizeof(Point), array_->rows - at_);
  block.resize(count * sizeof(Point));
  for (std::size_t row = 0; row < count; ++row) {
    std::array<double, 3> numbers{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      numbers[axis] = array_->coordinate(at_ + row, axis);
    std::memcpy(block.data() + row * sizeof numbers, numbers.data(), sizeof numbers);
  }
  at_ += count;
  return block;
}

Status PointStream::next(std::vector<Point>& points) {
  points.clear();
  const std::uint64_t end = table_ ? text_.size() : array_->rows;
  // A block may hold blank lines only; more may come behind it.
  while (at_ < end && points.empty()) {
    const std::size_t begin = at_;
    const std::string block = next_block();
    if (auto problem = other_layout(block)) return placed(*std::move(problem));
    auto loaded = load_points_from_memory(block, path_, options_);
    const bool blank =
        !loaded && loaded.error().code == ErrorCode::kNoPoints && (rows_ > 0 || at_ < end);
    if (!loaded && !blank) return placed(there(std::move(loaded).error()));
    if (loaded) points = std::move(loaded->points);
    rows_ += points.size();
    if (table_) lines_ += lines_in(text_.substr(begin, at_ - begin), table_->line_end);
  }
  return std::monostate{};
}

// Each block tells its layout anew, and all must tell the same.
std::optional<Error> PointStream::other_layout(std::string_view block) const {
  if (!table_) return std::nullopt;
  const auto layout = find_layout(block, options_);
  if (!layout) {
    if (layout.error().code == ErrorCode::kNoPoints) return std::nullopt;
    return there(layout.error());
  }
  const ColumnChoice& now = layout->choice;
  const ColumnChoice& before = table_->choice;
  if (layout->delimiter == table_->delimiter && layout->columns == table_->columns &&
      layout->data_offset == table_->data_offset && now.axes == before.axes &&
      now.dimensions == before.dimensions && now.units == before.units) {
    return std::nullopt;
  }
  Error error{
      ErrorCode::kColumnCount,
      "from this line on the table is laid out otherwise than before it: split the file here",
      {}};
  error.location.line = lines_ + 1;
  return error;
}

// An error of a block, as one of the file.
Error PointStream::there(Error error) const {
  if (table_ && error.location.line && *error.location.line > table_->lines_before) {
    *error.location.line += lines_ - table_->lines_before;
  }
  if (error.location.record) *error.location.record += rows_;
  return error;
}

}  // namespace beespace::io
