// A walk over the records of a text table, line by line, counting lines and data rows. Blank lines,
// comments and headers that come again are lines but no rows. Finds line ends and nothing else, so
// it costs little more than memchr.
#pragma once

#include "io/bytes/characters.hpp"
#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace beespace::io {

class RecordWalk {
 public:
  // From `begin`, the start of a line, to the end of `text`.
  RecordWalk(std::string_view text, std::size_t begin, char line_end)
      : at_(text.data() + begin), end_(text.data() + text.size()), line_end_(line_end) {}

  // The same, where lines of that table may be comments; `layout` must outlive this.
  RecordWalk(std::string_view text, std::size_t begin, const TableLayout& layout)
      : RecordWalk(text, begin, layout.line_end) {
    layout_ = &layout;
    header_ = layout.header;
  }

  // To the next record; false when there is none.
  bool next() {
    while (at_ < end_) {
      const char* const begin = at_;
      const void* const found = std::memchr(begin, line_end_, static_cast<std::size_t>(end_ - at_));
      const char* behind = found != nullptr ? static_cast<const char*>(found) : end_;
      at_ = behind + (found != nullptr ? 1 : 0);
      ++lines_;
      if (line_end_ == '\n' && behind > begin && behind[-1] == '\r') --behind;
      line_ = std::string_view(begin, static_cast<std::size_t>(behind - begin));
      if (repeats_header(line_, header_)) {
        ++headers_;
        continue;
      }
      const bool surely_record = behind > begin && *begin > ' ' && *begin != '#' && *begin != '+';
      if (surely_record || (!is_blank_line(line_) && !passes_over(line_))) {
        ++rows_;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] std::string_view record() const { return line_; }
  // 0-based, of the current record, counted from where the walk began.
  [[nodiscard]] std::uint64_t row() const { return rows_ - 1; }
  [[nodiscard]] std::uint64_t line() const { return lines_ - 1; }
  // How often the header has come again so far.
  [[nodiscard]] std::uint64_t headers() const { return headers_; }

 private:
  [[nodiscard]] bool passes_over(std::string_view line) const {
    return layout_ != nullptr && is_comment(line, *layout_);
  }

  const char* at_;
  const char* end_;
  char line_end_;
  std::string_view line_ = {};
  std::uint64_t rows_ = 0;
  std::uint64_t lines_ = 0;
  std::uint64_t headers_ = 0;
  std::string_view header_ = {};
  const TableLayout* layout_ = nullptr;
};

}  // namespace beespace::io
