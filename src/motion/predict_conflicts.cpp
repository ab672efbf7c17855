#include <beespace/brute_force.hpp>
#include <beespace/predict_conflicts.hpp>

#include "core/validate.hpp"
#include "cpu/crew_size.hpp"
#include "motion/prediction.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <utility>

namespace beespace {

namespace {

std::optional<Error> check(const MoversView& movers, const PredictOptions& options) {
  if (auto error = motion::check_options(options)) return error;
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
  const motion::Separation separation = motion::separation_of(options);
  std::vector<Conflict> conflicts;
  for (PointId i = 0; i < movers.size(); ++i) {
    for (PointId j = i + 1; j < movers.size(); ++j) {
      if (!motion::in_conflict(movers[i], movers[j], separation, options.horizon_s)) continue;
      const auto report =
          motion::report_conflict(
              motion::relative_motion(movers[i], movers[j]), separation, options.horizon_s);
      conflicts.push_back({i, j, report.span.begins_s, report.closest_s, report.span.ends_s,
                           report.closest_m});
      if (conflicts.size() > options.max_results) {
        return core::too_many_results(options.max_results);
      }
    }
  }
  return conflicts;
}

}  // namespace brute_force

}  // namespace beespace
