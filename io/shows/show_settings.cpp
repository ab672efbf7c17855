#include "io/shows/show_settings.hpp"

#include "io/bytes/number_text.hpp"
#include "io/shows/show_limits.hpp"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Found = Result<std::optional<ShowValue>>;

constexpr double kFullTurn_deg = 360.0;

// What lies below the root on that way; nothing where a part of it is missing.
Found at(ShowDocuments& documents, std::initializer_list<std::string_view> way) {
  std::optional<ShowValue> value = documents.root();
  for (const std::string_view key : way) {
    auto member = documents.member(*value, key);
    if (!member) return member;
    value = std::move(member).value();
    if (!value) break;
  }
  return value;
}

// Names of moments; what is no such is passed over: nothing but a picture depends on them.
std::optional<Error> read_cues(ShowDocuments& documents, std::vector<ShowCue>& cues) {
  const auto sheet = at(documents, {"settings", "cues", "items"});
  if (!sheet) return sheet.error();
  JsonArray items;
  if (!*sheet || !(*sheet)->element.get(items)) return std::nullopt;
  for (const JsonElement item : items) {
    const auto time = json_member(item, "time");
    const auto name = json_member(item, "name");
    ShowCue cue;
    std::string_view text;
    if (!time || !read_json(*time, cue.time_s) || !name || !name->get(text)) continue;
    cue.name = std::string(text);
    cues.push_back(std::move(cue));
  }
  return std::nullopt;
}

// Latitude and longitude in 10^-7 degrees, and perhaps millimetres above mean sea level, as
// Skybrush writes them: whole numbers. Degrees are not guessed at, as it is not known which comes
// first.
bool read_origin(JsonElement element, ShowPlace& place) {
  constexpr double kSteps = 1e7;
  JsonArray list;
  if (!element.get(list) || list.size() < 2 || list.size() > 3) return false;
  std::vector<std::int64_t> numbers;
  for (const JsonElement item : list) {
    std::int64_t number = 0;
    const bool absent = item.is_null() && numbers.size() == 2;
    if (absent) continue;
    if (!item.get(number)) return false;
    numbers.push_back(number);
  }
  const auto latitude = static_cast<double>(numbers[0]);
  const auto longitude = static_cast<double>(numbers[1]);
  const bool degrees = std::abs(latitude) <= 360.0 && std::abs(longitude) <= 360.0;
  if (degrees || std::abs(latitude) > 90.0 * kSteps || std::abs(longitude) > 180.0 * kSteps) {
    return false;
  }
  place.latitude_deg = latitude / kSteps;
  place.longitude_deg = longitude / kSteps;
  if (numbers.size() == 3) place.height_m = static_cast<double>(numbers[2]) / 1000.0;
  return true;
}

// Also a number that is written as text: "59".
bool read_heading(JsonElement element, double& heading_deg) {
  if (read_json(element, heading_deg)) return true;
  std::string_view text;
  if (!element.get(text)) return false;
  const std::optional<double> number = parse_number(text);
  if (!number || !std::isfinite(*number)) return false;
  heading_deg = *number;
  return true;
}

// Of an origin in degrees: how to say which is the longitude; nothing where it is none.
std::string degrees_question(JsonElement origin, JsonElement location) {
  JsonArray list;
  if (!origin.get(list) || list.size() < 2) return {};
  std::vector<double> numbers;
  for (const JsonElement item : list) {
    double number = 0.0;
    if (!read_json(item, number)) break;
    numbers.push_back(number);
  }
  if (numbers.size() < 2 || std::abs(numbers[0]) > 180.0 || std::abs(numbers[1]) > 180.0) return {};
  const auto heading = json_member(location, "orientation");
  double heading_deg = 0.0;
  if (!heading || !read_heading(*heading, heading_deg)) heading_deg = 0.0;
  const std::string one = exact(numbers[0]);
  const std::string other = exact(numbers[1]);
  const std::string rest =
      "," + exact(numbers.size() > 2 ? numbers[2] : 0.0) + "," + exact(heading_deg);
  return "its origin is in degrees, which Skybrush does not write, and does not say whether the "
         "longitude comes first: on a map it is shown by 'beespace export' with --origin " +
         one + "," + other + rest + " if it does, otherwise with --origin " + other + "," + one +
         rest + (numbers.size() > 2 ? "" : " (with the height of the place instead of 0)");
}

// The axes of Skybrush are north, west, up (nwu) before they are turned.
bool read_axes(JsonElement location, ShowPlace& place) {
  const auto type = json_member(location, "type");
  if (!type) return true;
  std::string_view text;
  if (!type->get(text)) return false;
  place.y_to_the_right = text == "neu";
  return text == "nwu" || text == "neu";
}

std::optional<Error> read_place(ShowDocuments& documents, RecordingAssembly& assembly,
                                std::optional<ShowPlace>& place) {
  const auto location = at(documents, {"environment", "location"});
  if (!location) return location.error();
  if (!*location) return std::nullopt;
  const JsonElement element = (*location)->element;
  const auto not_taken = [&](std::string_view what) {
    assembly.note("the location of the show is not taken, as " + std::string(what) +
                  "; on a map it is shown by 'beespace export' with --origin");
    return std::nullopt;
  };
  ShowPlace read;
  const auto origin = json_member(element, "origin");
  if (!origin) return not_taken("it has no origin");
  if (!read_origin(*origin, read)) {
    if (const std::string question = degrees_question(*origin, element); !question.empty()) {
      assembly.note("the location of the show is not taken, as " + question);
      return std::nullopt;
    }
    return not_taken(
        "its origin is no latitude and longitude in whole 10^-7 degrees, with or without "
        "millimetres above mean sea level");
  }
  const auto heading = json_member(element, "orientation");
  if (!heading) return not_taken("its orientation, where the x axis points, is not given");
  if (!read_heading(*heading, read.heading_deg)) {
    return not_taken("its orientation, where the x axis points, is " +
                     std::string(json_kind(*heading)) + ", and no number of degrees");
  }
  if (std::abs(read.heading_deg) > kFullTurn_deg) {
    return not_taken("its orientation of " + exact(read.heading_deg) +
                     " is more than a full turn in degrees");
  }
  if (!read_axes(element, read)) return not_taken("its axes are neither nwu nor neu");
  place = read;
  return std::nullopt;
}

}  // namespace

std::optional<Error> read_show_settings(ShowDocuments& documents, RecordingAssembly& assembly) {
  auto limits = read_show_limits(documents);
  if (!limits) return limits.error();
  if (limits->least_distance_m) assembly.declare_threshold(*limits->least_distance_m);
  ShowFacts facts;
  facts.limits = std::move(limits->limits);
  if (auto error = read_cues(documents, facts.cues)) return error;
  if (auto error = read_place(documents, assembly, facts.place)) return error;
  assembly.declare_show(std::move(facts));
  return std::nullopt;
}

}  // namespace beespace::io
