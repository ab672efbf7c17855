#include "io/bytes/windows_1252.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::io {
namespace {

constexpr std::uint16_t kNoCharacter = 0xFFFD;  // U+FFFD, the replacement character

// From 0x80 to 0x9F; the others are as in Unicode.
constexpr std::array<std::uint16_t, 32> kCharacters = {
    0x20AC,       kNoCharacter, 0x201A, 0x0192, 0x201E, 0x2026,       0x2020, 0x2021,
    0x02C6,       0x2030,       0x0160, 0x2039, 0x0152, kNoCharacter, 0x017D, kNoCharacter,
    kNoCharacter, 0x2018,       0x2019, 0x201C, 0x201D, 0x2022,       0x2013, 0x2014,
    0x02DC,       0x2122,       0x0161, 0x203A, 0x0153, kNoCharacter, 0x017E, 0x0178};

bool is_ascii(char c) {
  return static_cast<unsigned char>(c) < 0x80;
}

bool is_utf8(std::string_view text) {
  while (true) {
    const auto next = std::find_if_not(text.begin(), text.end(), is_ascii);
    text.remove_prefix(static_cast<std::size_t>(next - text.begin()));
    if (text.empty()) return true;
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
}

}  // namespace

std::optional<Bytes> from_windows_1252(std::string_view text) {
  if (is_utf8(text)) return std::nullopt;
  std::string converted;
  converted.reserve(text.size() + text.size() / 8);
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    append_utf8(converted, byte >= 0x80 && byte < 0xA0 ? kCharacters[byte - 0x80u] : byte);
  }
  return copy_of(converted);
}

}  // namespace beespace::io
