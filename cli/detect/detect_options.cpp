#include "cli/command_line/option_checks.hpp"
#include "cli/detect/detect_command.hpp"
#include "cli/detect/reports/report.hpp"
#include "cli/input/moving_options.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

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

void add_input_options(CLI::App& detect, DetectOptions& options) {
  detect.add_option("FILE", options.input, "What to read (default, or -: standard input)")
      ->type_name(" ");
  detect.add_option("--others", options.others, "Compare with these, not with each other")
      ->type_name("FILE")
      ->group("Input");
  CLI::Option* frame =
      detect.add_option("--crs", options.frame, "Whether the input is in degrees or metres")
          ->type_name("auto|wgs84|metres")
          ->group("Input");
  allow_only(*frame, {"auto", "wgs84", "metres"});
  detect.add_option("--columns", options.columns, "By number or name: id=1,lon=2,lat=3,height=4")
      ->type_name("LIST")
      ->group("Input");
  add_units_options(detect, options.units, options.heights);
  CLI::Option* format = detect.add_option("--format", options.format, "How the input is written")
                            ->type_name("auto|text|npy|bin")
                            ->group("Input");
  allow_only(*format, {"auto", "text", "npy", "bin"});
  detect.add_flag("--skip-bad", options.skip_bad, "Leave bad records out and list them")
      ->group("Input");
  detect.add_flag("--unique-ids", options.unique_ids, "Refuse inputs in which an id comes again")
      ->group("Input");
}

void add_search_options(CLI::App& detect, DetectOptions& options) {
  CLI::Option* report =
      detect.add_option("--report", options.report, "What to find, see below (default: at-risk)")
          ->type_name("WHAT")
          ->group("Search");
  allow_only(*report, report_names());
  detect
      .add_option("--threshold", options.threshold, "Closer than this is too close (default: 100)")
      ->type_name("LENGTH")
      ->group("Search");
  detect
      .add_option("--vertical", options.vertical,
                  "Too close only if closer than this in height too;\nthe threshold is then "
                  "horizontal. The distance shown\nis still that in a straight line, and the "
                  "nearest is\nthe nearest of those in the cylinder")
      ->type_name("LENGTH")
      ->group("Search");
  detect
      .add_flag("--inclusive", options.inclusive, "A distance of exactly the threshold counts too")
      ->group("Search");
  detect
      .add_flag("--at-risk-only", options.at_risk_only,
                "Only who is at risk (neighbors, counts, nearest)")
      ->group("Search");
  detect
      .add_option("--max-results", options.max_results,
                  "Fail beyond so many (pairs, neighbors; default: no limit)")
      ->type_name("N")
      ->group("Search");
  detect.add_option("--threads", options.threads, "How many threads work (default: 0, all)")
      ->type_name("N")
      ->group("Search");
}

void add_output_options(CLI::App& detect, DetectOptions& options) {
  detect
      .add_option("-o,--output", options.output,
                  "Where the answer goes, by its ending .csv, .json or\n.geojson, perhaps with "
                  ".gz, in this form (default:\nstandard output)")
      ->type_name("FILE")
      ->group("Output");
  detect.add_flag("--csv", options.csv, "The bees' records as they stand, with columns added")
      ->group("Output");
  detect.add_flag("--json", options.json, "One JSON document with everything in it")
      ->group("Output");
  detect
      .add_flag("--geojson", options.geojson,
                "Points or lines for map tools (input in degrees only)")
      ->group("Output");
  detect
      .add_flag("--fail-on-risk", options.fail_on_risk,
                "Exit with 1 when somebody is at risk, or records were\nleft out")
      ->group("Output");
  detect.add_flag("--quiet", options.quiet, "No summary and no progress, only errors")
      ->group("Output");
}

}  // namespace

CLI::App* add_detect_command(CLI::App& command, DetectOptions& options) {
  CLI::App* detect = command.add_subcommand("detect", kDescription);
  detect->footer(kDetails);
  detect->set_version_flag("--version", std::string(version()), "Print the version and exit");
  add_input_options(*detect, options);
  add_search_options(*detect, options);
  add_output_options(*detect, options);
  refuse_pointless_values(*detect);
  return detect;
}

}  // namespace beespace::cli
