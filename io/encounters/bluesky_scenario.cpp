#include "io/encounters/bluesky_scenario.hpp"

#include "io/aircraft/aircraft_report.hpp"
#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"
#include "io/encounters/air_data.hpp"
#include "io/encounters/encounter_lines.hpp"
#include "io/encounters/scenario_words.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/text_check.hpp"
#include "io/table/table_layout.hpp"
#include "io/units/units.hpp"

#include <beespace/geodesy.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Words = std::vector<std::string>;

constexpr std::string_view kScenario = "a BlueSky scenario";
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

constexpr LeftOutReason kCreateOthers = {
    "of commands that create aircraft in other ways (as MCRE, SYN, CALL)",
    "let BlueSky save the scenario with its aircraft, or write them with CRE"};

constexpr LeftOutReason kNotKnown = {
    "of commands that are not known here, or are for aircraft that CRE has not created by then",
    "replay the log that BlueSky writes (CRELOG)"};

// What only shows, asks or sets something up, or makes aircraft keep their distance.
constexpr std::string_view kHarmless =
    "POS AIRPORT AIRWAY AIRWAYS AWY RUNWAYS LISTRTE DUMPRTE COLOR COLOUR COL TRAIL TRAILS SSD PAN "
    "ZOOM SHOWTRAF SHOWPOLY SHOWND SWRAD DISP ND LABEL INFO GROUP UNGROUP SYMBOL ECHO PRINT HELP "
    "LISTAC DIST CALC DEBUG ENG SCEN SCENARIO DATE TIME SEED DT DTMULT RTF FF FWD FASTFORWARD OP "
    "START RUN CONTINUE PLAY HOLD PAUSE STOP QUIT Q END EXIT CLOSE BENCHMARK SAVEIC SAVE LOG "
    "CRELOG SNAPLOG INSTLOG SKYLOG FLSTLOG CONFLOG METRIC METRICS PLUGIN PLUGINS SCREENSHOT CD "
    "CHDIR IMPL IMPLEMENTATION INSEDIT DOC MAGVAR TAXI AREA BOX CIRCLE LINE LINES POLY POLYGON "
    "POLYALT POLYLINE POLYLINES DEFWPT FILTERALT GETWIND ASAS CDMETHOD RESO RESOOFF NORESO "
    "PRIORULES ZONER ZONEDH RSZONER RSZONEDH DTLOOK DTNOLOOK RMETHH RMETHV HRESOM VRESOM RFACH "
    "RFACV RESOFACH RESOFACV";
constexpr std::string_view kCreating =
    "MCRE CRECONFS CRECONF CRECMD SYN CALL PCALL IC LOAD OPEN BATCH TRAFGEN SCHEDULE DELAY";
constexpr std::string_view kObeyed = "CRE MOVE DEL RESET WIND";

struct ScenarioAircraft {
  std::string id;
  std::uint64_t line = 0;
  double time_s = 0.0;
  double longitude_deg = 0.0;
  double latitude_deg = 0.0;
  double height_ft = 0.0;
  double heading_deg = 0.0;
  AirSpeed speed;
  double climb_fpm = 0.0;
  bool deleted = false;
  bool manoeuvres = false;
};

bool is_all(std::string_view word) {
  return word == "ALL" || word == "*";
}

Error wrong(std::string message) {
  return {ErrorCode::kMalformedRecord, std::move(message) + std::string(kOrLeaveOut), {}};
}

class Scenario {
 public:
  explicit Scenario(RecordingAssembly& assembly) : assembly_(assembly) {}

  std::optional<Error> read(std::string_view text) {
    std::vector<Command> commands;
    std::uint64_t number = 0;
    for (std::size_t offset = 0; offset < text.size();) {
      const Line line = line_at(text, offset, '\n');
      offset = line.next;
      ++number;
      if (says_nothing(line.text)) continue;
      const auto timed = timed_commands(line.text);
      if (!timed) {
        if (auto fatal = bad(wrong(excerpt(line.text) +
                                   " has no time before it, as in 00:00:10.00>CRE ...; correct it"),
                             number)) {
          return fatal;
        }
        continue;
      }
      for (Words& words : commands_in(timed->commands)) {
        commands.push_back({timed->time_s, number, std::move(words)});
      }
    }
    std::stable_sort(commands.begin(), commands.end(),
                     [](const Command& a, const Command& b) { return a.time_s < b.time_s; });
    for (Command& command : commands) {
      put_in_order(command.words);
      std::string id = command.words.size() > 1 ? command.words[1] : std::string();
      if (auto error = obey(command)) {
        if (auto fatal = bad(*std::move(error), command.line, id)) return fatal;
      }
    }
    return std::nullopt;
  }

