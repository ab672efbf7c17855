#include "io/points/plain_lines.hpp"

#include "io/bytes/digit_mask.hpp"
#include "io/bytes/number.hpp"

#include <array>
#include <bit>
#include <cstdint>

namespace beespace::io {
namespace {

// A line with the places of what is not a digit: bit i of `others` for text[i]. The bits before
// `at` are cleared. Splitting touches the bits alone, so it runs ahead of the arithmetic.
struct SplitLine {
  const char* text;
  std::uint64_t others;
  std::size_t at = 0;

  [[nodiscard]] std::size_t next_other() const {
    return static_cast<std::size_t>(std::countr_zero(others));
  }
  void pass_other() { others &= others - 1; }

  // The number at `at`; then `at` is where it ends. False when it is not plain.
  bool number(double& value) {
    const std::size_t begin = at;
    const bool negative = text[begin] == '-';
    others &= others - (negative ? 1 : 0);
    const std::size_t whole = begin + (negative ? 1 : 0);
    const std::size_t point = next_other();
    at = point;
    std::size_t decimals = 0;
    if (others != 0 && text[point] == '.') {
      pass_other();
      at = next_other();
      decimals = at - point - 1;
    }
    if (others == 0) return false;  // the line is longer than the mask
    return join_plain_number(text + begin, text + whole, point - whole, decimals, text + at, value);
  }

  // The delimiter at `at`, and one blank behind it.
  bool delimiter(char expected) {
    if (text[at] != expected) return false;
    pass_other();
    ++at;
    if (text[at] == ' ') {
      pass_other();
      ++at;
    }
    return true;
  }
};

}  // namespace

bool has_plain_lines(const TableLayout& layout) {
  const auto& axes = layout.choice.axes;
  return layout.columns == 3 && layout.choice.dimensions == 3 && axes[0] != axes[1] &&
         axes[1] != axes[2] && axes[0] != axes[2];
}

namespace {

// Where the next line begins, or nullptr when this one is not plain.
inline const char* read_line(const char* begin, char delimiter, char line_end,
                             const std::array<std::size_t, 3>& axes, Point& point) {
  SplitLine line{begin, non_digit_mask(begin)};
  std::array<double, 3> values;
  if (!line.number(values[0]) || !line.delimiter(delimiter)) return nullptr;
  if (!line.number(values[1]) || !line.delimiter(delimiter)) return nullptr;
  if (!line.number(values[2])) return nullptr;
  const char* end = begin + line.at;
  if (*end == '\r' && line_end == '\n') ++end;
  if (*end != line_end) return nullptr;
  point = {values[axes[0]], values[axes[1]], values[axes[2]]};
  return end + 1;
}

}  // namespace

const char* read_plain_lines(const char* begin, const char* stop, const TableLayout& layout,
                             std::vector<Point>& points) {
  constexpr std::size_t kAhead = 1024;  // memory answers about this many bytes later
  const char delimiter = layout.delimiter;
  const char line_end = layout.line_end;
  const std::array<std::size_t, 3> axes = layout.choice.axes;
  Point point;
  while (begin < stop) {
    __builtin_prefetch(begin + kAhead);
    const char* const next = read_line(begin, delimiter, line_end, axes, point);
    if (next == nullptr) break;
    points.push_back(point);
    begin = next;
  }
  return begin;
}

bool read_plain_line(const char* begin, const TableLayout& layout, Point& point) {
  return read_line(begin, layout.delimiter, layout.line_end, layout.choice.axes, point) != nullptr;
}

}  // namespace beespace::io
