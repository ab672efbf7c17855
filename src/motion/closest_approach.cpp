#include <beespace/closest_approach.hpp>

#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <utility>

namespace beespace {

Result<Approach> closest_approach(const Mover& first, const Mover& second,
                                  const PredictOptions& options) {
  if (auto error = motion::check_options(options)) return *std::move(error);
  if (auto error = motion::check_mover(first, 0)) return *std::move(error);
  if (auto error = motion::check_mover(second, 1)) return *std::move(error);
  const motion::Separation separation = motion::separation_of(options);
  Approach approach = motion::closest_in(first, second, options.horizon_s);
  if (motion::in_conflict(first, second, separation, options.horizon_s)) {
    approach.conflict =
        motion::report_conflict(first, second, separation, options.horizon_s).span;
  }
  return approach;
}

}  // namespace beespace
