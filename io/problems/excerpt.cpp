#include "io/problems/excerpt.hpp"

#include <cstddef>

namespace beespace::io {
namespace {

constexpr std::size_t kLongest = 40;

// Bytes of the UTF-8 character at the front of `text`; 0 when there is none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0u) != 0x80) return 0;
  }
  // U+0080 ... U+009F are control characters too.
  return first == 0xC2 && byte(1) < 0xA0 ? 0 : length;
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string shown = "'";
  std::size_t characters = 0;
  while (!text.empty() && characters < kLongest) {
    const std::size_t length = character_length(text);
    if (length == 0) {
      const auto byte = static_cast<unsigned char>(text.front());
      shown += {'\\', 'x', kHex[byte / 16u], kHex[byte % 16u]};
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
    ++characters;
  }
  return shown + (text.empty() ? "'" : "...'");
}

}  // namespace beespace::io