  std::optional<Error> hand_over() {
    for (const ScenarioAircraft& of : aircraft_) {
      if (auto error = hand_over(of)) {
        if (auto fatal = bad(*std::move(error), of.line, of.id)) return fatal;
      }
    }
    say();
    return std::nullopt;
  }

 private:
  struct Command {
    double time_s;
    std::uint64_t line;
    Words words;
  };

  std::optional<Error> bad(Error error, std::uint64_t line, std::string_view id = {}) {
    error.location.line = line;
    return assembly_.bad(std::move(error), id);
  }

  ScenarioAircraft* find(std::string_view id) {
    for (ScenarioAircraft& of : aircraft_) {
      if (of.id == id && !of.deleted) return &of;
    }
    return nullptr;
  }

  // "KL204 HDG 90" is "HDG KL204 90", and commands have several names.
  void put_in_order(Words& words) {
    std::string& name = words.front();
    const bool of_aircraft = find(name) != nullptr || is_all(name);
    if (words.size() > 1 && of_aircraft && !is_known(name) &&
        (is_known(words[1]) || find(words[1]) == nullptr)) {
      std::swap(name, words[1]);
    }
    if (name == "CREATE") name = "CRE";
    if (name == "DELETE") name = "DEL";
  }

  static bool is_known(std::string_view name) {
    return is_one_of(kObeyed, name) || is_one_of(kCreating, name) || is_one_of(kHarmless, name);
  }

  std::optional<Error> obey(const Command& command) {
    const Words& words = command.words;
    const std::string& name = words.front();
    if (name == "CRE") return create(command);
    if (name == "MOVE") return move(command);
    if (name == "DEL") {
      remove(words);
    } else if (name == "RESET") {
      remove({name, "ALL"});
    } else if (name == "WIND") {
      wind_ = true;
    } else if (is_one_of(kCreating, name)) {
      assembly_.leave_out(kCreateOthers, {});
    } else if (!is_one_of(kHarmless, name)) {
      manoeuvre(command);
    }
    return std::nullopt;
  }

  void manoeuvre(const Command& command) {
    const Words& words = command.words;
    const std::string& name = words.front();
    // An aircraft alone asks where it is.
    if (words.size() == 1 && find(name) != nullptr) return;
    bool known = false;
    for (ScenarioAircraft& of : aircraft_) {
      const bool meant =
          of.id == name || (words.size() > 1 && (of.id == words[1] || is_all(words[1])));
      if (of.deleted || !meant) continue;
      of.manoeuvres = true;
      known = true;
    }
    if (!known) return assembly_.leave_out(kNotKnown, {});
    if (first_manoeuvre_.empty()) {
      first_manoeuvre_ = name + " in line " + std::to_string(command.line);
    }
  }

  // CRE id,type,lat,lon,hdg,alt,spd
  std::optional<Error> create(const Command& command) {
    const Words& words = command.words;
    if (words.size() < 4 || words[1].empty()) {
      return wrong(
          "CRE needs an id, a type, a latitude, a longitude, a heading, an altitude and a "
          "speed; correct it");
    }
    if (find(words[1]) != nullptr) {
      return wrong("CRE " + excerpt(words[1]) +
                   ": there is an aircraft of that id already; give this one another");
    }
    ScenarioAircraft of;
    of.id = words[1];
    if (auto error = place(words, 3, "CRE", of)) return error;
    if (auto error = state(words, {5, 6, 7}, "CRE", of, true)) return error;
    of.time_s = command.time_s;
    of.line = command.line;
    aircraft_.push_back(std::move(of));
    return std::nullopt;
  }

