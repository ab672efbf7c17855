#include "report/page.hpp"

#include <beespace/version.hpp>

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

}  // namespace

std::string page_json(const std::function<void(io::JsonWriter&)>& write_swarms) {
  std::string text;
  io::JsonWriter json(text);
  json.begin_object(io::JsonLayout::kTight).member("format", 1u).member("beespace", version());
  json.begin_array("swarms");
  write_swarms(json);
  json.end().end();
  return text;
}

void write_page(std::string_view page, std::string_view json, const Columns& columns,
                const PageSink& sink) {
  const std::size_t place = page.find(kPlace);
  sink(page.substr(0, place));
  sink("<script type=\"application/json\" id=\"beespace-page\">");
  sink(harmless(json));
  sink("</script>\n");
  for (std::size_t i = 0; i < columns.elements().size(); ++i) {
    sink("<script type=\"text/plain\" id=\"beespace-" + std::to_string(i) + "\">");
    sink(columns.elements()[i]);
    sink("</script>\n");
  }
  sink(page.substr(place + kPlace.size()));
}

}  // namespace beespace::report
