#include "cli/show/plot_command.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/failure.hpp"
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

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

constexpr const char* kName = "plot";

struct PlotRequest {
  ShowRequest show;
  std::string title;
  unsigned width = 0;
  bool png = false;
};

Result<unsigned> read_width(const std::string& text) {
  constexpr std::uint64_t kLeast = 200;
  constexpr std::uint64_t kMost = 10'000;
  const auto width = io::parse_whole(text);
  if (!width || *width < kLeast || *width > kMost) {
    return usage_error(
        kName, "--width must be a whole number of pixels from 200 to 10000, not '" + text + "'");
  }
  return static_cast<unsigned>(*width);
}

Result<bool> read_png(const std::string& output) {
  if (output == "-") {
    if (!output_is_terminal()) return false;
    return usage_error(kName, "a picture is nothing for a terminal; give it a name: -o bees.svg");
  }
  const FileEnding of = file_ending(output);
  if (of.ending == "svg" && !of.compressed) return false;
  if (of.ending != "png" || of.compressed) {
    return usage_error(kName, "a picture's name ends in .svg or .png, unlike '" +
                                  printable(output) + "'" + written_elsewhere(kName, of.ending));
  }
  const std::string lacking = report::why_no_png();
  if (lacking.empty()) return true;
  return usage_error(kName, lacking + "; or give a name that ends in .svg");
}

Result<PlotRequest> plot_request(const PlotOptions& options) {
  auto show = show_request(kName, options.scene);
  if (!show) return std::move(show).error();
  const auto width = read_width(options.width);
  if (!width) return width.error();
  const auto png = read_png(show->output);
  if (!png) return png.error();
  return PlotRequest{*std::move(show), options.title, *width, *png};
}

// The bytes of the picture; what must be said of it goes to `note`.
Result<std::string> picture_of(const analysis::Scene& scene, const PlotRequest& request,
                               std::string& note) {
  const report::Drawing drawing =
      std::visit([](const auto& facts) { return report::figure_of(facts); }, scene);
  if (!request.png) return report::svg(drawing, request.width);
  auto png = report::png(drawing, request.width);
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

Result<ExitCode> plot(const PlotRequest& request) {
  const ShowRequest& show = request.show;
  auto output = open_output(kName, show.output, show.inputs);
  if (!output) return std::move(output).error();
  ProgressBar progress(!show.quiet);
  SceneTimings timings;
  auto scene = load_scene(show.inputs, show.scene, progress, timings);
  if (!scene) return std::move(scene).error();
  Stopwatch watch;

  progress.enter_stage("drawing");
  if (!request.title.empty()) analysis::set_title(*scene, request.title);
  std::string note;
  const auto picture = picture_of(*scene, request, note);
  if (!picture) return picture.error();
  output->write(*picture);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  timings.write_s = watch.lap();
  progress.finish();
  if (!show.quiet) {
    std::string text;
    append_scene(text, *scene);
    if (!note.empty()) append_summary_line(text, "note", printable(note));
    append_written(text, show.output, timings);
    say(text);
  }
  return analysis::is_risky(*scene) && show.fail_on_risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace

ExitCode run_plot(const PlotOptions& options) {
  const bool json = options.scene.moving.json;
  const auto request = plot_request(options);
  if (!request) return fail(request.error(), json);
  const auto code = plot(*request);
  return code ? *code : fail(code.error(), json);
}

}  // namespace beespace::cli
