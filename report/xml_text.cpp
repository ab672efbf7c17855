#include "report/xml_text.hpp"

#include "io/bytes/characters.hpp"

#include <algorithm>

namespace beespace::report {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// The character at the start of `rest`, taken from it, or what is in its place.
std::string_view next_character(std::string_view& rest) {
  const std::size_t length = std::max<std::size_t>(1, io::utf8_length(rest));
  const bool broken = io::utf8_length(rest) == 0;
  const std::string_view character = rest.substr(0, length);
  rest.remove_prefix(length);
  const auto first = static_cast<unsigned char>(character.front());
  const bool control = first < 0x20 && first != '\t' && first != '\n' && first != '\r';
  const bool forbidden = character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF";
  return broken || control || first == 0x7F || forbidden ? kReplacement : character;
}

}  // namespace

void append_xml_text(std::string& out, std::string_view text) {
  while (!text.empty()) {
    const std::string_view character = next_character(text);
    switch (character.front()) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      case '\t':
        out += "&#9;";
        break;
      case '\n':
        out += "&#10;";
        break;
      case '\r':
        out += "&#13;";
        break;
      default:
        out += character;
    }
  }
}

std::string xml_text(std::string_view text) {
  std::string out;
  append_xml_text(out, text);
  return out;
}

std::string one_line(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::string_view character = next_character(text);
    const bool blank = character == "\t" || character == "\n" || character == "\r";
    out += blank ? " " : character;
  }
  return out;
}

}  // namespace beespace::report
