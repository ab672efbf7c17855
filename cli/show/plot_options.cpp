#include "cli/show/plot_command.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Draw a picture of who is too close, where and when";

constexpr const char* kDetails =
    "Reads what 'beespace report' reads. Draws, in one picture for papers and slides, the swarm\n"
    "from above and from the side with those at risk, and how far everybody's nearest other bee\n"
    "is; of recordings the paths with their parts in conflict, and how far apart the closest two\n"
    "are over time. Who is at risk is marked by shape, size and lightness as well as by colour.\n"
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
    "Exit status: 0 fine, 1 somebody is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_picture_options(Command& plot, PlotOptions& options) {
  MovingOptions& moving = options.scene.moving;
  plot.group("Output");
  plot.option("-o,--output", "FILE", moving.output,
              "Where the picture goes, by its ending .svg or .png\n(default, or -: standard "
              "output, as SVG)");
  plot.option("--width", "PIXELS", options.width, "So many pixels wide (default: 1200)");
  plot.option("--title", "TEXT", options.title,
              "What is above it (default: the name of the input)");
  plot.flag("--json", moving.json, "Say errors as JSON too");
  plot.flag("--fail-on-risk", moving.fail_on_risk,
            "Exit with 1 when somebody is at risk, or a gap or\nrecords that were left out may "
            "hide it");
  plot.flag("--quiet", moving.quiet, "No summary and no progress, only errors");
}

}  // namespace

Command plot_command(PlotOptions& options) {
  Command plot("plot", kDescription, kDetails, [&options] { return run_plot(options); });
  add_scene_options(plot, options.scene);
  add_picture_options(plot, options);
  return plot;
}

}  // namespace beespace::cli
