#include "io/recording/frozen_in_air.hpp"

#include "io/recording/flat_distance.hpp"
#include "io/recording/stays.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kInAir_m = 3.0;
constexpr std::size_t kFewestInAir = 20;
constexpr double kRepeatsSeldom = 0.02;
// Where it hovers.
constexpr double kHoverReach_m = 1.0;
constexpr double kHoverLasts_s = 5.0;
constexpr std::size_t kHoverFixes = 8;
constexpr double kClearStep_m = 0.01;  // more than rounding
// Where its height swings to and fro while it goes level.
constexpr double kLeastSwing_m = 0.03;
constexpr double kMostSwing_m = 0.5;
constexpr double kLevelStep_m = 0.25;
constexpr double kClearClimb_m = 0.015;
// From one place to the next that it stops at once, or jumps.
constexpr std::size_t kStepsBeside = 3;
constexpr double kOfUsualStep = 0.5;
constexpr double kCame_mps = 0.3;
constexpr double kJump_m = 1.0;
constexpr double kTimesAsFast = 2.0;

// Fixes at one place, one after the other.
struct PlaceRun {
  std::size_t begin;
  std::size_t end;
  bool is_long;
};

class DroneInAir {
 public:
  DroneInAir(const std::vector<Fix>& fixes, Frame frame) : fixes_(fixes), frame_(frame) {
    ground_m_ = std::numeric_limits<double>::infinity();
    for (const Fix& fix : fixes) ground_m_ = std::min(ground_m_, fix.position.z);
    for (std::size_t i = 0; i < fixes.size();) {
      std::size_t end = i + 1;
      while (end < fixes.size() && fixes[end].position == fixes[i].position) ++end;
      const Stay stay{fixes[i], fixes[end - 1].time_s, end - i};
      runs_.push_back({i, end, stay.is_long()});
      i = end;
    }
  }

  [[nodiscard]] std::vector<bool> frozen() const {
    std::vector<bool> frozen;
    const bool any = std::any_of(runs_.begin(), runs_.end(), [this](const PlaceRun& run) {
      return run.is_long && flies(run.begin);
    });
    if (!any || !repeats_seldom()) return frozen;
    const std::optional<double> usual_m = hovering_step_m();
    const std::optional<double> swinging_m =
        frame_ == Frame::kWgs84 ? swinging_step_m() : std::nullopt;
    for (std::size_t i = 1; i < runs_.size(); ++i) {
      const PlaceRun& run = runs_[i];
      if (!run.is_long || !flies(run.begin)) continue;
      const bool stops_at_once = (usual_m && stops_from_hovering(i, *usual_m)) ||
                                 (swinging_m && stops_in_a_swing(i, *swinging_m));
      if (!stops_at_once && !jumps_from(i)) continue;
      frozen.resize(fixes_.size());
      std::fill(frozen.begin() + static_cast<std::ptrdiff_t>(run.begin + 1),
                frozen.begin() + static_cast<std::ptrdiff_t>(run.end), true);
    }
    return frozen;
  }

 private:
  [[nodiscard]] bool flies(std::size_t fix) const {
    return fixes_[fix].position.z - ground_m_ > kInAir_m;
  }

  // From a run to the next one.
  [[nodiscard]] double step_m(std::size_t run) const {
    return flat_distance_m(fixes_[runs_[run].begin].position, fixes_[runs_[run + 1].begin].position,
                           frame_);
  }
  [[nodiscard]] double step_mps(std::size_t run) const {
    return step_m(run) / (fixes_[runs_[run + 1].begin].time_s - fixes_[runs_[run].end - 1].time_s);
  }

  // Whether in the air places change from fix to fix but for long stays.
  [[nodiscard]] bool repeats_seldom() const {
    std::size_t steps = 0;
    std::size_t repeats = 0;
    for (const PlaceRun& run : runs_) {
      if (!flies(run.begin)) continue;
      ++steps;
      if (!run.is_long) repeats += run.end - run.begin - 1;
    }
    return steps >= kFewestInAir &&
           static_cast<double>(repeats) <= kRepeatsSeldom * static_cast<double>(steps);
  }

