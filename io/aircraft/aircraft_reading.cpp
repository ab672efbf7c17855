#include "io/aircraft/aircraft_reading.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/aircraft_object.hpp"
#include "io/aircraft/aircraft_trace.hpp"
#include "io/aircraft/state_vector.hpp"
#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
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

// Where reports are: in the line of a text, or in a document by their number.
using LineNumber = std::optional<std::uint64_t>;

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

// The key under which readsb lists aircraft; the interface of ADS-B Exchange, and those made like
// it, have "ac".
std::string_view list_key(JsonElement root) {
  JsonArray list;
  const auto ac = json_member(root, "ac");
  return !has_member(root, "aircraft") && ac && ac->get(list) ? "ac" : "aircraft";
}

// "now", in seconds since 1970, or, as ADS-B Exchange has it, in milliseconds: its size tells.
double in_seconds(double now) {
  constexpr double kEarliest_ms = 5e11;
  constexpr double kMsPerSecond = 1000.0;
  return now >= kEarliest_ms ? now / kMsPerSecond : now;
}

// A list of what tar1090 keeps to draw trails: the names of files.
bool is_list_of_chunks(JsonElement root) {
  JsonArray names;
  const auto chunks = json_member(root, "chunks");
  if (!chunks || !chunks->get(names) || names.size() == 0) return false;
  for (const JsonElement name : names) {
    std::string_view text;
    if (!name.get(text) || !text.ends_with(".gz")) return false;
  }
  return true;
}

// What these files have: an aircraft is a list of ten values without names.
bool has_aircraft_as_lists(JsonElement root) {
  JsonArray aircraft;
  const auto list = json_member(root, "aircraft");
  if (!list || !list->get(aircraft) || aircraft.size() == 0) return false;
  JsonArray values;
  return (*aircraft.begin()).get(values);
}

// The height of a chunk is the first of three that is there.
Error trails_of_tar1090() {
  return {ErrorCode::kUnsupportedFormat,
          "this is of the chunks that tar1090 keeps to draw trails: their heights are by pressure, "
          "or by satellites where those are missing, and do not say which, so that two cannot be "
          "compared; name what they are made of, aircraft.json or the folder of history_0.json and "
          "so on that readsb or dump1090 writes (beespace replay /run/readsb), or traces of "
          "globe_history",
          {}};
}

class AircraftDocuments {
 public:
  explicit AircraftDocuments(RecordingAssembly& assembly) : assembly_(assembly) {}

  // Errors have the line, where there is one, or the record.
  std::optional<Error> read(JsonElement root, LineNumber line) {
    if (const auto kind = trace_kind(root)) return read_trace(root, *kind, line);
    if (is_list_of_chunks(root) || has_aircraft_as_lists(root)) return trails_of_tar1090();
    if (const auto parts = list_of(root, "files"); parts && parts.value()) {
      for (const JsonElement part : **parts) {
        if (auto error = read(part, line)) return error;
      }
      return std::nullopt;
    }
    auto error = json_twice(root, {"now", "aircraft", "ac", "states"});
    if (!error) {
      error = has_member(root, "states") ? read_states(root, line) : read_aircraft(root, line);
    }
    if (error && line && !error->location.line) error->location.line = line;
    return error;
  }

  // One aircraft, with a time of its own.
  std::optional<Error> read_object(JsonMap object, std::uint64_t line) {
    if (auto error = begin_readsb()) return error;
    AircraftReport report;
    auto error = read_aircraft_object(object, AircraftReport::kUnknown, report);
    if (!error) error = readsb_->add(report, line);
    if (!error) return std::nullopt;
    error->location.line = line;
    return assembly_.bad(*std::move(error), report.id);
  }

 private:
  std::optional<Error> begin_readsb() {
    if (readsb_) return std::nullopt;
    readsb_.emplace(choice_of(assembly_), assembly_);
    return readsb_->begin("aircraft.json of readsb or dump1090", Unit::kFoot, kAgeRounding_s);
  }

  std::optional<Error> begin_opensky() {
    if (opensky_) return std::nullopt;
    opensky_.emplace(choice_of(assembly_), assembly_);
    return opensky_->begin("state vectors of OpenSky", Unit::kMetre, 0.0);
  }

  // Each of the list by `take`, which says what is wrong with one.
  template <class Read>
  std::optional<Error> read_list(JsonElement root, std::string_view key,
                                 AircraftGathering& gathering, LineNumber line, const Read& take) {
    const auto list = list_of(root, key);
    if (!list) return list.error();
    if (!list.value()) return std::nullopt;
    std::uint64_t index = 0;
    AircraftReport report;
    for (const JsonElement element : **list) {
      auto error = take(element, report);
      if (!error) error = gathering.add(report, line.value_or(index + 1));
      if (error) {
        std::string whose(key);
        whose.append("[").append(std::to_string(index)).append("]");
        if (!report.id.empty()) whose.append(" (").append(excerpt(report.id)).append(")");
        error->message.insert(0, whose.append(": "));
        if (line) {
          error->location.line = line;
        } else {
          error->location.record = index;
        }
        if (auto fatal = assembly_.bad(*std::move(error), report.id)) return fatal;
      }
      ++index;
    }
    return std::nullopt;
  }

