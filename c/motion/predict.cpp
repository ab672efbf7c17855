// Which movers are about to come closer than the threshold.
#include <beespace/predict_conflicts.hpp>

#include "c/door/movers.hpp"
#include "c/door/options.hpp"
#include "c/door/question.hpp"

#include <beespace/closest_approach.hpp>

using namespace beespace::c;  // NOLINT(google-build-using-namespace): the functions are of C
using beespace::MoversView;
using beespace::PredictOptions;
using beespace::Result;
using beespace::RunOptions;
using beespace::Status;

namespace {

Result<PredictOptions> prediction_of(const beespace_search* search, double horizon_s,
                                     const RunOptions& run) {
  const Result<Search> asked = search_of(search, kWithin | BEESPACE_MAX_RESULTS);
  if (!asked) return asked.error();
  PredictOptions options;
  options.threshold_m = asked->options.threshold_m;
  options.vertical_m = asked->options.vertical_m;
  options.horizon_s = horizon_s;
  options.inclusive = asked->options.inclusive;
  options.threads = run.threads;
  options.max_results = asked->options.max_results;
  options.stop = run.stop;
  return options;
}

// Asks ask(movers, options, engine, result), which returns a Status.
template <class Ask>
beespace_code answer_of_movers(beespace_engine* engine, const beespace_points* positions,
                               const beespace_points* velocities, const beespace_search* search,
                               double horizon_s, const beespace_run* run, beespace_result* result,
                               beespace_error* error, Ask&& ask) {
  return answer_into(result, error, [&]() -> Status {
    const Result<MoversView> movers = movers_of(positions, velocities, kMovers);
    if (!movers) return movers.error();
    CallEngine used(engine);
    return call_watched(run, [&](const RunOptions& run_options) -> Status {
      const Result<PredictOptions> options = prediction_of(search, horizon_s, run_options);
      if (!options) return options.error();
      Status status = ask(*movers, *options, *used, *result);
      if (status) return status;
      return with_array(std::move(status).error(), *movers, kMovers);
    });
  });
}

}  // namespace

extern "C" {

beespace_code beespace_predict(beespace_engine* engine, const beespace_points* positions,
                               const beespace_points* velocities, const beespace_search* search,
                               double horizon_s, const beespace_run* run, beespace_result* result,
                               beespace_error* error) {
  const auto ask = [](const MoversView& movers, const PredictOptions& options,
                      beespace_engine& used, beespace_result& into) -> Status {
    Status status = used.engine.predict_conflicts(movers, options, used.conflicts);
    return status ? write_conflicts(used.conflicts, options.stop, into) : status;
  };
  return answer_of_movers(engine, positions, velocities, search, horizon_s, run, result, error,
                          ask);
}

beespace_code beespace_predict_pairs(beespace_engine* engine, const beespace_points* positions,
                                     const beespace_points* velocities,
                                     const beespace_search* search, double horizon_s,
                                     const beespace_run* run, beespace_result* result,
                                     beespace_error* error) {
  const auto ask = [](const MoversView& movers, const PredictOptions& options,
                      beespace_engine& used, beespace_result& into) -> Status {
    Status status = used.engine.predict_pairs(movers, options, used.pairs);
    return status ? write_pairs(used.pairs, options.stop, into) : status;
  };
  return answer_of_movers(engine, positions, velocities, search, horizon_s, run, result, error,
                          ask);
}

}  // extern "C"
