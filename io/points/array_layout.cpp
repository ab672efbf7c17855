#include "io/points/array_layout.hpp"

#include "io/problems/excerpt.hpp"
#include "io/problems/signatures.hpp"

#include <array>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kMagic = "\x93NUMPY";
constexpr std::size_t kRawPointBytes = 3 * sizeof(double);
constexpr const char* kHowToSave = "save it with numpy.save(name, array.astype('<f8'))";

Error unsupported(std::string message) {
  return {ErrorCode::kUnsupportedFormat, std::move(message), {}};
}

Error damaged_header(std::string_view header) {
  return {ErrorCode::kCorrupt,
          "the .npy header " + excerpt(header) + " cannot be understood; " + kHowToSave,
          {}};
}

struct NpyHeader {
  std::string descr = {};
  bool fortran_order = false;
  std::vector<std::uint64_t> shape = {};
};

// The header is a Python dictionary with exactly three entries.
class HeaderParser {
 public:
  explicit HeaderParser(std::string_view text) : text_(text) {}

  std::optional<NpyHeader> parse() {
    if (!take('{')) return std::nullopt;
    while (!take('}')) {
      std::string key;
      if (!string(key) || !take(':') || !entry(key)) return std::nullopt;
      if (!take(',') && peek() != '}') return std::nullopt;
    }
    skip_blanks();
    const bool complete = has_descr_ && has_order_ && has_shape_;
    if (!complete || at_ != text_.size()) return std::nullopt;
    return std::move(header_);
  }

 private:
  bool entry(const std::string& key) {
    if (key == "descr" && !std::exchange(has_descr_, true)) return descr();
    if (key == "fortran_order" && !std::exchange(has_order_, true)) return boolean();
    if (key == "shape" && !std::exchange(has_shape_, true)) return shape();
    return false;
  }

  void skip_blanks() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
  }
  char peek() {
    skip_blanks();
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  bool string(std::string& value) {
    const char quote = peek();
    if (quote != '\'' && quote != '"') return false;
    const std::size_t end = text_.find(quote, at_ + 1);
    if (end == std::string_view::npos) return false;
    value = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return true;
  }
  // A list of fields (a structured array) is kept as its text, to be shown.
  bool descr() {
    if (peek() != '[') return string(header_.descr);
    const std::size_t end = text_.find(']', at_);
    if (end == std::string_view::npos) return false;
    header_.descr = text_.substr(at_, end + 1 - at_);
    at_ = end + 1;
    return true;
  }
  bool boolean() {
    skip_blanks();
    const std::string_view rest = text_.substr(at_);
    header_.fortran_order = rest.substr(0, 4) == "True";
    if (!header_.fortran_order && rest.substr(0, 5) != "False") return false;
    at_ += header_.fortran_order ? 4 : 5;
    return true;
  }
  bool shape() {
    if (!take('(')) return false;
    while (!take(')')) {
      skip_blanks();
      std::uint64_t size = 0;
      const char* const end = text_.data() + text_.size();
      const auto result = std::from_chars(text_.data() + at_, end, size);
      if (result.ec != std::errc()) return false;
      at_ = static_cast<std::size_t>(result.ptr - text_.data());
      header_.shape.push_back(size);
      if (!take(',') && peek() != ')') return false;
    }
    return true;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  bool has_descr_ = false;
  bool has_order_ = false;
  bool has_shape_ = false;
  NpyHeader header_;
};

std::string shape_text(const std::vector<std::uint64_t>& shape) {
  std::string text = "(";
  for (const std::uint64_t size : shape)
    text += (text.size() > 1 ? ", " : "") + std::to_string(size);
  return text + (shape.size() == 1 ? ",)" : ")");
}

// The header's text, and where the data begins.
Result<std::pair<std::string_view, std::size_t>> npy_header(std::string_view bytes) {
  const Error too_short{
      ErrorCode::kTruncated, "the .npy file ends inside its header; copy it again", {}};
  if (bytes.size() < 10) return too_short;
  const auto byte = [bytes](std::size_t i) -> std::size_t {
    return static_cast<unsigned char>(bytes[i]);
  };
  const std::size_t version = byte(6);
  if (version < 1 || version > 3) {
    return unsupported(".npy version " + std::to_string(version) + " is not read; " + kHowToSave);
  }
  const std::size_t begin = version == 1 ? 10 : 12;
  if (bytes.size() < begin) return too_short;
  std::size_t size = byte(8) + 256 * byte(9);
  if (version > 1) size += 65'536 * byte(10) + 16'777'216 * byte(11);
  if (bytes.size() - begin < size) return too_short;
  return std::pair(bytes.substr(begin, size), begin + size);
}

}  // namespace