  // The usual step from fix to fix where it hovers and its places waver: for a while it stays
  // where it is, goes to and fro, also in height, and never repeats a place.
  [[nodiscard]] std::optional<double> hovering_step_m() const {
    for (std::size_t first = 0; first < runs_.size();) {
      std::vector<double> steps_m;
      double way_m = 0.0;
      double low_m = fixes_[runs_[first].begin].position.z;
      double high_m = low_m;
      const Fix& from = fixes_[runs_[first].begin];
      std::size_t last = first;
      for (; last < runs_.size() && is_single(last) && flies(runs_[last].begin); ++last) {
        const Fix& fix = fixes_[runs_[last].begin];
        const double away_m = flat_distance_m(from.position, fix.position, frame_);
        if (away_m > kHoverReach_m) break;
        low_m = std::min(low_m, fix.position.z);
        high_m = std::max(high_m, fix.position.z);
        if (last == first) continue;
        steps_m.push_back(step_m(last - 1));
        way_m += steps_m.back();
        if (steps_m.size() >= kHoverFixes && fix.time_s - from.time_s >= kHoverLasts_s &&
            away_m <= way_m / 2.0 && high_m > low_m) {
          const auto middle = steps_m.begin() + static_cast<std::ptrdiff_t>(steps_m.size() / 2);
          std::nth_element(steps_m.begin(), middle, steps_m.end());
          if (*middle >= kClearStep_m) return *middle;
          break;
        }
      }
      first += std::max<std::size_t>((last - first) / 2, 1);
    }
    return std::nullopt;
  }

  [[nodiscard]] double climb_m(std::size_t run) const {
    return fixes_[runs_[run + 1].begin].position.z - fixes_[runs_[run].begin].position.z;
  }

  // The usual step in height from fix to fix where it goes level and its height swings to and fro
  // nevertheless, by less than is flown on purpose: as on the Earth wind and barometer have it.
  [[nodiscard]] std::optional<double> swinging_step_m() const {
    std::vector<double> steps_m;
    std::size_t swings = 0;
    std::optional<double> from_m;  // the last turn
    double farthest_m = 0.0;       // since then
    for (std::size_t i = 0; i + 1 < runs_.size(); ++i) {
      if (!is_single(i) || !flies(runs_[i].begin)) {
        from_m.reset();
        continue;
      }
      const double height_m = fixes_[runs_[i].begin].position.z;
      if (std::abs(climb_m(i)) <= kLevelStep_m) steps_m.push_back(std::abs(climb_m(i)));
      if (!from_m) {
        from_m = height_m;
        farthest_m = height_m;
        continue;
      }
      const bool is_farther = (farthest_m >= *from_m) == (height_m >= farthest_m);
      if (is_farther) {
        farthest_m = height_m;
      } else if (std::abs(height_m - farthest_m) >= kLeastSwing_m) {
        const double swing_m = std::abs(farthest_m - *from_m);
        if (swing_m >= kLeastSwing_m && swing_m <= kMostSwing_m) ++swings;
        from_m = farthest_m;
        farthest_m = height_m;
      }
    }
    if (swings == 0 || steps_m.empty()) return std::nullopt;
    const auto middle = steps_m.begin() + static_cast<std::ptrdiff_t>(steps_m.size() / 2);
    std::nth_element(steps_m.begin(), middle, steps_m.end());
    return *middle;
  }

  // What comes to rest is not still in height from one fix to the next.
  [[nodiscard]] bool stops_in_a_swing(std::size_t run, double usual_m) const {
    const double last_m = std::abs(climb_m(run - 1));
    return is_single(run - 1) && last_m >= std::max(kClearClimb_m, kOfUsualStep * usual_m) &&
           last_m <= kLevelStep_m;
  }

  [[nodiscard]] bool is_single(std::size_t run) const {
    return runs_[run].end - runs_[run].begin == 1;
  }

  // What comes to rest, as a controller brings it, goes by ever smaller steps.
  [[nodiscard]] bool stops_from_hovering(std::size_t run, double usual_m) const {
    double most_m = 0.0;
    for (std::size_t i = run - std::min(run, kStepsBeside); i < run; ++i) {
      if (is_single(i)) most_m = std::max(most_m, step_m(i));
    }
    return most_m >= kOfUsualStep * usual_m;
  }

  [[nodiscard]] bool jumps_from(std::size_t run) const {
    if (run + 2 >= runs_.size() || !(step_m(run) > kJump_m)) return false;
    double before_mps = 0.0;
    for (std::size_t i = run - std::min(run, kStepsBeside); i < run; ++i) {
      before_mps = std::max(before_mps, step_mps(i));
    }
    double behind_mps = 0.0;
    for (std::size_t i = run + 1; i < std::min(run + 1 + kStepsBeside, runs_.size() - 1); ++i) {
      behind_mps = std::max(behind_mps, step_mps(i));
    }
    return before_mps >= kCame_mps &&
           step_mps(run) > kTimesAsFast * std::max(before_mps, behind_mps);
  }

  const std::vector<Fix>& fixes_;
  Frame frame_;
  double ground_m_ = 0.0;
  std::vector<PlaceRun> runs_ = {};
};

}  // namespace

std::vector<bool> frozen_in_air(const std::vector<Fix>& fixes, Frame frame) {
  return DroneInAir(fixes, frame).frozen();
}

}  // namespace beespace::io
