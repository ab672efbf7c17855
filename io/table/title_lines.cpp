#include "io/table/title_lines.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace beespace::io {
namespace {

// What a line holds, but for empty fields.
struct LineContent {
  std::size_t fields = 0;
  std::size_t filled = 0;
  std::size_t numbers = 0;
};

LineContent content_of_line(std::string_view line, char delimiter) {
  LineContent content;
  FieldCursor cursor(line, delimiter);
  for (Field field; cursor.next(field);) {
    ++content.fields;
    const std::string_view text = without_padding(field.text);
    if (text.empty()) continue;
    ++content.filled;
    double value = 0.0;
    if (parse_number(text, value) == NumberKind::kNumber) ++content.numbers;
  }
  return content;
}

// Of the line that says in which line the header is: "Headers Row,24".
std::optional<std::uint64_t> stated_header_line(std::string_view line) {
  constexpr std::string_view kSays = "Headers Row";
  const std::string_view text = without_padding(line);
  if (!text.starts_with(kSays) || text.size() < kSays.size() + 2) return std::nullopt;
  double number = 0.0;
  const std::string_view said = without_padding(text.substr(kSays.size() + 1));
  if (parse_number(said, number) != NumberKind::kNumber || !(number >= 2.0)) return std::nullopt;
  return static_cast<std::uint64_t>(std::min(number, 1e6));
}

bool says_utc(std::string_view line) {
  constexpr std::string_view kSays = "Time Zone";
  const std::string_view text = without_padding(line);
  if (!text.starts_with(kSays) || text.size() < kSays.size() + 2) return false;
  std::string_view zone = text.substr(kSays.size() + 1);
  return is_one_of("utc gmt",
                   lower_case(without_padding(zone.substr(0, zone.find(text[kSays.size()])))));
}

}  // namespace

TitleLines titles_by_their_word(std::string_view text, std::size_t offset,
                                const TableLayout& layout) {
  constexpr std::uint64_t kLookedAt = 64;
  TitleLines titles;
  std::optional<std::uint64_t> header;
  for (; offset < text.size() && titles.lines < kLookedAt; ++titles.lines) {
    const std::uint64_t number = layout.lines_before + titles.lines + 1;
    const Line line = line_at(text, offset, layout.line_end);
    if (line.text.size() > kLongestLine) break;
    if (header == number) {
      titles.offset = offset;
      return is_blank_line(line.text) ? TitleLines() : titles;
    }
    if (!header) header = stated_header_line(line.text);
    if (header && *header <= number) break;
    if (titles.first.empty()) titles.first = line.text;
    titles.says_utc = titles.says_utc || says_utc(line.text);
    offset = line.next;
  }
  return {};
}

Result<TitleLines> titles_above(std::string_view text, std::size_t offset,
                                const TableLayout& layout) {
  constexpr int kLookedAt = 16;
  const std::size_t columns = layout.contents.size();
  TitleLines titles;
  std::optional<Error> doubt;
  std::uint64_t lines = 0;
  for (int i = 0; i < kLookedAt && offset < text.size() && columns > 1;) {
    const Line line = line_at(text, offset, layout.line_end);
    if (line.text.size() > kLongestLine) break;
    if (is_blank_line(line.text) || has_comment_sign(line.text)) {
      ++lines;
      offset = line.next;
      continue;
    }
    const LineContent content = content_of_line(line.text, layout.delimiter);
    const auto names = header_names(line.text, layout.delimiter);
    if (names && names->size() == columns) {
      if (lines == 0) return TitleLines();
      if (doubt) return *std::move(doubt);
      titles.lines = lines;
      titles.offset = offset;
      return titles;
    }
    // A record, or a header whose words are not known.
    if (content.filled >= columns || names) return TitleLines();
    if (content.numbers > 0 && !doubt) {
      doubt = Error{ErrorCode::kMalformedRecord,
                    excerpt(line.text) +
                        " stands above the header and has values in it; if it is no part of the "
                        "table, remove the line or begin it with #",
                    {}};
      doubt->location.line = lines + 1;
    }
    if (titles.first.empty()) titles.first = line.text;
    ++lines;
    ++i;
    offset = line.next;
  }
  return TitleLines();
}

}  // namespace beespace::io
