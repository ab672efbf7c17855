#include "analysis/recorded/coarse_places.hpp"

#include "io/bytes/number_text.hpp"
#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

namespace beespace::analysis {
namespace {

// What one unit of the last digit is divided by: from multiples of a thousand on.
constexpr std::array kUnits = {1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
constexpr double kNearlyWhole = 1e-6;  // of a unit: decimals are rounded to doubles
constexpr std::size_t kFewestToTell = 20;
// Of even motion none, but where it turns.
constexpr std::size_t kFewestBends = 4;
constexpr double kLeastBends = 0.02;  // of all steps
constexpr double kCoarseShare = 0.5;  // of the threshold
// Whole metres nearer to zero than that may be cells of a lattice; of a grid of a country they are
// farther away.
constexpr double kOfALattice_m = 10'000.0;
constexpr double kWholeSecond_s = 1.0;
constexpr double kNearlyFastest = 0.9;  // of all steps: a single one may be a jump

// The speed that nine tenths of all steps do not exceed; nothing where times are no whole seconds,
// or too few to tell.
std::optional<double> speed_of_whole_seconds(const io::Recording& recording) {
  std::vector<double> speeds_mps;
  std::size_t most = 0;
  for (const io::RecordedBee& bee : recording.bees) {
    if (bee.path || bee.stands) return std::nullopt;
    most = std::max(most, bee.fixes.size());
    speeds_mps.reserve(speeds_mps.size() + bee.fixes.size());
    for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
      const Fix& fix = bee.fixes[i];
      if (fix.time_s != std::floor(fix.time_s)) return std::nullopt;
      if (i == 0) continue;
      const Fix& before = bee.fixes[i - 1];
      speeds_mps.push_back(io::flat_distance_m(before.position, fix.position, recording.frame) /
                           (fix.time_s - before.time_s));
    }
  }
  if (most < kFewestToTell) return std::nullopt;
  const auto at = speeds_mps.begin() + static_cast<std::ptrdiff_t>(
                                           kNearlyFastest * static_cast<double>(speeds_mps.size()));
  std::nth_element(speeds_mps.begin(), at, speeds_mps.end());
  return *at;
}

bool may_be_closer(const CoarseQuestion& question, double off_m) {
  return !question.conflicts && question.closest_m &&
         *question.closest_m < question.threshold_m + off_m;
}

}  // namespace

bool PlaceSteps::take_axis(Axis& axis, double before, double now, double stretch) {
  while (axis.decimals + 1 < kUnits.size()) {
    const double units = now * kUnits[axis.decimals];
    if (std::abs(units - std::round(units)) <= kNearlyWhole) break;
    ++axis.decimals;
  }
  const double step = now - before;
  const double bend = step - axis.step * stretch;
  axis.step = step;
  return std::abs(bend) * kUnits[axis.decimals] > 0.5;
}

void PlaceSteps::take(const Fix& fix) {
  const double seconds = fix.time_s - last_.time_s;
  const bool even = fixes_ > 1 && seconds <= 2.0 * last_s_ && last_s_ <= 2.0 * seconds;
  const double stretch = even ? seconds / last_s_ : 0.0;
  const bool bends_x = take_axis(axes_[0], last_.position.x, fix.position.x, stretch);
  const bool bends_y = take_axis(axes_[1], last_.position.y, fix.position.y, stretch);
  if (even) {
    ++triples_;
    bends_ += bends_x || bends_y ? 1 : 0;
  }
  // Who only climbs or sinks is where somebody wrote it to be.
  moves_ = moves_ || (fixes_ > 0 && !(fix.position == last_.position));
  reach_ = std::max({reach_, std::abs(fix.position.x), std::abs(fix.position.y)});
  last_ = fix;
  last_s_ = seconds;
  ++fixes_;
}

std::size_t PlaceSteps::decimals() const {
  return std::max(axes_[0].decimals, axes_[1].decimals);
}

double PlaceSteps::coarse_m(io::Frame frame, std::size_t most_decimals) const {
  const bool on_earth = frame == io::Frame::kWgs84;
  const bool bends = bends_ >= kFewestBends &&
                     static_cast<double>(bends_) >= kLeastBends * static_cast<double>(triples_);
  if (fixes_ < kFewestToTell || !(bends || (on_earth && !moves_))) return 0.0;
  const double step = 1.0 / kUnits[moves_ ? decimals() : most_decimals];
  if (!on_earth) return step >= 1.0 && reach_ < kOfALattice_m ? 0.0 : step * std::numbers::sqrt2;
  constexpr double kMetresPerDegree = 111'195.0;
  const double shrinks = std::cos(last_.position.y * std::numbers::pi / 180.0);
  return kMetresPerDegree * step * std::hypot(shrinks, 1.0);
}

CoarseQuestion coarse_question(const ConflictOptions& options,
                               const std::vector<Conflict>& conflicts,
                               const std::optional<Conflict>& closest) {
  std::optional<double> closest_m;
  if (closest) closest_m = options.vertical_m ? options.threshold_m : closest->closest_m;
  return {options.threshold_m, !conflicts.empty(), closest_m};
}

CoarseQuestion coarse_question(const PathVerdict& verdict, const PathQuestion& question) {
  std::optional<double> closest_m;
  if (verdict.closest) {
    closest_m = question.vertical ? question.threshold_m : verdict.closest->closest_m;
  }
  return {question.threshold_m, !verdict.losses.empty(), closest_m};
}

void judge_accuracy(const io::StatedAccuracy& accuracy, const CoarseQuestion& question,
                    Coverage& coverage) {
  double most_m = 0.0;
  double next_m = 0.0;
  std::size_t coarse = 0;
  for (const double each_m : accuracy.medians_m) {
    if (each_m > kCoarseShare * question.threshold_m) ++coarse;
    next_m = std::max(next_m, std::min(most_m, each_m));
    most_m = std::max(most_m, each_m);
  }
  if (coarse == 0 || !may_be_closer(question, most_m + next_m)) return;
  coverage.coarse = coarse;
  coverage.coarse_m = most_m;
  coverage.coarse_by = accuracy.column;
}

void judge_places(const std::vector<PlaceSteps>& steps, io::Frame frame,
                  const CoarseQuestion& question, Coverage& coverage) {
  std::size_t most_decimals = 0;
  for (const PlaceSteps& each : steps) most_decimals = std::max(most_decimals, each.decimals());
  double most_m = 0.0;
  double next_m = 0.0;
  std::size_t coarse = 0;
  for (const PlaceSteps& each : steps) {
    if (!question.unmoved && !each.moves()) continue;
    const double each_m = each.coarse_m(frame, most_decimals);
    if (each_m > kCoarseShare * question.threshold_m) ++coarse;
    next_m = std::max(next_m, std::min(most_m, each_m));
    most_m = std::max(most_m, each_m);
  }
  // Each of the two is off by half of its own step.
  if (coarse == 0 || !may_be_closer(question, (most_m + next_m) / 2.0)) return;
  coverage.coarse = coarse;
  coverage.coarse_m = most_m;
}

void judge_places(const io::Recording& recording, const CoarseQuestion& question,
                  Coverage& coverage) {
  if (recording.show || question.conflicts) return;
  std::vector<PlaceSteps> steps(recording.bees.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const Fix& fix : recording.bees[i].fixes) steps[i].take(fix);
  }
  judge_places(steps, recording.frame, question, coverage);
  if (coverage.coarse == 0) judge_accuracy(recording.accuracy, question, coverage);
  // Pictures of a film are not cut off.
  if (recording.y_is_down) return;
  const auto speed_mps = speed_of_whole_seconds(recording);
  if (!speed_mps) return;
  const double way_m = kWholeSecond_s * *speed_mps;
  if (!(way_m > question.threshold_m) || !may_be_closer(question, way_m)) return;
  coverage.whole_seconds =
      "times are whole seconds, in which bees go up to " + io::length(way_m) +
      ", more than the threshold of " + io::length(question.threshold_m) +
      ": where what wrote them cut fractions off, two may be closer than is said";
}

}  // namespace beespace::analysis
