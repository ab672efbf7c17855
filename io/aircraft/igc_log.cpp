#include "io/aircraft/igc_log.hpp"

#include "io/aircraft/aircraft_gathering.hpp"
#include "io/aircraft/aircraft_report.hpp"
#include "io/bytes/characters.hpp"
#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/recording/flat_distance.hpp"
#include "io/table/table_layout.hpp"
#include "io/units/iso_time.hpp"

#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kDay_s = 86'400.0;
constexpr LeftOutReason kNoFixInSpace = {"without a fix in three dimensions (V)",
                                         "where the glider was then is not known"};

// "B", hhmmss, DDMMmmmN, DDDMMmmmE, A or V, and two heights of five characters.
constexpr std::size_t kShortestFix = 35;

std::optional<double> digits(std::string_view line, std::size_t at, std::size_t count) {
  const auto whole = parse_whole(line.substr(at, count));
  if (!whole) return std::nullopt;
  return static_cast<double>(*whole);
}

// Below 0 it is "-0012".
std::optional<double> height_in(std::string_view field) {
  const bool below = field.starts_with('-');
  const auto whole = parse_whole(field.substr(below ? 1 : 0));
  if (!whole) return std::nullopt;
  return (below ? -1.0 : 1.0) * static_cast<double>(*whole);
}

// Degrees, minutes and thousandths of a minute.
std::optional<double> degrees_in(std::string_view line, std::size_t at, std::size_t degree_digits,
                                 char positive, char negative) {
  constexpr double kThousandthsPerDegree = 60'000.0;
  const auto degrees = digits(line, at, degree_digits);
  const auto minutes = digits(line, at + degree_digits, 2);
  const auto thousandths = digits(line, at + degree_digits + 2, 3);
  const char side = line[at + degree_digits + 5];
  if (!degrees || !minutes || *minutes >= 60.0 || !thousandths) return std::nullopt;
  if (side != positive && side != negative) return std::nullopt;
  const double value =
      (*degrees * kThousandthsPerDegree + *minutes * 1000.0 + *thousandths) / kThousandthsPerDegree;
  return side == positive ? value : -value;
}

struct Fixed {
  double clock_s;  // since midnight
  bool in_space;
  AircraftReport report;
};

std::optional<Fixed> fix_in(std::string_view line) {
  if (line.size() < kShortestFix) return std::nullopt;
  const auto hours = digits(line, 1, 2);
  const auto minutes = digits(line, 3, 2);
  const auto seconds = digits(line, 5, 2);
  const auto latitude = degrees_in(line, 7, 2, 'N', 'S');
  const auto longitude = degrees_in(line, 15, 3, 'E', 'W');
  const auto pressure = height_in(line.substr(25, 5));
  const auto ellipsoid = height_in(line.substr(30, 5));
  const char validity = line[24];
  if (!hours || *hours > 23.0 || !minutes || *minutes > 59.0 || !seconds || *seconds > 60.0 ||
      !latitude || !longitude || !pressure || !ellipsoid || (validity != 'A' && validity != 'V')) {
    return std::nullopt;
  }
  Fixed fixed{*hours * 3600.0 + *minutes * 60.0 + *seconds, validity == 'A', {}};
  fixed.report.longitude_deg = *longitude;
  fixed.report.latitude_deg = *latitude;
  fixed.report.pressure_height = *pressure;
  fixed.report.ellipsoid_height = *ellipsoid;
  return fixed;
}

// "HFDTE010724", "HFDTEDATE:010724,01": day, month, year.
std::optional<std::string_view> day_of(std::string_view line) {
  std::string_view rest = line.substr(5);
  if (rest.starts_with("DATE")) rest.remove_prefix(4);
  if (rest.starts_with(':')) rest.remove_prefix(1);
  rest = without_padding(rest).substr(0, 6);
  if (rest.size() < 6 || !parse_whole(rest)) return std::nullopt;
  return rest;
}

std::optional<double> midnight_s(std::string_view day) {
  const std::string date = "20" + std::string(day.substr(4, 2)) + "-" +
                           std::string(day.substr(2, 2)) + "-" + std::string(day.substr(0, 2));
  std::int64_t seconds = 0;
  if (!parse_day(date, seconds).empty()) return std::nullopt;
  return static_cast<double>(seconds);
}

class IgcLog {
 public:
  IgcLog(const std::string& stem, RecordingAssembly& assembly) : stem_(stem), assembly_(assembly) {}

  std::optional<Error> read(std::string_view text) {
    look_through(text);
    AircraftGathering gathering({assembly_.options().heights, assembly_.options().grounded},
                                assembly_);
    if (auto error = gathering.begin(std::string(kIgcLog), Unit::kMetre, 0.0, false)) return error;
    std::uint64_t number = 0;
    for (std::size_t offset = 0; offset < text.size();) {
      const Line line = line_at(text, offset, '\n');
      offset = line.next;
      ++number;
      if (auto error = take(without_padding(line.text), number, gathering)) {
        error->location.line = number;
        if (auto fatal = assembly_.bad(*std::move(error), stem_)) return fatal;
      }
    }
    return std::nullopt;
  }

