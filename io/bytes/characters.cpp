#include "io/bytes/characters.hpp"

#include <algorithm>

namespace beespace::io {
namespace {

unsigned char byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
}

// By going back to the last '*' only, where a word of a file, however long, needs no stack.
bool matches(std::string_view pattern, std::string_view word) {
  std::size_t at = 0;  // of the pattern
  std::size_t star = std::string_view::npos;
  std::size_t resume = 0;  // of the word, after what that '*' stands for
  for (std::size_t i = 0; i < word.size();) {
    if (at < pattern.size() && pattern[at] == '*') {
      star = at++;
      resume = i;
    } else if (at < pattern.size() && (pattern[at] == '?' || pattern[at] == word[i])) {
      ++at;
      ++i;
    } else if (star != std::string_view::npos) {
      at = star + 1;
      i = ++resume;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', at) == std::string_view::npos;
}

}  // namespace

void append_utf8(std::string& text, std::uint32_t character) {
  const auto follows = [&](unsigned int bits) {
    text += static_cast<char>(0x80u | (character >> bits & 0x3Fu));
  };
  if (character < 0x80) {
    text += static_cast<char>(character);
  } else if (character < 0x800) {
    text += static_cast<char>(0xC0u | character >> 6u);
    follows(0);
  } else if (character < 0x1'0000) {
    text += static_cast<char>(0xE0u | character >> 12u);
    follows(6);
    follows(0);
  } else {
    text += static_cast<char>(0xF0u | character >> 18u);
    follows(12);
    follows(6);
    follows(0);
  }
}

std::size_t utf8_length(std::string_view text) {
  const unsigned char lead = byte_at(text, 0);
  if (lead < 0x80) return 1;
  std::size_t length = 0;
  unsigned char lowest = 0x80;
  unsigned char highest = 0xBF;
  if (lead >= 0xC2 && lead <= 0xDF) {
    length = 2;
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    length = 3;
    if (lead == 0xE0) lowest = 0xA0;   // shorter would do
    if (lead == 0xED) highest = 0x9F;  // surrogates
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    length = 4;
    if (lead == 0xF0) lowest = 0x90;
    if (lead == 0xF4) highest = 0x8F;  // beyond U+10FFFF
  }
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned char next = byte_at(text, i);
    if (next < lowest || next > highest) return 0;
    lowest = 0x80;
    highest = 0xBF;
  }
  return length;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  unsigned char before = 0;
  for (char& c : lower) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 'A' && byte <= 'Z') c = static_cast<char>(byte + 32);
    // U+00C0 ... U+00DE without the multiplication sign; U+0410 ... U+042F in two halves.
    if (before == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97) {
      c = static_cast<char>(byte + 0x20);
    }
    if (before == 0xD0 && byte >= 0x90 && byte <= 0x9F) c = static_cast<char>(byte + 0x20);
    if (before == 0xD0 && byte >= 0xA0 && byte <= 0xAF) {
      c = static_cast<char>(byte - 0x20);
      *(&c - 1) = '\xD1';
    }
    before = byte;
  }
  return lower;
}

std::string_view without_padding(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_one_of(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t blank = std::min(words.find(' '), words.size());
    if (matches(words.substr(0, blank), word)) return true;
    words.remove_prefix(std::min(blank + 1, words.size()));
  }
  return false;
}

bool is_blank_line(std::string_view line) {
  return std::all_of(line.begin(), line.end(), is_blank);
}

}  // namespace beespace::io