  std::optional<Error> read_aircraft(JsonElement root, LineNumber line) {
    if (auto error = begin_readsb()) return error;
    double now_s = 0.0;
    const auto now = json_member(root, "now");
    if (!now) {
      return Error{ErrorCode::kMissingColumn,
                   "there is no 'now', which tells when the positions were heard; correct it",
                   {}};
    }
    if (!read_json(*now, now_s)) return json_number_problem(*now, "'now'");
    now_s = in_seconds(now_s);
    assembly_.written_at(now_s);
    return read_list(root, list_key(root), *readsb_, line,
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

  // Those of OpenSky and of readsb have one kind of heights each.
  std::optional<Error> read_trace(JsonElement root, TraceKind kind, LineNumber line) {
    AircraftGathering traces(choice_of(assembly_), assembly_);
    const bool readsb = kind == TraceKind::kReadsb;
    if (auto error = traces.begin(readsb ? "trace of readsb" : "track of OpenSky",
                                  readsb ? Unit::kFoot : Unit::kMetre, 0.0)) {
      return error;
    }
    auto head = read_trace_head(root, kind);
    if (!head) return head.error();
    return read_list(root, trace_key(kind), traces, line,
                     [kind, &head](JsonElement place, AircraftReport& report) {
                       return read_trace_place(place, kind, *head, report);
                     });
  }

  std::optional<Error> read_states(JsonElement root, LineNumber line) {
    if (auto error = begin_opensky()) return error;
    if (const auto time = json_member(root, "time")) {
      double time_s = 0.0;
      if (!read_json(*time, time_s)) return json_number_problem(*time, "'time'");
      assembly_.written_at(time_s);
    }
    return read_list(root, "states", *opensky_, line, read_state_vector);
  }

  RecordingAssembly& assembly_;
  std::optional<AircraftGathering> readsb_;
  std::optional<AircraftGathering> opensky_;
};

// What tar1090 keeps: documents of some minutes, one after the other.
bool is_chunk(JsonElement root) {
  JsonArray parts;
  const auto files = json_member(root, "files");
  if (!files || !files->get(parts) || parts.size() == 0) return false;
  for (const JsonElement part : parts) {
    if (!has_member(part, "now") || !has_member(part, "aircraft")) return false;
  }
  return true;
}

bool is_aircraft_with_time(JsonElement root) {
  JsonMap object;
  return root.get(object) && is_aircraft_object(object) && has_member(root, "now");
}

}  // namespace

bool is_aircraft_document(JsonElement root) {
  JsonArray list;
  const auto ac = json_member(root, "ac");
  if (trace_kind(root) || is_chunk(root) || is_list_of_chunks(root)) return true;
  return has_member(root, "aircraft") || has_member(root, "states") ||
         (has_member(root, "now") && ac && ac->get(list));
}

std::optional<Error> read_aircraft_document(JsonElement root, RecordingAssembly& assembly) {
  return AircraftDocuments(assembly).read(root, std::nullopt);
}

bool is_aircraft_lines(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return false;
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  JsonParser parser;
  JsonElement root;
  if (!parser.parse(text.substr(begin, end - begin), root).empty()) return false;
  return is_aircraft_document(root) || is_aircraft_with_time(root);
}

std::optional<Error> read_aircraft_lines(std::string_view text, RecordingAssembly& assembly) {
  AircraftDocuments documents(assembly);
  JsonParser parser;
  std::uint64_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = without_padding(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    if (line.empty()) continue;
    JsonElement root;
    JsonMap object;
    const std::string_view problem = parser.parse(line, root);
    std::optional<Error> error;
    if (!problem.empty()) {
      error = json_syntax_error(line, problem, "each object must be whole in one line");
    } else if (is_aircraft_document(root)) {
      if (auto fatal = documents.read(root, number)) return fatal;
      continue;
    } else if (root.get(object) && is_aircraft_object(object)) {
      if (auto fatal = documents.read_object(object, number)) return fatal;
      continue;
    } else {
      error = Error{ErrorCode::kUnsupportedFormat,
                    "this line is no list of aircraft, and no aircraft; correct it" +
                        std::string(kOrLeaveOut),
                    {}};
    }
    error->location.line = number;
    if (auto fatal = assembly.bad(*std::move(error))) return fatal;
  }
  return std::nullopt;
}

}  // namespace beespace::io
