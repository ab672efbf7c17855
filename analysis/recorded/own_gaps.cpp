#include "analysis/recorded/own_gaps.hpp"

#include <beespace/track.hpp>

#include <cstddef>

namespace beespace::analysis {
namespace {

constexpr double kLeastScheduled_s = 60.0;
constexpr double kFarMoreOften = 0.5;  // of the max gap of all

}  // namespace

std::optional<double> own_max_gap_s(const io::Recording& recording, PointId bee,
                                    const MaxGap& max_gap) {
  if (max_gap.asked || recording.of_aircraft || recording.show) return std::nullopt;
  const io::RecordedBee& of = recording.bees[bee];
  if (max_gap.seconds < kLeastScheduled_s || of.fixes.size() < kFixesToTell) return std::nullopt;
  const double interval_s = interval_of(of).median_s;
  const double own_s = max_gap_for(interval_s);
  const bool counts = interval_s >= kLeastScheduled_s && own_s < kFarMoreOften * max_gap.seconds;
  return counts ? std::optional(own_s) : std::nullopt;
}

std::vector<Gap> own_gaps(const io::Recording& recording, const MaxGap& max_gap) {
  std::vector<Gap> gaps;
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    const auto own_s = own_max_gap_s(recording, bee, max_gap);
    if (!own_s) continue;
    const std::vector<Fix>& fixes = recording.bees[bee].fixes;
    for (std::size_t i = 1; i < fixes.size(); ++i) {
      const double begins_s = fixes[i - 1].time_s;
      const double ends_s = fixes[i].time_s;
      const double lasts_s = ends_s - begins_s;
      // Longer ones are gaps of all.
      if (lasts_s > *own_s && lasts_s <= max_gap.seconds) {
        gaps.push_back({bee, begins_s, ends_s});
      }
    }
  }
  return gaps;
}

}  // namespace beespace::analysis
