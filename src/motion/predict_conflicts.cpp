#include <beespace/brute_force.hpp>
#include <beespace/predict_conflicts.hpp>

#include "core/validate.hpp"
#include "cpu/crew_size.hpp"
#include "motion/prediction.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <string>
#include <utility>

namespace beespace {

namespace {

std::optional<Error> check(const MoversView& movers, const PredictOptions& options) {
  if (auto error = motion::check_options(options)) return error;
  if (auto error = motion::check_heights(movers.has_heights(), options.vertical_m)) return error;
  const bool all_have_heights =
      movers.heights_m().size() == movers.size() && movers.climbs_mps().size() == movers.size();
  const bool any = movers.has_heights() || !movers.climbs_mps().empty();
  if (any && !all_have_heights) {
    return Error{ErrorCode::kInvalidArgument,
                 std::to_string(movers.heights_m().size()) + " heights and " +
                     std::to_string(movers.climbs_mps().size()) + " climb rates for " +
                     std::to_string(movers.size()) + " movers; give one of each for everybody",
                 {}};
  }
  if (auto error = core::check_size(movers.size())) return error;
  return motion::check_movers(movers, 0, movers.size());
}

}  // namespace

Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                const PredictOptions& options) {
  if (auto error = check(movers, options)) return *std::move(error);
  ThreadCrew crew(cpu::crew_size(options.threads, movers.size()));
  core::Memory memory;
  memory.start_call();
  return motion::predict(movers, options, {crew, memory});
}

namespace brute_force {

Result<std::vector<Conflict>> predict_conflicts(const MoversView& movers,
                                                const PredictOptions& options) {
  if (auto error = check(movers, options)) return *std::move(error);
  const motion::Separation separation = motion::separation_of(options, movers.has_heights());
  std::vector<Conflict> conflicts;
  for (PointId i = 0; i < movers.size(); ++i) {
    for (PointId j = i + 1; j < movers.size(); ++j) {
      const motion::State a = motion::state_of(movers, i);
      const motion::State b = motion::state_of(movers, j);
      if (!motion::in_conflict(a, b, separation, options.horizon_s)) continue;
      const auto report =
          motion::report_conflict(motion::relative_motion(a, b), separation, options.horizon_s);
      conflicts.push_back(
          {i, j, report.span.begins_s, report.closest_s, report.span.ends_s, report.closest_m});
      if (conflicts.size() > options.max_results) {
        return core::too_many_results(options.max_results);
      }
    }
  }
  return conflicts;
}

}  // namespace brute_force

}  // namespace beespace
