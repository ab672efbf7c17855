#include "report/page.hpp"

#include "io/json/json_object.hpp"

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

std::string page_json(const std::vector<std::string>& swarms) {
  std::string all = "[";
  for (const std::string& swarm : swarms) {
    if (all.size() > 1) all += ',';
    all += swarm;
  }
  io::JsonObject json;
  json.add_count("format", 1);
  json.add_text("beespace", version());
  json.add_json("swarms", all + ']');
  return json.text();
}

}  // namespace

void write_page(std::string_view page, const std::vector<std::string>& swarms,
                const Columns& columns, const PageSink& sink) {
  const std::size_t place = page.find(kPlace);
  sink(page.substr(0, place));
  sink("<script type=\"application/json\" id=\"beespace-page\">");
  sink(harmless(page_json(swarms)));
  sink("</script>\n");
  for (std::size_t i = 0; i < columns.elements().size(); ++i) {
    sink("<script type=\"text/plain\" id=\"beespace-" + std::to_string(i) + "\">");
    sink(columns.elements()[i]);
    sink("</script>\n");
  }
  sink(page.substr(place + kPlace.size()));
}

}  // namespace beespace::report
