#include "cli/show/report_command.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/output_form.hpp"
#include "cli/show/page_loading.hpp"
#include "cli/show/scene_summary.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kReport = "report";

// A page under the name of something else would be opened by what cannot read it.
Status check_ending(const std::string& output) {
  if (output == "-") return std::monostate{};
  const FileEnding of = file_ending(output);
  const std::string& ending = of.ending;
  const auto misnamed = [&](const std::string& otherwise) {
    return usage_error(kReport, "a page is HTML, unlike what its name '" + printable(output) +
                                    "' says; let it end in .html, or " + otherwise);
  };
  if (ending == "svg" || ending == "png") {
    return misnamed("let 'beespace plot' draw the picture");
  }
  for (const char* other : {"kml", "czml", "geojson", "csv"}) {
    if (ending == other) return misnamed("let 'beespace export' write that file");
  }
  if (ending == "json") {
    return misnamed(
        "let 'beespace export' write .geojson or .czml, or ask 'beespace detect --json'");
  }
  const bool page = ending.empty() || ending == "html" || ending == "htm";
  if (!page || of.compressed) return misnamed("in nothing");
  return std::monostate{};
}

}  // namespace

Result<ExitCode> run_report(const ReportRequest& request) {
  const MovingRequest& moving = request.show.moving;
  if (moving.output == "-" && output_is_terminal()) {
    return usage_error(kReport, "a page is nothing for a terminal; give it a name: -o report.html");
  }
  std::vector<std::string> inputs = moving.inputs;
  inputs.push_back(request.compare);
  inputs.push_back(request.fleet_log);
  inputs.push_back(request.obstacles);
  auto output = open_output(kReport, moving.output, inputs);
  if (!output) return std::move(output).error();
  if (Status html = check_ending(moving.output); !html) return std::move(html).error();
  ProgressBar progress(!moving.quiet);
  const auto loaded = load_page(kReport, request, progress);
  if (!loaded) return loaded.error();
  Stopwatch watch;
  analysis::write_page(loaded->page, [&](std::string_view text) { output->write(text); });
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  const double written_s = watch.lap();
  progress.finish();
  if (!moving.quiet) {
    std::string text;
    for (const analysis::Scene& scene : loaded->scenes) append_scene(text, scene, moving);
    SceneTimings timings = loaded->timings;
    timings.write_s += written_s;
    append_written(text, moving.output, timings);
    if (moving.output != "-") {
      append_worst_link(text, file_address(moving.output), loaded->scenes);
    }
    say(text);
  }
  const bool risk = std::any_of(loaded->scenes.begin(), loaded->scenes.end(), analysis::is_risky);
  return risk && moving.fail_on_risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
