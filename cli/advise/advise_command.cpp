#include "cli/advise/advise_input.hpp"
#include "cli/advise/advise_output.hpp"
#include "cli/advise/advise_request.hpp"
#include "cli/advise/advise_summary.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/output_file.hpp"

#include <utility>

namespace beespace::cli {
namespace {

// Some bee is not certified, or something that was said cannot be used.
bool is_risky(const Advised& advised) {
  return !advised.refused.empty() || count_uncertified(advised) > 0;
}

}  // namespace

Result<ExitCode> run_advise(const AdviseRequest& request) {
  auto output =
      open_output("advise", request.output, {request.input, request.obstacles, request.intruders},
                  request.form.packing);
  if (!output) return std::move(output).error();
  ProgressBar progress(!request.quiet);
  Stopwatch watch;
  const auto given = load_advice_input(request);
  if (!given) return given.error();
  AdviseTimes times{watch.lap(), 0.0};
  progress.enter_stage("advising");
  const auto advised =
      advise(given->movers, given->preferred, given->limits, given->options_for(request));
  if (!advised) return advised.error();
  times.advise_s = watch.lap();
  const AdviceAnswer answer{request, *given, *advised};
  if (request.form.form == Form::kJson) {
    write_as_json(answer, *output);
  } else {
    write_as_csv(answer, *output);
  }
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  progress.finish();
  if (!request.quiet) say(advise_summary(answer, times));
  return request.fail_on_risk && is_risky(*advised) ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
