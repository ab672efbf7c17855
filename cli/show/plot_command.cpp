#include "cli/show/plot_command.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/output_form.hpp"
#include "cli/show/scene_loading.hpp"
#include "cli/show/scene_summary.hpp"
#include "io/bytes/number_text.hpp"
#include "report/drawing/png.hpp"
#include "report/drawing/svg.hpp"
#include "report/figure/figure.hpp"

#include <string>
#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

constexpr const char* kPlot = "plot";

Result<bool> read_png(const std::string& output) {
  if (output == "-") {
    if (!output_is_terminal()) return false;
    return usage_error(kPlot, "a picture is nothing for a terminal; give it a name: -o bees.svg");
  }
  const FileEnding of = file_ending(output);
  if (of.ending == "svg" && !of.compressed) return false;
  if (of.ending != "png" || of.compressed) {
    return usage_error(kPlot, "a picture's name ends in .svg or .png, unlike '" +
                                  printable(output) + "'" + written_elsewhere(kPlot, of.ending));
  }
  const std::string lacking = report::why_no_png();
  if (lacking.empty()) return true;
  return usage_error(kPlot, lacking + "; or give a name that ends in .svg");
}

// The bytes of the picture; what must be said of it goes to `note`.
Result<std::string> picture_of(const analysis::Scene& scene, unsigned width, bool png_asked,
                               std::string& note) {
  const report::Drawing drawing =
      std::visit([](const auto& facts) { return report::figure_of(facts); }, scene);
  if (!png_asked) return report::svg(drawing, width);
  auto png = report::png(drawing, width);
  if (!png) {
    return Error{ErrorCode::kWriteFailed,
                 "there is no memory for a picture of that size; choose a smaller --width"};
  }
  if (!png->has_fonts) {
    note =
        "no fonts are installed, so letters are plain strokes; install some (Debian: apt-get "
        "install fonts-dejavu-core), or write .svg";
  }
  return std::move(png->bytes);
}

}  // namespace

Result<ExitCode> run_plot(const PlotRequest& request) {
  const MovingRequest& moving = request.show.moving;
  const auto png = read_png(moving.output);
  if (!png) return png.error();
  auto output = open_output(kPlot, moving.output, moving.inputs);
  if (!output) return std::move(output).error();
  ProgressBar progress(!moving.quiet);
  SceneTimings timings;
  auto scene = load_scene(moving.inputs, scene_request(request.show), progress, timings);
  if (!scene) return std::move(scene).error();
  Stopwatch watch;

  progress.enter_stage("drawing");
  if (!request.title.empty()) analysis::set_title(*scene, request.title);
  std::string note;
  const auto picture = picture_of(*scene, request.width, *png, note);
  if (!picture) return picture.error();
  output->write(*picture);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  timings.write_s = watch.lap();
  progress.finish();
  if (!moving.quiet) {
    std::string text;
    append_scene(text, *scene, moving);
    if (!note.empty()) append_summary_line(text, "note", printable(note));
    append_written(text, moving.output, timings);
    say(text);
  }
  return analysis::is_risky(*scene) && moving.fail_on_risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace beespace::cli