  // MOVE id,lat,lon,[alt,hdg,spd,vspd]; what is not given stays.
  std::optional<Error> move(const Command& command) {
    const Words& words = command.words;
    ScenarioAircraft* const of = words.size() > 1 ? find(words[1]) : nullptr;
    if (of == nullptr) {
      return wrong("MOVE of an aircraft that CRE has not created; correct it");
    }
    ScenarioAircraft moved = *of;
    if (auto error = place(words, 2, "MOVE", moved)) return error;
    if (auto error = state(words, {5, 4, 6}, "MOVE", moved, false)) return error;
    if (words.size() > 7 && !words[7].empty()) {
      const auto climb = parse_number(words[7]);
      if (!climb || !in_motion_domain(*climb)) {
        return wrong("MOVE: " + excerpt(words[7]) + " is no climb rate; correct it");
      }
      moved.climb_fpm = *climb;
    }
    moved.time_s = command.time_s;
    moved.line = command.line;
    *of = std::move(moved);
    return std::nullopt;
  }

  // "DEL WIND" too: there was one while aircraft flew.
  void remove(const Words& words) {
    for (std::size_t i = 1; i < words.size(); ++i) {
      for (ScenarioAircraft& of : aircraft_) {
        if (of.deleted || (!is_all(words[i]) && of.id != words[i])) continue;
        of.deleted = true;
        ++deleted_;
      }
    }
  }

  // Latitude and longitude from word `at` on.
  static std::optional<Error> place(const Words& words, std::size_t at, const std::string& command,
                                    ScenarioAircraft& of) {
    for (const std::size_t i : {at, at + 1}) {
      const std::string word = i < words.size() ? words[i] : std::string();
      const auto degrees = degrees_in(word);
      if (!degrees || !in_motion_domain(*degrees)) {
        return wrong(command + " " + of.id + ": " + excerpt(word) + " is no " +
                     (i == at ? "latitude" : "longitude") +
                     " in degrees; places that BlueSky's navigation data name, and those that it "
                     "chooses, are known to BlueSky alone: write them in degrees");
      }
      (i == at ? of.latitude_deg : of.longitude_deg) = *degrees;
    }
    return std::nullopt;
  }

  struct Places {
    std::size_t heading;
    std::size_t altitude;
    std::size_t speed;
  };

  static std::optional<Error> state(const Words& words, const Places& at,
                                    const std::string& command, ScenarioAircraft& of, bool needed) {
    const auto word = [&words](std::size_t place) {
      return place < words.size() ? words[place] : std::string();
    };
    const auto missing = [&](const std::string& text, const char* what) {
      return wrong(command + " " + of.id + ": " + excerpt(text) + " is no " + what +
                   "; correct it");
    };
    if (const std::string text = word(at.heading); needed || !text.empty()) {
      const auto heading = heading_in(text);
      if (!heading) return missing(text, "heading in degrees from true north");
      of.heading_deg = *heading;
    }
    if (const std::string text = word(at.altitude); needed || !text.empty()) {
      const auto height = feet_in(text);
      if (!height || !in_motion_domain(*height)) return missing(text, "altitude");
      of.height_ft = *height;
    }
    if (const std::string text = word(at.speed); needed || !text.empty()) {
      const auto speed = air_speed_in(text);
      if (!speed) return missing(text, "calibrated speed or Mach number");
      of.speed = *speed;
    }
    return std::nullopt;
  }

  // East, north, up; unknown where the wind, or the air at that height, is not known, and where a
  // command changes it.
  Velocity velocity_of(const ScenarioAircraft& of, double height_m) {
    constexpr double kLowest_m = -1000.0;
    constexpr double kFastest_mps = 1e4;
    constexpr double kMostTurns_deg = 1e12;
    if (of.manoeuvres) {
      ++manoeuvring_;
      return {kUnknown, kUnknown, kUnknown};
    }
    if (wind_ || height_m < kLowest_m || height_m > kHighestAir_m ||
        std::abs(of.heading_deg) > kMostTurns_deg) {
      ++without_speed_;
      return {kUnknown, kUnknown, kUnknown};
    }
    const double stated_mps = in_metric(of.speed.value, Unit::kKnot);
    const double speed_mps = of.speed.mach ? true_of_mach(of.speed.value, height_m)
                                           : true_of_calibrated(stated_mps, height_m);
    if (!(speed_mps < kFastest_mps)) {
      ++without_speed_;
      return {kUnknown, kUnknown, kUnknown};
    }
    const LocalVelocity velocity =
        local_velocity(speed_mps, of.heading_deg, in_metric(of.climb_fpm, Unit::kFootPerMinute));
    return {without_dust(velocity.east_mps), without_dust(velocity.north_mps),
            without_dust(velocity.up_mps)};
  }

