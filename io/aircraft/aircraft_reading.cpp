#include "io/aircraft/aircraft_reading.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/aircraft_object.hpp"
#include "io/aircraft/state_vector.hpp"
#include "io/problems/excerpt.hpp"

#include <cstdint>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

// readsb and dump1090 write ages of positions in tenths of a second, so that one position seems to
// be that much younger or older in the next file.
constexpr double kAgeRounding_s = 0.25;

bool has_member(JsonElement root, std::string_view key) {
  JsonMap members;
  JsonElement found;
  return root.get(members) && members.get(key, found);
}

AircraftChoice choice_of(const RecordingAssembly& assembly) {
  return {assembly.options().heights, assembly.options().grounded};
}

// The list under `key`; nothing where it is null, as OpenSky has it when no aircraft flies.
Result<std::optional<JsonArray>> list_of(JsonElement root, std::string_view key) {
  const auto member = json_member(root, key);
  if (!member) return std::optional<JsonArray>();
  JsonArray list;
  if (member->get(list)) return std::optional(list);
  return Error{ErrorCode::kMalformedRecord,
               excerpt(key) + " is " + std::string(json_kind(*member)) +
                   " where a list should be; correct it",
               {}};
}

// Each of the list by `read`, which says what is wrong with one.
template <class Read>
std::optional<Error> read_list(JsonElement root, std::string_view key, RecordingAssembly& assembly,
                               AircraftGathering& gathering, const Read& read) {
  const auto list = list_of(root, key);
  if (!list) return list.error();
  if (!list.value()) return std::nullopt;
  std::uint64_t index = 0;
  AircraftReport report;
  for (const JsonElement element : **list) {
    auto error = read(element, report);
    if (!error) error = gathering.add(report, index + 1);
    if (error) {
      std::string whose(key);
      whose.append("[").append(std::to_string(index)).append("]");
      if (!report.id.empty()) whose.append(" (").append(excerpt(report.id)).append(")");
      error->message.insert(0, whose.append(": "));
      error->location.record = index;
      if (auto fatal = assembly.bad(*std::move(error), report.id)) return fatal;
    }
    ++index;
  }
  return std::nullopt;
}

std::optional<Error> read_aircraft(JsonElement root, RecordingAssembly& assembly) {
  AircraftGathering gathering(choice_of(assembly), assembly);
  if (auto error =
          gathering.begin("aircraft.json of readsb or dump1090", Unit::kFoot, kAgeRounding_s)) {
    return error;
  }
  double now_s = 0.0;
  const auto now = json_member(root, "now");
  if (!now) {
    return Error{ErrorCode::kMissingColumn,
                 "there is no 'now', which tells when the positions were heard; correct it",
                 {}};
  }
  if (!read_json(*now, now_s)) return json_number_problem(*now, "'now'");
  return read_list(root, "aircraft", assembly, gathering,
                   [now_s](JsonElement element, AircraftReport& report) -> std::optional<Error> {
                     report = AircraftReport();
                     JsonMap object;
                     if (element.get(object)) {
                       return read_aircraft_object(object, now_s, report);
                     }
                     return Error{ErrorCode::kMalformedRecord,
                                  "it is " + std::string(json_kind(element)) +
                                      " where an aircraft, an object, should be; correct it",
                                  {}};
                   });
}

std::optional<Error> read_states(JsonElement root, RecordingAssembly& assembly) {
  AircraftGathering gathering(choice_of(assembly), assembly);
  if (auto error = gathering.begin("state vectors of OpenSky", Unit::kMetre, 0.0)) return error;
  return read_list(root, "states", assembly, gathering, read_state_vector);
}

}  // namespace

bool is_aircraft_document(JsonElement root) {
  return has_member(root, "aircraft") || has_member(root, "states");
}

std::optional<Error> read_aircraft_document(JsonElement root, RecordingAssembly& assembly) {
  if (auto error = json_twice(root, {"now", "aircraft", "states"})) return error;
  return has_member(root, "aircraft") ? read_aircraft(root, assembly) : read_states(root, assembly);
}

}  // namespace beespace::io
