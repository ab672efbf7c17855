#include "cli/command_line/option_values.hpp"
#include "cli/show/plot_command.hpp"

#include "io/bytes/number_text.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kPlotDescription = "Draw a picture of who is too close, where and when";

constexpr const char* kPlotDetails =
    "Reads what 'beespace report' reads. Draws, in one picture for papers and slides, the swarm\n"
    "from above and from the side with those at risk, and how far each bee's nearest other bee\n"
    "is; of one moment with velocities also when it is, and the ways of those that come too close\n"
    "later, flying straight on; of recordings the paths with their parts in conflict, and how far\n"
    "apart the closest two are over time. Who is at risk is marked by shape, size and lightness as "
    "well as by colour.\n"
    "More than 4,000 bees are drawn as shades: the picture then says so, and stays small.\n"
    "\n"
    "The ending of FILE says the format: .svg, which is sharp at any size, or .png, for which\n"
    "cairo must be installed. The same input gives the same SVG, byte by byte.\n"
    "\n"
    "Examples:\n"
    "  beespace plot bees.csv -o bees.svg\n"
    "  beespace plot swarm.csv --threshold 5 -o swarm.png --width 2400\n"
    "  beespace plot show.skyc -o show.svg --title 'Opening night'\n"
    "  beespace generate --points 200 --area medellin | beespace plot > bees.svg\n"
    "\n"
    "Exit status: 0 fine, 1 a bee is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

Result<unsigned> read_width(const Typed& typed) {
  constexpr std::uint64_t kLeast = 200;
  constexpr std::uint64_t kMost = 10'000;
  const auto width = io::parse_whole(typed.text);
  if (width && *width >= kLeast && *width <= kMost) return static_cast<unsigned>(*width);
  return usage_error(
      typed.command,
      "--width must be a whole number of pixels from 200 to 10000, not '" + typed.text + "'");
}

void add_picture_options(Command& plot, PlotRequest& request) {
  MovingRequest& moving = request.show.moving;
  plot.group("Output");
  plot.option("-o,--output", "FILE", moving.output,
              "Where the picture goes, by its ending .svg or .png\n(default, or -: standard "
              "output, as SVG)");
  plot.option("--width", "PIXELS", request.width, read_width,
              "So many pixels wide (default: 1200)");
  plot.option("--title", "TEXT", request.title,
              "What is above it (default: the name of the input)");
  add_error_json_option(plot, moving);
  add_scene_risk_option(plot, moving);
  add_quiet_option(plot, moving.quiet);
}

}  // namespace

Command plot_command() {
  const auto request = std::make_shared<PlotRequest>();
  Command plot("plot", kPlotDescription, kPlotDetails, [request](const Command&) {
    return settle(request->show.moving, "plot").and_then([&] { return run_plot(*request); });
  });
  add_scene_options(plot, request->show);
  add_picture_options(plot, *request);
  return plot;
}

}  // namespace beespace::cli
