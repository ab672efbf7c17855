#include "io/table/header_words.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>
#include <cstddef>

namespace beespace::io {
namespace {

// One word of a name is enough. Beside English these are French, German, Italian, Portuguese and
// Spanish. A table of drones or birds may have one of them too: then it says its units.
constexpr std::string_view kAviationWords =
    "icao icao24 callsign squawk groundspeed gs hex vertrate verticalrate baroaltitude geoaltitude "
    "onground adsb tas ias cas roc rocd flightlevel fl kt kts knots fpm aircraft mach flight "
    "flightid flightnumber flightno flt registration tailnumber tailnum nnumber ident plane "
    "airplane aeroplane airline modes transponder "
    "vuelo aeronave avion avi\u00f3n indicativo matricula matr\u00edcula voo aviao avi\u00e3o "
    "immatriculation indicatif vol aeronef a\u00e9ronef "
    "kennzeichen rufzeichen flug flugnummer flugzeug luftfahrzeug "
    "volo aeromobile velivolo nominativo immatricolazione";

// Words of tags, collars and videos of animals.
constexpr std::string_view kOfTags =
    "tagid tag collar collarid animal animalid individual bird birdid fish species activity nose "
    "thorax abdomen snout paw";

// Two, one behind the other.
constexpr std::string_view kAviationPairs =
    "ground-speed vertical-rate vert-rate vertical-speed baro-rate geom-rate climb-rate "
    "baro-altitude baro-alt alt-baro alt-geom geo-altitude geom-altitude pressure-altitude "
    "on-ground flight-level call-sign mode-s n-number tail-number tail-num tail-no";

// What trackers and tags measure beside places.
constexpr std::string_view kOtherQuantities =
    "speed velocity acceleration heading angle theta orientation direction likelihood confidence "
    "score prob probability temperature temp humidity battery voltage satellites sats hdop vdop "
    "pdop dop accuracy area size width length count missing error mass ecc eccentricity signal ep "
    "intensity brightness year month julianday hour minute fixtime activity numsats 2d roll pitch "
    "yaw conf rollrate pitchrate yawrate climbrate groundspeed airspeed vx vy vz varx vary "
    "varxy covxy "
    "nbs "
    "ptt step dx dy dz dt dist r2n burst pkey satcount red green blue rx ry rz rotation quat "
    "quaternion qx qy qz qw";

// What ids are unique within: whole names. Movebank's individuals and tags are so within a study.
constexpr std::string_view kSets =
    "study study_name study_id experiment experiment_name experiment_id trial trial_name trial_id "
    "trial_number trial_no replicate arena arena_id video video_name video_id video_file";

// Where times are no dates, they begin again with each of these, too.
constexpr std::string_view kSessions =
    "session session_name session_id session_number session_no run run_name run_id run_number "
    "run_no rep rep_id rep_no replicate_id replicate_no replication repetition recording "
    "recording_id episode episode_id rollout seed";

constexpr std::string_view kScenes =
    "arena arena_id camera camera_id camera_no camera_number cam cam_id cam_no side side_id "
    "comb_side hive_side side_of_comb";

}  // namespace

bool names_set(std::string_view column) {
  return is_one_of(kSets, plain_name(column));
}

bool names_session(std::string_view column) {
  return is_one_of(kSessions, plain_name(column));
}

bool names_zone(std::string_view column) {
  const std::vector<std::string> words = split_words(column);
  const auto any_is = [&words](std::string_view any_of) {
    return std::any_of(words.begin(), words.end(),
                       [&](const std::string& word) { return is_one_of(any_of, word); });
  };
  return any_is("zone utmzone") && std::all_of(words.begin(), words.end(), [](const auto& word) {
           return is_one_of("zone utmzone utm grid number no nr letter band id", word);
         });
}

bool names_arena(std::string_view column) {
  return is_one_of("arena arena_id", plain_name(column));
}

bool names_scene(std::string_view column) {
  return is_one_of(kScenes, plain_name(column));
}

bool names_other_quantity(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string& word) { return is_one_of(kOtherQuantities, word); });
}

bool speaks_of_aviation(std::string_view name) {
  const std::vector<std::string> words = split_words(name);
  // A column of its own; "tail_x" is of an animal.
  if (words == std::vector<std::string>{"tail"}) return true;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (is_one_of(kAviationWords, words[i])) return true;
    if (i > 0 && is_one_of(kAviationPairs, words[i - 1] + "-" + words[i])) return true;
  }
  return false;
}

std::string words_of_aviation(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 3;
  const TableSource* const source = source_of(names);
  if (source != nullptr && source->of_animals) return {};
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (found.size() < kMost && speaks_of_aviation(name)) found.push_back(excerpt(name));
  }
  // Tags of animals have a speed over ground, too, and their own words beside it.
  const auto is_said_by_tags = [](const std::string& name) {
    return is_one_of("ground_speed groundspeed tail", plain_name(name));
  };
  const auto speaks = [&](const std::string& name) {
    return speaks_of_aviation(name) && !is_said_by_tags(name);
  };
  const bool of_tags = std::any_of(names.begin(), names.end(), [](const std::string& name) {
    const std::vector<std::string> words = split_words(name);
    return std::any_of(words.begin(), words.end(),
                       [](const std::string& word) { return is_one_of(kOfTags, word); });
  });
  if (of_tags && std::none_of(names.begin(), names.end(), speaks)) return {};
  std::string text;
  for (std::size_t i = 0; i < found.size(); ++i) {
    text += i == 0 ? "" : i + 1 == found.size() ? " and " : ", ";
    text += found[i];
  }
  return text;
}

}  // namespace beespace::io
