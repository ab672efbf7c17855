#include "report/page.hpp"

#include <beespace/version.hpp>

#include <zlib.h>

#include <array>
#include <charconv>
#include <cstddef>

namespace beespace::report {
namespace {

constexpr std::string_view kPlace = "<!-- beespace: data -->";

// So that no text of a user ends the element that the JSON stands in.
std::string harmless(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    switch (c) {
      case '<':
        text += "\\u003c";
        break;
      case '>':
        text += "\\u003e";
        break;
      case '&':
        text += "\\u0026";
        break;
      default:
        text += c;
    }
  }
  return text;
}

// Eight digits in base 16.
std::string checksum_of(std::string_view text) {
  const uLong sum = adler32(adler32(0, nullptr, 0), reinterpret_cast<const Bytef*>(text.data()),
                            static_cast<uInt>(text.size()));
  std::array<char, 8> digits{};
  const auto [end, _] = std::to_chars(digits.data(), digits.data() + digits.size(), sum, 16);
  const std::string told(digits.data(), end);
  return std::string(8 - told.size(), '0') + told;
}

}  // namespace

std::string page_json(const std::function<void(io::JsonWriter&)>& write_swarms, Ground ground) {
  std::string text;
  io::JsonWriter json(text);
  json.begin_object(io::JsonLayout::kTight).member("format", 1u).member("beespace", version());
  if (ground == Ground::kWith) json.member("ground", true);
  json.begin_array("swarms");
  write_swarms(json);
  json.end().end();
  return text;
}

void write_page(std::string_view page, std::string_view json, const Columns& columns,
                const PageSink& sink, Ground ground) {
  if (const auto [before, after] = around_ground(page);
      ground == Ground::kWithout && !after.empty()) {
    sink(before);
    page = after;
  }
  const std::size_t place = page.find(kPlace);
  sink(page.substr(0, place));
  sink("<script type=\"application/json\" id=\"beespace-page\">");
  const std::string text = harmless(json);
  sink(text);
  sink("</script>\n");
  for (std::size_t i = 0; i < columns.elements().size(); ++i) {
    sink("<script type=\"text/plain\" id=\"beespace-" + std::to_string(i) + "\">");
    sink(columns.elements()[i]);
    sink("</script>\n");
  }
  // Behind all others: a page that was cut off lacks it.
  sink("<script type=\"text/plain\" id=\"beespace-end\">" + checksum_of(text) + " " +
       std::to_string(columns.elements().size()) + "</script>\n");
  sink(page.substr(place + kPlace.size()));
}

}  // namespace beespace::report
