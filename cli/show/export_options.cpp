#include "cli/command_line/option_values.hpp"
#include "cli/input/placement_option.hpp"
#include "cli/show/export_command.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kExportDescription =
    "Write who is too close for globes, maps and spreadsheets";

constexpr const char* kExportDetails =
    "Reads what 'beespace report' reads. The ending of FILE, or --format, says what is written:\n"
    "  kml       for globes: those at risk and pairs; of recordings the paths in time, and\n"
    "            conflicts where they are closest, for as long as they last\n"
    "  czml      the same for Cesium: bees move, and are red while they are in conflict\n"
    "  geojson   for maps: points and lines with ids, distances and times (RFC 7946); of\n"
    "            recordings the paths too\n"
    "  csv       for spreadsheets: a row a pair, or a row a conflict, the closest first\n"
    "\n"
    "Maps and globes need longitudes and latitudes; csv takes metres as well. Of positions in "
    "metres\n"
    "--origin says where x = y = z = 0 is, and where x points; y is a quarter to its left. A show "
    "may\n"
    "say that itself. Distances stay those in metres. Heights are written as the input has them,\n"
    "and the file says what they are counted from. Files for maps and globes hold up to 20,000\n"
    "marks of a kind and 2,000 paths, and say what they leave out. Of more than 200,000 pairs or\n"
    "conflicts the closest 10,000 are written; the file says so, of csv only the summary. In csv\n"
    "an id that a spreadsheet would take for a formula, as it begins with =, +, - or @ and is no\n"
    "number, gets an apostrophe before it.\n"
    "\n"
    "Examples:\n"
    "  beespace export bees.csv -o bees.kml\n"
    "  beespace export flight.json --threshold 300 -o conflicts.geojson\n"
    "  beespace export show.skyc -o conflicts.csv\n"
    "  beespace export show.skyc --origin 19.06,47.48,110,90 --obstacles city.json -o show.kml\n"
    "  beespace export bees.csv --format csv | sort -t, -k3 -g | head\n"
    "\n"
    "Exit status: 0 fine, 1 a bee is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_file_options(Command& command, ExportRequest& request) {
  MovingRequest& moving = request.show.moving;
  command.group("Output");
  command.option("-o,--output", "FILE", moving.output,
                 "Where it goes, by its ending .kml, .czml,\n.geojson or .csv (default, or -: "
                 "standard output)");
  command.choice("--format", request.format, {"kml", "czml", "geojson", "csv"},
                 "Where the ending does not say");
  command.option("--origin", "PLACE", request.placement, read_placement,
                 "Of positions in metres: lon,lat,height,heading of x\n(in degrees; 0 is north, 90 "
                 "east), as 19.06,47.48,110,90");
  command.option("--obstacles", "FILE", request.obstacles,
                 "Draw these, too, with --origin: JSON, as 'verify'\nreads it, in metres");
  add_error_json_option(command, moving);
  add_scene_risk_option(command, moving);
  add_quiet_option(command, moving.quiet);
}

}  // namespace

Command export_command() {
  const auto request = std::make_shared<ExportRequest>();
  Command command("export", kExportDescription, kExportDetails, [request](const Command&) {
    return settle(request->show.moving, "export").and_then([&] { return run_export(*request); });
  });
  add_scene_options(command, request->show);
  add_file_options(command, *request);
  return command;
}

}  // namespace beespace::cli
