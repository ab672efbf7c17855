#include "io/tracks/fix_quality.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_aircraft.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

// sensor_msgs/NavSatFix: STATUS_NO_FIX is -1. GPS_FIX_TYPE of MAVLink, and of PX4 and Movebank: 0
// and 1 are no fix, 2 is one without a height; so is the Status of ArduPilot's GPS messages. NMEA's
// GGA: a quality of 0 is no fix. Loggers of QStarz have "NO FIX" for VALID.
constexpr double kLeastOfRos = 0.0;
constexpr double kLeastType = 2.0;
constexpr double kLeastQuality = 1.0;

bool ends_as(std::string_view name, std::string_view end) {
  return name == end || (name.size() > end.size() && name.ends_with(end) &&
                         name[name.size() - end.size() - 1] == '_');
}

// Of animals' collars and tags, in their makers' words: Lotek ("3D-V Fix", "No Fix", "3-D
// least-squares", "4 or more SV KF", and "DR", which is dead reckoning), Vectronic
// ("val. GPS-3D"), Telonics ("Succeeded (3D)", "Unresolved QFP", "Failed"), QStarz ("SPS"), NMEA.
// What says none does so whatever stands beside it: "not fixed", "GPS timeout".
constexpr std::string_view kSaysNone =
    "no none not nofix unfixed failed fail failure timeout timed unresolved unsuccessful invalid "
    "false void lost missing 0d 1d insufficient searching kein keine nein ung\u00fcltig ungueltig "
    "dr fehlgeschlagen falsch aucun aucune non sin ninguno falso faux";
constexpr std::string_view kSaysFix =
    "fix fixed squares kf 2d 3d 3dv 2dv d2 d3 ok valid val validated succeeded success successful "
    "resolved "
    "good true yes gps gnss dgps dgnss sps pps rtk frtk float sbas waas egnos differential "
    "autonomous g\u00fcltig gueltig ja wahr oui vrai si s\u00ed verdadero";
// These words are of no other status.
constexpr std::string_view kOfFixesAlone = "fix fixed nofix unfixed 2d 3d 0d unresolved";

enum class FixSaid : std::uint8_t { kYes, kNot, kUnclear };

FixSaid read_words(const std::vector<std::string>& words) {
  const auto any_is = [&words](std::string_view any_of) {
    return std::any_of(words.begin(), words.end(),
                       [any_of](const std::string& word) { return is_one_of(any_of, word); });
  };
  const bool time_out =
      words.size() >= 2 && words[words.size() - 2] == "time" && words.back() == "out";
  if (any_is(kSaysNone) || time_out) return FixSaid::kNot;
  return words.empty() || any_is(kSaysFix) ? FixSaid::kYes : FixSaid::kUnclear;
}

// "Fix Status", "gps-fix-status", "GPS Fix Attempt".
bool names_fix_status(const std::vector<std::string>& words) {
  const auto any_is = [&words](std::string_view any_of) {
    return std::any_of(words.begin(), words.end(),
                       [any_of](const std::string& word) { return is_one_of(any_of, word); });
  };
  if (any_is("time date rate interval count number duration id")) return false;
  return any_is("fixstatus gpsfixstatus fixattempt fixresult") ||
         (any_is("fix gpsfix") && any_is("status attempt result state success"));
}

// Whether a column that may be of any status says how fixes went.
bool speaks_of_fixes(std::string_view text, const TableLayout& table, std::size_t column) {
  constexpr std::size_t kMostLookedAt = 5000;
  RecordWalk walk(text, table.data_offset, table);
  for (std::size_t i = 0; i < kMostLookedAt && walk.next(); ++i) {
    const Field field = field_at(walk.record(), table.delimiter, column);
    const std::vector<std::string> words = split_words(without_padding(field.text));
    const bool speaks_so = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return is_one_of(kOfFixesAlone, word);
    });
    if (speaks_so) return true;
  }
  return false;
}

}  // namespace

std::optional<FixQuality> find_fix_quality(std::string_view text, const TableLayout& table) {
  std::vector<std::string> names;
  for (const std::string& name : table.names) names.push_back(plain_name(name));
  const auto has = [&names](std::string_view name) {
    return std::any_of(names.begin(), names.end(),
                       [name](const std::string& of) { return ends_as(of, name); });
  };
  const bool ardupilot = has("nsats") && (has("gms") || has("gwk") || has("hdop"));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& name = names[i];
    const auto ends = [&name](std::string_view end) { return ends_as(name, end); };
    if (ends("status_status")) return FixQuality{i, kLeastOfRos};
    if (ardupilot && ends("status")) return FixQuality{i, kLeastType};
    if (ends("gps_lock")) return FixQuality{i, kLeastType};  // of QGroundControl, which has "None"
    if (ends("fix_type") || ends("fixtype")) return FixQuality{i, kLeastType, Unclear::kAsked};
    if (name == "eobs_status") return FixQuality{i, kLeastQuality, Unclear::kAsked, true};
    if (names_fix_status(split_words(table.names[i]))) {
      return FixQuality{i, kLeastQuality, Unclear::kAsked};
    }
    if (name == "fix" || name == "gps_fix" || name == "valid" || name == "validity" ||
        ends("fix_quality")) {
      return FixQuality{i, kLeastQuality};
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_one_of("status gps_status gpsstatus location_status position_status validity",
                   names[i])) {
      continue;
    }
    if (speaks_of_fixes(text, table, i)) return FixQuality{i, kLeastQuality, Unclear::kAsked};
  }
  return std::nullopt;
}

bool says_no_fix(const FixQuality& quality, std::string_view text) {
  const std::string_view stated = without_padding(text);
  double number = 0.0;
  if (parse_number(stated, number) == NumberKind::kNumber) return number < quality.least;
  // Of e-obs: A is within the masks of accuracy, B and C have a time alone, D is invalid.
  if (quality.of_eobs) return stated.size() == 1 && is_one_of("b c d", lower_case(stated));
  return read_words(split_words(stated)) == FixSaid::kNot;
}

bool is_unclear(const FixQuality& quality, std::string_view text) {
  const std::string_view stated = without_padding(text);
  double number = 0.0;
  if (quality.unclear != Unclear::kAsked || is_unknown(stated)) return false;
  if (parse_number(stated, number) == NumberKind::kNumber) return false;
  if (quality.of_eobs) return stated.size() != 1 || !is_one_of("a b c d", lower_case(stated));
  return read_words(split_words(stated)) == FixSaid::kUnclear;
}

}  // namespace beespace::io
