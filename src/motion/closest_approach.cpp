#include <beespace/closest_approach.hpp>

#include "motion/flush.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <utility>

namespace beespace {

Result<Approach> closest_approach(const Mover& first, const Mover& second,
                                  const ApproachOptions& options) {
  const PredictOptions checked{.threshold_m = options.threshold_m,
                               .vertical_m = options.vertical_m,
                               .horizon_s = options.horizon_s,
                               .inclusive = options.inclusive};
  if (auto error = motion::check_options(checked)) return *std::move(error);
  const Mover one = motion::flushed(first);
  const Mover other = motion::flushed(second);
  if (auto error = motion::check_mover(one, 0)) return *std::move(error);
  if (auto error = motion::check_mover(other, 1)) return *std::move(error);
  const motion::Separation separation = motion::separation_of(checked);
  const motion::State a = motion::state_of(one);
  const motion::State b = motion::state_of(other);
  const auto relative = motion::relative_motion(a, b);
  const motion::Nearness nearest = motion::closest_within(relative, {0.0, options.horizon_s});
  Approach approach{nearest.time_s, nearest.distance_m, {}};
  if (motion::in_conflict(a, b, separation, options.horizon_s)) {
    approach.conflict = motion::report_conflict(relative, separation, options.horizon_s).span;
  }
  return approach;
}

}  // namespace beespace
