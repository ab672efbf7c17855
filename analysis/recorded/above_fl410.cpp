#include "analysis/recorded/above_fl410.hpp"

#include "analysis/recorded/apart.hpp"
#include "io/bytes/number_text.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace beespace::analysis {
namespace {

constexpr double kFl410Feet = 41'000.0;
// Who is no farther from a level counts as on it (Doc 4444, 8.5.5.2.2.1: 200 ft where RVSM is).
constexpr double kOnLevelFeet = 200.0;
constexpr double kMinimumAboveFeet = 2'000.0;
// Who asks for less than this asks for no minimum of air traffic control, but how close a near miss
// is.
constexpr double kLeastMinimumMiles = 2.5;
constexpr double kLeastMinimumFeet = 500.0;

bool is_above(double height_m) {
  return io::from_metric(height_m, io::Unit::kFoot) > kFl410Feet + kOnLevelFeet;
}

bool flies_above(const io::RecordedBee& bee) {
  return std::any_of(bee.fixes.begin(), bee.fixes.end(),
                     [](const Fix& fix) { return is_above(fix.position.z); });
}

// Whether a minimum of air traffic control was asked for that is less than what holds above.
bool asks_too_little(const io::Recording& recording, double threshold_m,
                     const std::optional<io::StatedLength>& vertical) {
  if (!vertical || recording.frame != io::Frame::kWgs84 || recording.flat) return false;
  const double vertical_ft = io::from_metric(vertical->metric, io::Unit::kFoot);
  return vertical_ft < kMinimumAboveFeet && vertical_ft >= kLeastMinimumFeet &&
         io::from_metric(threshold_m, io::Unit::kNauticalMile) >= kLeastMinimumMiles;
}

bool is_above_then(const Track& track, double time_s, double height_unit_m) {
  const auto there = whereabouts_at(track, time_s);
  return there && there->height && is_above(*there->height * height_unit_m);
}

}  // namespace

std::string above_fl410_text(const io::Recording& recording, double threshold_m,
                             const std::optional<io::StatedLength>& vertical) {
  if (!asks_too_little(recording, threshold_m, vertical)) return {};
  const auto above = static_cast<std::uint64_t>(
      std::count_if(recording.bees.begin(), recording.bees.end(), flies_above));
  // Of recordings that are larger than memory the ends of each are known, and how high all are.
  if (above == 0 && !(recording.reach && is_above(recording.reach->greatest.z))) return {};
  const std::string who =
      above == 0 ? "some aircraft fly"
                 : io::counted(above, "aircraft", "aircraft") + (above == 1 ? " flies" : " fly");
  return who + " above FL410, where ICAO Doc 4444 asks for 2000 ft in height: ask --threshold " +
         io::exact(io::from_metric(threshold_m, io::Unit::kNauticalMile)) +
         "NM --vertical 2000ft for these, too";
}

Result<std::vector<Conflict>> closer_above_fl410(const io::Recording& recording,
                                                 const std::vector<Track>& tracks,
                                                 const std::optional<io::StatedLength>& vertical,
                                                 const ConflictOptions& options) {
  std::vector<Conflict> closer;
  if (!options.vertical_m || !asks_too_little(recording, options.threshold_m, vertical) ||
      std::none_of(recording.bees.begin(), recording.bees.end(), flies_above)) {
    return closer;
  }
  ConflictOptions wider = options;
  wider.max_results = ConflictOptions{}.max_results;  // most are none of those that are asked for
  wider.vertical_m =
      *options.vertical_m * kMinimumAboveFeet / io::from_metric(vertical->metric, io::Unit::kFoot);
  const auto found = find_conflicts(tracks, wider);
  if (!found) return found.error();
  std::copy_if(found->conflicts.begin(), found->conflicts.end(), std::back_inserter(closer),
               [&](const Conflict& conflict) {
                 const auto above = [&](PointId bee, double time_s) {
                   return is_above_then(tracks[bee], time_s, options.height_unit_m);
                 };
                 return above(conflict.first, conflict.closest_s) ||
                        above(conflict.second, conflict.closest_s);
               });
  return closer;
}

}  // namespace beespace::analysis
