#include "motion/predict/prediction.hpp"

#include "base/pair_order.hpp"
#include "base/resize_for.hpp"
#include "exact/validate.hpp"
#include "motion/predict/prediction_steps.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

namespace beespace::motion {

namespace {

// The steps have checked positions and velocities on their way.
std::optional<Error> check(const MoversView& movers, const PredictionSteps& steps) {
  if (steps.in_domain() && !movers.has_heights()) return std::nullopt;
  return check_movers(movers);
}

// `pairs` is a vector, of whatever memory.
template <class Pairs>
Status find_pairs(const MoversView& movers, const PredictOptions& options,
                  const core::Resources& with, Pairs& pairs, const PredictionTuning& tuning) {
  PredictionSteps steps(movers, options, with, tuning);
  if (auto error = check(movers, steps)) return *std::move(error);
  const auto exactly = [&](PointId a, PointId b) {
    return in_conflict(state_of(movers, a), state_of(movers, b), steps.separation(),
                       options.horizon_s);
  };
  const DecidePass decide = std::cref(exactly);  // a copy would need memory
  core::Vector<core::FoundPairs> found(&with.memory);
  std::size_t found_in = 0;  // so many steps
  const auto settle = [&] {
    core::resize_for(pairs, core::size_of(found), with.crew);
    core::order_pairs(found, core::Direction::kAscending, movers.size(), with, pairs.data());
    if (found_in > 1) pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs.size() <= options.max_results;
  };
  bool fits = true;
  steps.for_each(decide, options.max_results, [&](auto&& step) {
    ++found_in;
    for (core::FoundPairs& part : step) found.push_back(std::move(part));
    // Few are found twice, so this rarely runs and is more rarely true.
    fits = core::size_of(found) <= options.max_results || settle();
    return fits;
  });
  if (!fits || !settle()) return core::too_many_results(options.max_results);
  return std::monostate{};
}

// What there is to report about pairs in conflict.
class Reports {
 public:
  Reports(const MoversView& movers, const PredictOptions& options)
      : movers_(movers),
        separation_(separation_of(options, movers.has_heights())),
        horizon_s_(options.horizon_s) {}

  void prefetch(const Pair& pair) const {
    for (const PointsView* view : {&movers_.positions(), &movers_.velocities()}) {
      const auto* const first = static_cast<const std::byte*>(view->axes()[0]);
      __builtin_prefetch(first +
                         static_cast<std::ptrdiff_t>(pair.second) * view->stride_bytes()[0]);
    }
  }
  [[nodiscard]] Conflict operator()(const Pair& pair) const {
    const ConflictReport report = report_conflict(
        relative_motion(state_of(movers_, pair.first), state_of(movers_, pair.second)), separation_,
        horizon_s_);
    return {pair.first,       pair.second,        report.span.begins_s,
            report.closest_s, report.span.ends_s, report.closest_m};
  }

 private:
  const MoversView& movers_;
  Separation separation_;
  double horizon_s_;
};

}  // namespace

Status predict_pairs(const MoversView& movers, const PredictOptions& options,
                     const core::Resources& with, std::vector<Pair>& pairs,
                     const PredictionTuning& tuning) {
  return find_pairs(movers, options, with, pairs, tuning);
}

Status predict(const MoversView& movers, const PredictOptions& options, const core::Resources& with,
               std::vector<Conflict>& conflicts, const PredictionTuning& tuning) {
  core::Vector<Pair> pairs(&with.memory);
  if (Status found = find_pairs(movers, options, with, pairs, tuning); !found) return found;
  core::resize_for(conflicts, pairs.size(), with.crew);
  const Reports report_of(movers, options);
  with.crew.split(pairs.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    for (std::size_t k = begin; k < end; ++k) {
      // The first of each pair is read in sequence.
      constexpr std::size_t kAhead = 16;
      if (k + kAhead < end) report_of.prefetch(pairs[k + kAhead]);
      conflicts[k] = report_of(pairs[k]);
    }
  });
  return std::monostate{};
}

}  // namespace beespace::motion
