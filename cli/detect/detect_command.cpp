#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/detect/answer_ids.hpp"
#include "cli/detect/answer_output.hpp"
#include "cli/detect/detect_search.hpp"
#include "cli/detect/detection.hpp"
#include "cli/detect/load_inputs.hpp"
#include "cli/detect/summary.hpp"
#include "cli/output/output_file.hpp"
#include "io/bytes/atomic_output.hpp"

#include <string_view>
#include <utility>

namespace beespace::cli {
namespace {

constexpr std::string_view kOfAnswer = " of the answer";

OddIds odd_ids(const analysis::ShownIds& ids) {
  return {ids.empty_count(), ids.broken_count()};
}

void write_answer(const Answer& answer, io::AtomicOutput& output) {
  switch (answer.request.form.form) {
    case Form::kText:
      return write_text(answer, output);
    case Form::kCsv:
      return write_csv(answer, output);
    case Form::kJson:
      return write_json(answer, output);
    case Form::kGeoJson:
      return write_geojson(answer, output);
  }
}

}  // namespace

Result<ExitCode> run_detect(const DetectRequest& request) {
  // Opened first, so that a folder that is not there is known before a long read.
  auto output = open_output("detect", request.output,
                            {request.input(), request.others.value_or("")}, request.form.packing);
  if (!output) return std::move(output).error();
  ProgressBar progress(!request.quiet);
  Stopwatch watch;
  auto inputs = load_inputs(request, progress);
  if (!inputs) return std::move(inputs).error();
  const double read_s = watch.lap();

  progress.enter_stage("searching");
  auto detection = search(*inputs, request);
  if (!detection) return std::move(detection).error();
  detection->timings.read_s = read_s;
  detection->timings.search_s = watch.lap();

  progress.enter_stage("writing");
  const AnswerIds ids(*inputs, detection->table, request.form.form);
  note_ids(odd_ids(ids.ours()), kOfAnswer, request.form.form, inputs->ours.notes);
  if (inputs->others) {
    note_ids(odd_ids(ids.theirs()), kOfAnswer, request.form.form, inputs->others->notes);
  }
  write_answer({request, *inputs, *detection, ids}, *output);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  detection->timings.write_s = watch.lap();

  progress.finish();
  if (!request.quiet) say(summary(*inputs, *detection, request));
  const bool risky = !detection->at_risk.empty() || inputs->skipped() > 0;
  const bool risk = request.fail_on_risk && risky;
  return risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
