// Bytes as characters: UTF-8, lower case, blanks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

// The length of the well-formed UTF-8 sequence at the start of `text` (Unicode 15, table 3-7);
// 0 when there is none.
std::size_t utf8_length(std::string_view text);

// Writes a character behind `text`, in UTF-8.
void append_utf8(std::string& text, std::uint32_t character);

// In lower case: ASCII, the letters of western Europe, and Cyrillic, in UTF-8.
std::string lower_case(std::string_view text);

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

std::string_view without_padding(std::string_view text);

// Whether the word is one of `words`, which have blanks between them. In these "*" stands for any
// bytes, and "?" for one: "coord*".
bool is_one_of(std::string_view words, std::string_view word);

// Whether the line holds nothing but blanks.
bool is_blank_line(std::string_view line);

}  // namespace beespace::io