  std::optional<Error> hand_over(const ScenarioAircraft& of) {
    if (of.deleted && find(of.id) != nullptr) return std::nullopt;  // created anew
    const double height_m = in_metric(of.height_ft, Unit::kFoot);
    const Point place{of.longitude_deg, of.latitude_deg, without_dust(height_m)};
    if (auto error = impossible_place(place)) return error;
    Origin origin;
    origin.source = assembly_.source() & 0xFF'FFFFu;
    origin.line = of.line & 0xFF'FFFF'FFFFu;
    const Velocity velocity = velocity_of(of, height_m);
    assembly_.tracks().add(of.id, {without_dust(of.time_s), place}, &velocity, origin,
                           of.height_ft);
    return std::nullopt;
  }

  void say() {
    assembly_.note(
        "aircraft are where the scenario creates or moves them; where they fly from "
        "there is for BlueSky to say: replay its log as a table (CRELOG)");
    assembly_.note(
        "calibrated speeds and Mach numbers are taken in the standard atmosphere without "
        "wind, as BlueSky takes them");
    if (manoeuvring_ > 0) {
      assembly_.note(counted(manoeuvring_, "aircraft is", "aircraft are") +
                     " told how to fly from there, the first by " + first_manoeuvre_ +
                     "; that is not followed, so no velocity is known");
    }
    if (without_speed_ > 0) {
      assembly_.note("how fast " + counted(without_speed_, "aircraft is", "aircraft are") +
                     " over ground is not known" +
                     (wind_ ? ": there is a command WIND" : ": it is too high, or too fast"));
    }
    if (deleted_ > 0) {
      assembly_.note(counted(deleted_, "aircraft is", "aircraft are") +
                     " deleted later, and taken as if not");
    }
  }

  RecordingAssembly& assembly_;
  std::vector<ScenarioAircraft> aircraft_;
  std::string first_manoeuvre_;
  std::uint64_t manoeuvring_ = 0;
  std::uint64_t without_speed_ = 0;
  std::uint64_t deleted_ = 0;
  bool wind_ = false;
};

SourceFacts facts() {
  const auto taken = [](const char* of, Unit unit) {
    return UnitTaken{of, unit, UnitEvidence::kNamed, "BlueSky has them so"};
  };
  SourceFacts facts;
  facts.frame = Frame::kWgs84;
  facts.frame_reason = "a scenario says latitude and longitude";
  facts.of_aircraft = true;
  facts.flies_on = true;
  facts.height_unit = Unit::kFoot;
  facts.units = {taken("heights", Unit::kFoot), taken("speeds", Unit::kKnot),
                 taken("climb rates", Unit::kFootPerMinute)};
  facts.description = kBlueSkyScenario;
  return facts;
}

}  // namespace

bool is_bluesky_scenario(std::string_view text) {
  constexpr int kMostLines = 200;
  std::size_t offset = 0;
  for (int i = 0; i < kMostLines && offset < text.size(); ++i) {
    const Line line = line_at(text, offset, '\n');
    offset = line.next;
    if (says_nothing(line.text)) continue;
    return timed_commands(line.text).has_value();
  }
  return false;
}

std::optional<Error> read_bluesky_scenario(std::string_view text, RecordingAssembly& assembly) {
  if (auto problem = text_problem(text)) return problem;
  if (auto problem = aircraft_problem(assembly.options(), kScenario)) return problem;
  if (assembly.has_several()) {
    return Error{ErrorCode::kInvalidArgument,
                 "a BlueSky scenario is read alone: its times are its own; leave the others out",
                 {}};
  }
  if (auto error = assembly.agree(facts())) return error;
  Scenario scenario(assembly);
  if (auto error = scenario.read(text)) return error;
  return scenario.hand_over();
}

}  // namespace beespace::io
