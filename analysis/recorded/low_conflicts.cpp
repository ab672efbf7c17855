#include "analysis/recorded/low_conflicts.hpp"

#include "analysis/recorded/ends.hpp"
#include "analysis/recorded/landed_times.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace beespace::analysis {
namespace {

// Curves are followed so closely.
constexpr double kHeightTolerance_m = 0.001;

// Where a bee is how high above its take-off.
class Heights {
 public:
  Heights(const io::Recording& recording, PointId bee, double ground_m) {
    const io::RecordedBee& of = recording.bees[bee];
    if (of.stands) {
      from_m_ = of.stands->z;
      fixes_ = {{0.0, *of.stands}};
      return;
    }
    if (of.path) {
      auto track = to_track(*of.path, kHeightTolerance_m);
      if (track) {
        tolerance_m_ = track->tolerance_m;
        fixes_ = std::move(track->fixes);
      }
    } else {
      fixes_ = of.fixes;
    }
    if (fixes_.empty()) return;
    if (of.took_off_at_m) {
      from_m_ = of.took_off_at_m;
      return;
    }
    const Fix& first = fixes_.front();
    const bool on_ground = recording.show ? first.position.z - ground_m <= kStandsWithin_m
                                          : has_landed(recording, bee, first.time_s);
    if (on_ground) from_m_ = first.position.z;
  }

  [[nodiscard]] bool is_known() const { return from_m_.has_value(); }

  // All the time from then to then; before its first fix and after its last one it is there.
  [[nodiscard]] bool stays_below(double begins_s, double ends_s, double below_m) const {
    if (!from_m_) return false;
    const auto is_low = [&](double height_m) {
      return std::abs(height_m - *from_m_) + tolerance_m_ < below_m;
    };
    if (!is_low(height_at(begins_s)) || !is_low(height_at(ends_s))) return false;
    auto fix = std::lower_bound(fixes_.begin(), fixes_.end(), begins_s,
                                [](const Fix& of, double time_s) { return of.time_s < time_s; });
    for (; fix != fixes_.end() && fix->time_s <= ends_s; ++fix) {
      if (!is_low(fix->position.z)) return false;
    }
    return true;
  }

 private:
  [[nodiscard]] double height_at(double time_s) const {
    if (time_s <= fixes_.front().time_s) return fixes_.front().position.z;
    if (time_s >= fixes_.back().time_s) return fixes_.back().position.z;
    const auto to = std::upper_bound(fixes_.begin(), fixes_.end(), time_s,
                                     [](double time, const Fix& of) { return time < of.time_s; });
    const Fix& from = *(to - 1);
    const double share = (time_s - from.time_s) / (to->time_s - from.time_s);
    return from.position.z + share * (to->position.z - from.position.z);
  }

  std::optional<double> from_m_;
  std::vector<Fix> fixes_;
  double tolerance_m_ = 0.0;
};

}  // namespace

std::optional<Conflict> LowConflicts::closest() const {
  const auto least = std::min_element(
      left_out.begin(), left_out.end(),
      [](const Conflict& a, const Conflict& b) { return a.closest_m < b.closest_m; });
  return least == left_out.end() ? std::nullopt : std::optional<Conflict>(*least);
}

std::optional<double> took_off_at_m(const io::Recording& recording, PointId bee) {
  const io::RecordedBee& of = recording.bees[bee];
  if (of.took_off_at_m || of.fixes.empty() || recording.show) return of.took_off_at_m;
  if (!has_landed(recording, bee, of.fixes.front().time_s)) return std::nullopt;
  return of.fixes.front().position.z;
}

LowConflicts leave_out_low(const io::Recording& recording, double below_m,
                           std::vector<Conflict>& conflicts) {
  LowConflicts low{below_m};
  low.of_table = !recording.show && !recording.of_drones;
  const double ground_m = ground_of(recording);
  std::vector<Heights> heights;
  heights.reserve(recording.bees.size());
  for (PointId bee = 0; bee < recording.bees.size(); ++bee) {
    heights.emplace_back(recording, bee, ground_m);
    if (!heights.back().is_known()) ++low.bees_not_known;
  }
  std::vector<Conflict> kept;
  for (const Conflict& conflict : conflicts) {
    const auto is_low = [&](PointId bee) {
      return heights[bee].stays_below(conflict.begins_s, conflict.ends_s, below_m);
    };
    const bool curved = !recording.show && !conflict.certain;
    const bool both = !curved && is_low(conflict.first) && is_low(conflict.second);
    (both ? low.left_out : kept).push_back(conflict);
  }
  conflicts = std::move(kept);
  return low;
}

bool may_be_of_grid(double closest_m, double threshold_m) {
  // Closer than this the places of a grid are not.
  constexpr double kOfThreshold = 0.25;
  constexpr double kOfDrones_m = 0.8;
  return closest_m >= std::min(kOfThreshold * threshold_m, kOfDrones_m);
}

std::size_t would_leave_out_low(const io::Recording& recording, double threshold_m,
                                const std::vector<Conflict>& conflicts) {
  if (conflicts.empty() || recording.of_aircraft || recording.of_animals || recording.flat)
    return 0;
  std::vector<Conflict> left = conflicts;
  const LowConflicts low = leave_out_low(recording, threshold_m, left);
  const auto closest = low.closest();
  return closest && may_be_of_grid(closest->closest_m, threshold_m) ? low.left_out.size() : 0;
}

std::string low_text(const LowConflicts& low) {
  return io::counted(low.left_out.size(), "conflict", "conflicts") + " of two lower than " +
         io::exact(low.below_m) + " m above where they took off";
}

std::string takeoff_unknown_text(const LowConflicts& low, const io::RecordedNoun& noun) {
  if (low.bees_not_known == 0) return {};
  return "of " + noun.counted(low.bees_not_known) +
         " it is not known where they took off: none of theirs is left out" +
         (low.of_table
              ? "; a table tells it in a column of heights above the place of take-off, as "
                "'alt_rel', or of whether each is 'armed', or of 'landed_state'"
              : "");
}

void leave_out_too(const LowConflicts& low, std::vector<Conflict>& some) {
  const auto key_of = [](const Conflict& conflict) {
    return std::tuple(conflict.first, conflict.second, conflict.begins_s);
  };
  std::vector<std::tuple<PointId, PointId, double>> keys(low.left_out.size());
  std::transform(low.left_out.begin(), low.left_out.end(), keys.begin(), key_of);
  std::sort(keys.begin(), keys.end());
  std::erase_if(some, [&](const Conflict& conflict) {
    return std::binary_search(keys.begin(), keys.end(), key_of(conflict));
  });
}

}  // namespace beespace::analysis
