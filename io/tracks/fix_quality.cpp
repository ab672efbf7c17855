#include "io/tracks/fix_quality.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <array>
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

}  // namespace

std::optional<FixQuality> find_fix_quality(const TableLayout& table) {
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
    if (ends("fix_type") || ends("fixtype")) return FixQuality{i, kLeastType};
    if (name == "fix" || name == "gps_fix" || name == "valid" || ends("fix_quality")) {
      return FixQuality{i, kLeastQuality};
    }
  }
  return std::nullopt;
}

bool says_no_fix(const FixQuality& quality, std::string_view text) {
  const std::string_view stated = without_padding(text);
  double number = 0.0;
  if (parse_number(stated, number) == NumberKind::kNumber) return number < quality.least;
  const std::vector<std::string> words = split_words(stated);
  return !words.empty() && is_one_of("no none nofix false invalid", words.front());
}

}  // namespace beespace::io
