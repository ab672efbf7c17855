#include "cli/show/export_command.hpp"

#include "analysis/scene/place_on_earth.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/output_form.hpp"
#include "cli/show/scene_loading.hpp"
#include "cli/show/scene_summary.hpp"
#include "cli/show/shown_obstacles.hpp"
#include "io/bytes/atomic_output.hpp"
#include "report/map/czml.hpp"
#include "report/map/geojson.hpp"
#include "report/map/kml.hpp"
#include "report/map/risk_table.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kExport = "export";

bool is_format(const std::string& ending) {
  return ending == "kml" || ending == "czml" || ending == "geojson" || ending == "csv";
}

Result<std::string> format_of(const ExportRequest& request) {
  const std::string& output = request.show.moving.output;
  const FileEnding of = output == "-" ? FileEnding{} : file_ending(output);
  if (!request.format.empty()) {
    if (!is_format(of.ending) || of.ending == request.format) return request.format;
    return usage_error(kExport, "--format " + request.format + " contradicts the ending of '" +
                                    printable(output) + "'; correct one of them");
  }
  if (output == "-") {
    return usage_error(kExport, "say in which format: --format kml, czml, geojson or csv");
  }
  if (is_format(of.ending)) return of.ending;
  return usage_error(kExport,
                     "the name of the file ends in .kml, .czml, .geojson or .csv, unlike '" +
                         printable(output) + "'; or say which with --format" +
                         written_elsewhere(kExport, of.ending));
}

// What the input says of its place that cannot be taken, behind a colon; otherwise nothing.
std::string about_place(const report::SwarmFacts& swarm) {
  const auto note = std::find_if(swarm.notes.begin(), swarm.notes.end(), [](const auto& text) {
    return text.starts_with("the location of the show is not taken");
  });
  return note == swarm.notes.end() ? std::string() : ": " + printable(*note);
}

Status check_fit(const analysis::Scene& scene, const std::string& format) {
  const report::SwarmFacts& swarm = analysis::swarm_of(scene);
  if (swarm.origin || format == "csv") return std::monostate{};
  return usage_error(kExport,
                     format + " is for the Earth and needs longitudes and latitudes, but '" +
                         printable(swarm.title) +
                         "' is in metres; say with --origin lon,lat,height,heading where it is, or "
                         "--format csv, which takes metres as well" +
                         about_place(swarm));
}

// What is asked for at once, and cannot be.
Status check_together(const ExportRequest& request, const std::string& format) {
  if (request.obstacles.empty()) return std::monostate{};
  if (format == "csv") {
    return usage_error(kExport, "a table of pairs has no place for --obstacles; leave it out");
  }
  const auto& inputs = request.show.moving.inputs;
  const bool twice =
      request.obstacles == "-" && std::find(inputs.begin(), inputs.end(), "-") != inputs.end();
  if (twice) return usage_error(kExport, "standard input can be read once");
  return std::monostate{};
}

// Where positions in metres lie: as is said, or for what needs it as the input says.
Status place(analysis::Scene& scene, const ExportRequest& request, const std::string& format) {
  if (request.placement) return analysis::place_on_earth(scene, *request.placement);
  const report::SwarmFacts& swarm = analysis::swarm_of(scene);
  if (swarm.origin || !swarm.own_place || format == "csv") return std::monostate{};
  const report::Placement own = *swarm.own_place;
  return analysis::place_on_earth(scene, own);
}

// Returns what had to be left out.
template <class Facts>
std::vector<std::string> write(const Facts& facts, const std::string& format,
                               io::AtomicOutput& output) {
  if (format == "kml") return report::write_kml(facts, output);
  if (format == "czml") return report::write_czml(facts, output);
  if (format == "geojson") return report::write_geojson(facts, output);
  report::write_risk_table(facts, output);
  return {};
}

Result<ExitCode> export_to(const ExportRequest& request, const std::string& format) {
  if (Status together = check_together(request, format); !together) return together.error();
  const MovingRequest& moving = request.show.moving;
  const auto obstacles = load_shown_obstacles(request.obstacles);
  if (!obstacles) return obstacles.error();
  std::vector<std::string> read = moving.inputs;
  if (!request.obstacles.empty()) read.push_back(request.obstacles);
  auto output =
      open_output(kExport, moving.output, read,
                  file_ending(moving.output).compressed ? io::Packing::kGzip : io::Packing::kPlain);
  if (!output) return std::move(output).error();
  ProgressBar progress(!moving.quiet);
  SceneTimings timings;
  auto scene = load_scene(moving.inputs, scene_request(request.show), progress, timings);
  if (!scene) return scene.error();
  if (Status shown = show_obstacles(*obstacles, *scene); !shown) return shown.error();
  if (Status placed = place(*scene, request, format); !placed) return placed.error();
  if (Status fit = check_fit(*scene, format); !fit) return fit.error();
  Stopwatch watch;

  progress.enter_stage("writing");
  const auto notes =
      std::visit([&](const auto& facts) { return write(facts, format, *output); }, *scene);
  const Status written = output->commit();
  if (!written && output->pipe_closed()) return ExitCode::kPipeClosed;
  if (!written) return written.error();
  timings.write_s = watch.lap();
  progress.finish();
  if (!moving.quiet) {
    std::string text;
    append_scene(text, *scene, moving);
    for (const std::string& note : notes) append_summary_line(text, "note", printable(note));
    append_written(text, moving.output, timings);
    say(text);
  }
  return analysis::is_risky(*scene) && moving.fail_on_risk ? ExitCode::kRiskFound : ExitCode::kFine;
}

}  // namespace

Result<ExitCode> run_export(const ExportRequest& request) {
  return format_of(request).and_then(
      [&](const std::string& format) { return export_to(request, format); });
}

}  // namespace beespace::cli
