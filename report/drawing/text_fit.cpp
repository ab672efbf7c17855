#include "report/drawing/text_fit.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::report {
namespace {

// Of DejaVu Sans, the widest of the fonts, from ' ' to '~', in hundredths of the size, rounded up.
constexpr std::array<std::uint8_t, 95> kWidths = {
    32, 41, 46, 84, 64, 96, 78, 28, 40,  40, 50, 84, 32, 37, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 54, 100, 69, 69, 70, 77, 64, 58, 78, 76, 30, 30, 66, 56, 87, 75, 79,
    61, 79, 70, 64, 62, 74, 69, 99, 69,  62, 69, 40, 34, 40, 84, 50, 50, 62, 64, 55, 64, 62, 36, 64,
    64, 28, 28, 58, 28, 98, 64, 62, 64,  64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84};

// In parts of the size.
double character_width(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  if (first >= ' ' && first <= '~') return kWidths[first - std::size_t{' '}] / 100.0;
  if (first < 0xE0) return 0.75;   // Latin, Greek, Cyrillic and the like
  if (first == 0xE2) return 0.85;  // dashes, a minus
  return 1.05;                     // the rest of the world, at its widest
}

std::string_view first_character(std::string_view text) {
  return text.substr(0, std::max<std::size_t>(1, io::utf8_length(text)));
}

}  // namespace

double text_width(std::string_view text, double size) {
  double width = 0.0;
  while (!text.empty()) {
    const std::string_view character = first_character(text);
    width += character_width(character);
    text.remove_prefix(character.size());
  }
  return width * size;
}

std::string fitted(std::string_view text, double size, double width) {
  if (text_width(text, size) <= width) return std::string(text);
  constexpr std::string_view kEllipsis = "\u2026";
  double room = width / size - character_width(kEllipsis);
  std::string out;
  while (!text.empty()) {
    const std::string_view character = first_character(text);
    room -= character_width(character);
    if (room < 0.0) break;
    out += character;
    text.remove_prefix(character.size());
  }
  return out += kEllipsis;
}

std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (word.empty()) continue;
    if (!lines.empty()) {
      const std::string longer = lines.back() + ' ' + std::string(word);
      if (text_width(longer, size) <= width) {
        lines.back() = longer;
        continue;
      }
    }
    lines.push_back(fitted(word, size, width));
  }
  return lines;
}

}  // namespace beespace::report