double ArrayLayout::coordinate(std::uint64_t row, std::size_t axis) const {
  const std::uint64_t item = column_by_column ? axis * rows + row : row * 3 + axis;
  const char* const at = data.data() + item * item_bytes;
  if (item_bytes == sizeof(float)) {
    float value = 0;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  }
  double value = 0;
  std::memcpy(&value, at, sizeof value);
  return value;
}

std::string ArrayLayout::coordinate_text(std::uint64_t row, std::size_t axis) const {
  std::array<char, 32> text = {};
  char* const end = text.data() + text.size();
  const double value = coordinate(row, axis);
  const auto result = item_bytes == sizeof(float)
                          ? std::to_chars(text.data(), end, static_cast<float>(value))
                          : std::to_chars(text.data(), end, value);
  return std::string(text.data(), result.ptr);
}

bool is_npy(std::string_view bytes) {
  return !bytes.empty() && bytes.substr(0, kMagic.size()) == kMagic.substr(0, bytes.size());
}

Result<ArrayLayout> npy_beginning(std::string_view bytes) {
  const auto found = npy_header(bytes);
  if (!found) return found.error();
  const auto [text, data_begin] = found.value();
  const auto header = HeaderParser(text).parse();
  if (!header) return damaged_header(text);
  if (header->descr == "|O") return unsupported("this is " + words_of_signature(bytes));
  if (header->descr != "<f8" && header->descr != "<f4") {
    return unsupported("the .npy array holds " + excerpt(header->descr) +
                       "; only '<f8' and '<f4' are read: " + kHowToSave);
  }
  if (header->shape.size() != 2 || header->shape[1] != 3) {
    return unsupported("the .npy array has the shape " + shape_text(header->shape) +
                       "; (N, 3) is needed, one row a point");
  }
  ArrayLayout layout;
  layout.rows = header->shape[0];
  layout.item_bytes = header->descr == "<f8" ? 8 : 4;
  layout.column_by_column = header->fortran_order;
  layout.data = bytes.substr(data_begin);
  layout.description = std::string("npy ") + (layout.item_bytes == 8 ? "float64 " : "float32 ") +
                       shape_text(header->shape) + (header->fortran_order ? ", Fortran order" : "");
  return layout;
}

std::optional<Error> npy_length_problem(const ArrayLayout& layout, std::uint64_t data_bytes) {
  const std::uint64_t whole_rows = data_bytes / (3 * layout.item_bytes);
  if (whole_rows < layout.rows) {
    return Error{ErrorCode::kTruncated,
                 "the .npy file ends after " + std::to_string(whole_rows) + " of " +
                     std::to_string(layout.rows) + " points; copy it again",
                 {}};
  }
  const std::uint64_t needed = layout.rows * 3 * layout.item_bytes;
  if (data_bytes > needed) {
    return Error{ErrorCode::kCorrupt,
                 std::to_string(data_bytes - needed) +
                     (data_bytes - needed == 1 ? " byte follows" : " bytes follow") +
                     " the array that the .npy header announces; " + kHowToSave,
                 {}};
  }
  if (layout.rows == 0) {
    return Error{ErrorCode::kNoPoints, "the array is empty; at least one point is needed", {}};
  }
  return std::nullopt;
}

Result<ArrayLayout> npy_layout(std::string_view bytes) {
  auto layout = npy_beginning(bytes);
  if (!layout) return layout;
  if (auto problem = npy_length_problem(*layout, layout->data.size())) return *std::move(problem);
  return layout;
}

std::string npy_header_for(const ArrayLayout& layout, std::uint64_t rows) {
  const std::string text = std::string("{'descr': '") + (layout.item_bytes == 8 ? "<f8" : "<f4") +
                           "', 'fortran_order': False, 'shape': (" + std::to_string(rows) + ", 3)}";
  std::string header(kMagic);
  header += '\x01';
  header += '\0';
  header += static_cast<char>(text.size());
  header += '\0';
  return header + text;
}

std::optional<Error> raw_length_problem(std::uint64_t data_bytes) {
  if (data_bytes == 0) {
    return Error{ErrorCode::kNoPoints, "the input is empty; at least one point is needed", {}};
  }
  if (data_bytes % kRawPointBytes != 0) {
    return Error{ErrorCode::kTruncated,
                 std::to_string(data_bytes) + (data_bytes == 1 ? " byte is" : " bytes are") +
                     " no whole number of points (24 bytes each: x, y, z as "
                     "little-endian float64); the file is cut off, or in another format",
                 {}};
  }
  return std::nullopt;
}

Result<ArrayLayout> raw_layout(std::string_view bytes) {
  if (auto problem = raw_length_problem(bytes.size())) return *std::move(problem);
  ArrayLayout layout;
  layout.rows = bytes.size() / kRawPointBytes;
  layout.data = bytes;
  layout.description = "raw float64 (" + std::to_string(layout.rows) + ", 3)";
  return layout;
}

}  // namespace beespace::io
