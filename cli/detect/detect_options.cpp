#include "cli/detect/detect_command.hpp"
#include "cli/detect/reports/report.hpp"
#include "cli/input/moving_options.hpp"

#include <string>
#include <vector>

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Tell which bees are too close to another one";

constexpr const char* kDetails =
    "Reads text tables (longitude, latitude, height or x, y, z), .npy arrays and raw float64, "
    "each\n"
    "plain or gzip-compressed. Writes the report to standard output and a summary to standard\n"
    "error. An id is the 0-based data row, or the text of the file's id column. A recording, in "
    "which\n"
    "a bee is at several times, is for 'beespace replay'.\n"
    "\n"
    "Reports, and what their lines say:\n"
    "  at-risk       who is closer than the threshold to another bee: id\n"
    "  pairs         who is too close to whom: id, id, distance\n"
    "  neighbors     everybody who is too close to each bee: id, how many, their ids\n"
    "  counts        how many are too close to each bee: id, how many\n"
    "  nearest       each bee's nearest other bee, however far: id, its id, distance\n"
    "  groups        who must be brought apart together: number, size, ids\n"
    "  closest-pair  the two bees that are closest of all: id, id, distance\n"
    "at-risk is a plain list; all others begin with a header line.\n"
    "\n"
    "Examples:\n"
    "  beespace detect bees.csv\n"
    "  beespace detect bees.csv --threshold 50 --report pairs --output pairs.csv\n"
    "  beespace detect bees.csv --report nearest --at-risk-only\n"
    "  beespace detect traffic.csv --threshold 5NM --vertical 1000ft\n"
    "  beespace detect ours.csv --others towers.csv --report closest-pair\n"
    "  zcat swarm.txt.gz | beespace detect --columns id=1,lon=2,lat=3,height=4 --json\n"
    "  beespace detect swarm.npy --crs metres --quiet --fail-on-risk --output /dev/null\n"
    "  [ $? -eq 1 ] && echo danger\n"
    "\n"
    "Exit status: 0 fine, 1 somebody is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input\n"
    "or more than --max-results, 4 cannot open, read or write, 130 interrupted, 143 terminated,\n"
    "141 closed pipe.";

std::vector<std::string> report_names() {
  std::vector<std::string> names;
  for (const Report& report : reports()) names.emplace_back(report.name);
  return names;
}

void add_input_options(Command& detect, DetectOptions& options) {
  detect.argument("FILE", options.input, "What to read (default, or -: standard input)");
  detect.group("Input");
  detect.option("--others", "FILE", options.others, "Compare with these, not with each other");
  detect.choice("--crs", options.frame, {"auto", "wgs84", "metres"},
                "Whether the input is in degrees or metres");
  detect.option("--columns", "LIST", options.columns,
                "By number or name: id=1,lon=2,lat=3,height=4");
  add_units_options(detect, options.units, options.heights);
  detect.choice("--format", options.format, {"auto", "text", "npy", "bin"},
                "How the input is written");
  detect.flag("--skip-bad", options.skip_bad, "Leave bad records out and list them");
  detect.flag("--unique-ids", options.unique_ids, "Refuse inputs in which an id comes again");
}

void add_search_options(Command& detect, DetectOptions& options) {
  detect.group("Search");
  detect.choice("--report", options.report, report_names(),
                "What to find, see below (default: at-risk)", "WHAT");
  detect.option("--threshold", "LENGTH", options.threshold,
                "Closer than this is too close (default: 100)");
  detect.option("--vertical", "LENGTH", options.vertical,
                "Too close only if closer than this in height too;\nthe threshold is then "
                "horizontal. The distance shown\nis still that in a straight line, and the "
                "nearest is\nthe nearest of those in the cylinder");
  detect.flag("--inclusive", options.inclusive, "A distance of exactly the threshold counts too");
  detect.flag("--at-risk-only", options.at_risk_only,
              "Only who is at risk (neighbors, counts, nearest)");
  detect.option("--max-results", "N", options.max_results,
                "Fail beyond so many (pairs, neighbors; default: no limit)");
  detect.option("--threads", "N", options.threads, "How many threads work (default: 0, all)");
}

void add_output_options(Command& detect, DetectOptions& options) {
  detect.group("Output");
  detect.option("-o,--output", "FILE", options.output,
                "Where the answer goes, by its ending .csv, .json or\n.geojson, perhaps with "
                ".gz, in this form (default:\nstandard output)");
  detect.flag("--csv", options.csv, "The bees' records as they stand, with columns added");
  detect.flag("--json", options.json, "One JSON document with everything in it");
  detect.flag("--geojson", options.geojson,
              "Points or lines for map tools (input in degrees only)");
  detect.flag("--fail-on-risk", options.fail_on_risk,
              "Exit with 1 when somebody is at risk, or records were\nleft out");
  detect.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

}  // namespace

Command detect_command(DetectOptions& options) {
  Command detect("detect", kDescription, kDetails, [&options] { return run_detect(options); });
  add_input_options(detect, options);
  add_search_options(detect, options);
  add_output_options(detect, options);
  return detect;
}

}  // namespace beespace::cli
