#include "io/points/piece_reading.hpp"

#include "io/bytes/characters.hpp"
#include "io/frames/to_metres.hpp"
#include "io/points/plain_lines.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/coordinate_units.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/record_walk.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace beespace::io {
namespace {

// Reads the line at `at` in every allowed notation; returns where the next one begins.
std::size_t read_any_line(std::string_view piece, std::size_t at, const TableLayout& layout,
                          const PieceOptions& options, PieceContent& content) {
  const Line line = line_at(piece, at, layout.line_end);
  ++content.lines;
  if (is_blank_line(line.text) || is_comment(line.text, layout)) return line.next;
  if (repeats_header(line.text, layout.header)) {
    ++content.headers;
    return line.next;
  }
  Point point;
  auto error = read_record(line.text, layout, point);
  const std::uint64_t row = content.rows++;
  if (!error) {
    content.points.push_back(point);
    return line.next;
  }
  if (auto other = other_header_problem(line.text, layout)) {
    other->location.line = content.lines;
    content.error = std::move(other);
    return line.next;
  }
  error->location.line = content.lines;
  error->location.record = row;
  if (options.skip_bad) {
    content.skipped.add(row, *std::move(error));
  } else {
    content.error = std::move(error);
  }
  return line.next;
}

// Of degrees among whole numbers of 1e-7 degrees, whatever is left out: they would be taken for
// other places.
std::optional<Error> part_of_scaled_degree(std::string_view piece, const TableLayout& layout,
                                           const PieceContent& content) {
  const auto is_whole = [](double value) { return value == std::floor(value); };
  for (std::size_t i = 0; i < content.points.size(); ++i) {
    const Point& at = content.points[i];
    if (is_whole(at.x) && is_whole(at.y)) continue;
    const std::size_t axis = is_whole(at.x) ? 1 : 0;
    const std::uint64_t row = content.skipped.row_of(i);
    RecordWalk walk(piece, 0, layout);
    while (walk.next() && walk.row() < row) {
    }
    const std::size_t column = layout.choice.axes[axis];
    const Field field = field_at(walk.record(), layout.delimiter, column);
    Error error = at_column(
        ErrorCode::kMalformedRecord,
        excerpt(field.text) + " is no whole number of 1e-7 degrees, as the first are; correct it",
        column);
    error.location.line = walk.line() + 1;
    error.location.record = row;
    return error;
  }
  return std::nullopt;
}

// Checks what was read against the frame, and turns it into metres.
void settle(std::string_view piece, const TableLayout& layout, const PieceOptions& options,
            PieceContent& content) {
  if (layout.choice.scaled_degrees && !content.error) {
    content.error = part_of_scaled_degree(piece, layout, content);
    if (content.error) return;
  }
  if (!layout.choice.is_metric()) {
    for (Point& point : content.points) point = in_metric(point, layout.choice);
  }
  content.extent = extent_of(content.points);
  if (options.frame == Frame::kAuto) return;
  std::optional<RangeProblem> problem;
  if (!surely_in_range(content.extent, options.frame)) {
    problem = find_out_of_range(content.points, 0, options.frame);
  }
  if (problem && !options.skip_bad) {
    const std::uint64_t row = content.skipped.row_of(problem->index);
    content.error = range_error_in_text(piece, layout, row, content.points[problem->index],
                                        problem->axis, problem->code);
    return;
  }
  if (problem) {
    const auto explain = [&](std::uint64_t row, const Point& point, const RangeProblem& found) {
      return range_error_in_text(piece, layout, row, point, found.axis, found.code);
    };
    skip_out_of_range(content.points, options.frame, content.skipped, explain);
  }
  const Status status = convert_to_metres(content.points, options.frame, 1);
  if (!status && !content.error) content.error = status.error();
}

}  // namespace

void PieceContent::clear() {
  points.clear();
  extent = {};
  lines = 0;
  rows = 0;
  headers = 0;
  skipped = {};
  error.reset();
}

void read_piece(std::string_view piece, const char* readable_end, const TableLayout& layout,
                const PieceOptions& options, PieceContent& content) {
  content.clear();
  const char* const begin = piece.data();
  const bool fast = options.fast_path && has_plain_lines(layout) &&
                    static_cast<std::size_t>(readable_end - begin) > kPlainLineReach;
  const char* const fast_stop =
      fast ? std::min(begin + piece.size(), readable_end - kPlainLineReach) : begin;
  std::size_t at = 0;
  while (at < piece.size() && !content.error) {
    if (begin + at < fast_stop) {
      const std::size_t before = content.points.size();
      at = static_cast<std::size_t>(
          read_plain_lines(begin + at, fast_stop, layout, content.points) - begin);
      const std::size_t count = content.points.size() - before;
      content.lines += count;
      content.rows += count;
      if (at >= piece.size()) break;
    }
    at = read_any_line(piece, at, layout, options, content);
  }
  settle(piece, layout, options, content);
}

Error range_error_in_text(std::string_view text, const TableLayout& layout, std::uint64_t row,
                          const Point& point, std::size_t axis, ErrorCode code) {
  const std::size_t column = layout.choice.axes[axis];
  RecordWalk walk(text, 0, layout);
  while (walk.next() && walk.row() < row) {
  }
  const Field field = field_at(walk.record(), layout.delimiter, column);
  Error error = range_error({0, axis, code}, point, excerpt(field.text),
                            symbol_of(layout.choice.units[axis]));
  error.location.line = walk.line() + 1;
  error.location.column = column + 1;
  error.location.record = row;
  return error;
}

}  // namespace beespace::io