 private:
  // A recorder without one of the two heights writes 0 throughout. And nothing says that a glider
  // stands on the ground but that its log begins, or ends, with it at one place for minutes.
  void look_through(std::string_view text) {
    std::vector<Fix> fixes;
    for (std::size_t offset = 0; offset < text.size();) {
      const Line line = line_at(text, offset, '\n');
      offset = line.next;
      if (!line.text.starts_with('B')) continue;
      const auto fixed = fix_in(without_padding(line.text));
      if (!fixed) continue;
      any_pressure_ = any_pressure_ || fixed->report.pressure_height != 0.0;
      any_ellipsoid_ = any_ellipsoid_ || fixed->report.ellipsoid_height != 0.0;
      const AircraftReport& at = fixed->report;
      const double height_m = at.ellipsoid_height != 0.0 ? at.ellipsoid_height : at.pressure_height;
      fixes.push_back({fixed->clock_s, {at.longitude_deg, at.latitude_deg, height_m}});
    }
    stands_until_ = standing(fixes.begin(), fixes.end());
    stands_from_ = fixes.size() - standing(fixes.rbegin(), fixes.rend());
  }

  // How many of the fixes that come first are at one place, for minutes: what hovers in the wind
  // does so for less, or not so exactly.
  template <typename Fixes>
  static std::size_t standing(Fixes first, Fixes end) {
    constexpr double kWithin_m = 15.0;
    constexpr double kWithinHeight_m = 10.0;
    constexpr double kStands_s = 120.0;
    auto last = first;
    while (last != end &&
           flat_distance_m({first->position.x, first->position.y, 0.0},
                           {last->position.x, last->position.y, 0.0}, Frame::kWgs84) <= kWithin_m &&
           std::abs(last->position.z - first->position.z) <= kWithinHeight_m) {
      ++last;
    }
    if (last == first) return 0;
    const double lasts_s = std::abs(std::prev(last)->time_s - first->time_s);
    const bool stands = std::min(lasts_s, kDay_s - lasts_s) >= kStands_s;
    return stands ? static_cast<std::size_t>(last - first) : 0;
  }

  std::optional<Error> take(std::string_view line, std::uint64_t number,
                            AircraftGathering& gathering) {
    if (line.starts_with("HFDTE")) return take_day(line);
    if (line.starts_with("HFALG") && line.find("GEO") != std::string_view::npos) {
      assembly_.note(
          "heights by satellites of a log that says so (HFALG) are above the geoid, but "
          "taken as above the ellipsoid: beside those of other recorders they are tens "
          "of metres off; --heights pressure is the same for all");
    }
    if (line.starts_with("HFGID") || line.starts_with("HFCID")) take_name(line);
    if (!line.starts_with('B')) return std::nullopt;
    auto fixed = fix_in(line);
    if (!fixed) {
      return Error{ErrorCode::kMalformedRecord,
                   excerpt(line) +
                       " is no fix of a log of the IGC (B, hhmmss, DDMMmmmN, DDDMMmmmE, "
                       "A or V, two heights); correct it" +
                       std::string(kOrLeaveOut),
                   {}};
    }
    if (!midnight_s_) {
      return Error{ErrorCode::kMissingColumn,
                   "no line HFDTE before this fix tells the day; add one, as HFDTE010724",
                   {}};
    }
    // The day of UTC may end while one flies; a clock that goes back a little does not.
    if (last_s_ && fixed->clock_s + kDay_s / 2.0 < *last_s_) *midnight_s_ += kDay_s;
    last_s_ = fixed->clock_s;
    AircraftReport& report = fixed->report;
    report.id = stem_;
    report.label = label_;
    report.time_s = *midnight_s_ + fixed->clock_s;
    const std::size_t number_of_fix = fixes_++;
    report.on_ground = number_of_fix < stands_until_ || number_of_fix >= stands_from_;
    report.may_hover = true;  // paragliders and balloons; and no speed is told
    if (!any_pressure_) report.pressure_height = AircraftReport::kUnknown;
    if (!any_ellipsoid_) report.ellipsoid_height = AircraftReport::kUnknown;
    if (!fixed->in_space) {
      assembly_.leave_out(kNoFixInSpace, stem_);
      assembly_.unplaced(stem_, report.time_s);
      return std::nullopt;
    }
    return gathering.add(report, number);
  }

  std::optional<Error> take_day(std::string_view line) {
    const auto day = day_of(line);
    const auto midnight = day ? midnight_s(*day) : std::nullopt;
    if (!midnight) {
      return Error{ErrorCode::kMalformedRecord,
                   excerpt(line) + " tells no day; correct it, as HFDTE010724",
                   {}};
    }
    midnight_s_ = *midnight;
    last_s_.reset();
    return std::nullopt;
  }

  // Registration and competition number, behind a colon.
  void take_name(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) return;
    const std::string_view name = without_padding(line.substr(colon + 1));
    if (label_.empty()) label_ = name;
  }

  std::string stem_;
  RecordingAssembly& assembly_;
  std::string label_;
  std::optional<double> midnight_s_;
  std::optional<double> last_s_;
  bool any_pressure_ = false;
  bool any_ellipsoid_ = false;
  std::size_t fixes_ = 0;         // so far
  std::size_t stands_until_ = 0;  // of the fixes, by number
  std::size_t stands_from_ = 0;
};

}  // namespace

bool is_igc_log(std::string_view text) {
  constexpr std::size_t kLookedAt = 64'000;
  // First the recorder, then the day; and a fix.
  if (text.empty() || text.front() != 'A') return false;
  const std::string_view head = text.substr(0, kLookedAt);
  return head.find("\nHFDTE") != std::string_view::npos;
}

std::optional<Error> read_igc_log(std::string_view text, const std::string& stem,
                                  RecordingAssembly& assembly) {
  return IgcLog(assembly.name_of_source(stem), assembly).read(text);
}

}  // namespace beespace::io
