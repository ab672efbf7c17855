#include "io/tracks/first_fields.hpp"

#include "io/bytes/characters.hpp"
#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/track_aircraft.hpp"

#include <cstdint>
#include <string>

namespace beespace::io {

FirstFields first_fields(std::string_view text, const TableLayout& table, std::size_t column) {
  constexpr std::uint64_t kLookedAt = 16;
  FirstFields found;
  found.first.column = column + 1;
  std::size_t offset = table.data_offset;
  std::uint64_t record = 0;
  for (std::uint64_t i = 0; i < kLookedAt && offset < text.size(); ++i) {
    const Line line = line_at(text, offset, table.line_end);
    offset = line.next;
    if (has_comment_sign(line.text) || is_blank_line(line.text)) continue;
    if (repeats_header(line.text, table.header)) continue;
    ++record;
    if (line.text.size() > kLongestLine) continue;
    const auto field = without_padding(field_at(line.text, table.delimiter, column).text);
    if (is_unknown(field)) continue;
    if (found.empty()) {
      found.first.line = table.lines_before + i + 1;
      found.first.record = record - 1;
    }
    found.texts.push_back(field);
  }
  return found;
}

Error not_a(std::string_view what, const FirstFields& fields, std::string_view why) {
  return {ErrorCode::kNotANumber,
          excerpt(fields.front()) + " is not a " + std::string(what) + ": " + std::string(why),
          fields.first};
}

}  // namespace beespace::io
