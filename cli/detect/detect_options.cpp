#include "cli/command_line/option_values.hpp"
#include "cli/console/terminal.hpp"
#include "cli/detect/detect_command.hpp"
#include "cli/detect/detection.hpp"
#include "cli/detect/out_of_core/detect_out_of_core.hpp"
#include "cli/input/moving_options.hpp"
#include "io/problems/excerpt.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

constexpr double kDefaultThreshold_m = 100.0;  // the paper's

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
    "  neighbors     all that are too close to each bee: id, how many, their ids\n"
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
    "  beespace detect traffic.csv --separation terminal\n"
    "  beespace detect ours.csv --others towers.csv --report closest-pair\n"
    "  zcat swarm.txt.gz | beespace detect --columns id=1,lon=2,lat=3,height=4 --json\n"
    "  beespace detect archive.npy --crs metres --memory 4GB --output at-risk.txt\n"
    "  beespace detect part-*.csv.gz --memory 2GB --temporary /scratch --output pairs.csv \\\n"
    "    --report pairs\n"
    "  beespace detect swarm.npy --crs metres --quiet --fail-on-risk --output /dev/null\n"
    "  [ $? -eq 1 ] && echo danger\n"
    "\n"
    "Exit status: 0 fine, 1 a bee is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input\n"
    "or more than --max-results, 4 cannot open, read or write, 130 interrupted, 143 terminated,\n"
    "141 closed pipe.";

Error wrong(std::string message) {
  return usage_error("detect", std::move(message));
}

void add_input_options(Command& detect, DetectRequest& request) {
  detect.arguments("FILE", request.inputs,
                   "What to read (default, or -: standard input); several\nwith --memory");
  detect.group("Input");
  detect.option("--others", "FILE", request.others, take_text,
                "Compare with these, not with each other");
  add_frame_option(detect, request.load.frame, "Whether the input is in degrees or metres");
  detect.option("--columns", "LIST", request.load.columns,
                "By number or name: id=1,lon=2,lat=3,height=4");
  add_units_options(detect, request.load.units, request.load.heights);
  detect.choice("--format", request.load.format,
                {{"auto", io::Format::kAuto},
                 {"text", io::Format::kText},
                 {"npy", io::Format::kNpy},
                 {"bin", io::Format::kRawFloat64}},
                "How the input is written");
  detect.flag("--skip-bad", request.load.skip_bad, "Leave bad records out and list them");
  detect.flag("--unique-ids", request.unique_ids, "Refuse inputs in which an id comes again");
}

void add_search_options(Command& detect, DetectRequest& request) {
  std::vector<Word<const Report*>> words;
  words.reserve(reports().size());
  for (const Report& report : reports()) words.push_back({report.name, &report});
  detect.group("Search");
  detect.choice("--report", request.report, words, "What to find, see below (default: at-risk)",
                "WHAT");
  detect.option("--threshold", "LENGTH", request.threshold, read_stated_threshold,
                "Closer than this is too close (default: 100; of\naircraft it is asked for)");
  detect.option("--vertical", "LENGTH", request.vertical, read_vertical,
                "Too close only if closer than this in height too;\nthe threshold is then "
                "horizontal. The distance shown\nis still that in a straight line, and the "
                "nearest is\nthe nearest of those in the cylinder");
  add_usual_separation_option(detect, request.separation);
  detect.flag("--inclusive", request.search.inclusive,
              "A distance of exactly the threshold counts too");
  detect.flag("--at-risk-only", request.at_risk_only,
              "Only who is at risk (neighbors, counts, nearest)");
  detect.option("--max-results", "N", request.max_results, read_max_results,
                "Fail beyond so many (pairs, neighbors; default: no limit)");
  detect.option("--threads", "N", request.search.threads, read_threads,
                "How many threads work (default: 0, all)");
  detect.option("--memory", "SIZE", request.memory_bytes, read_memory,
                "Use so much memory and temporary files, for files\nthat do not fit: 500MB, 4GB "
                "(no groups, --others\nand --geojson)");
  detect.option("--temporary", "FOLDER", request.temporary, take_text,
                "Where temporary files go, which have no name\n(default: $TMPDIR, or /var/tmp)");
}

void add_output_options(Command& detect, DetectRequest& request) {
  detect.group("Output");
  detect.option("-o,--output", "FILE", request.output,
                "Where the answer goes, by its ending .csv, .json or\n.geojson, perhaps with "
                ".gz, in this form (default:\nstandard output)");
  detect.flag("--csv", request.csv, "The bees' records as they stand, with columns added");
  detect.flag("--json", request.json, "One JSON document with everything in it");
  detect.flag("--geojson", request.geojson,
              "Points or lines for map tools (input in degrees only)");
  detect.flag("--fail-on-risk", request.fail_on_risk,
              "Exit with 1 when a bee is at risk, or records were\nleft out");
  detect.flag("--quiet", request.quiet, "No summary and no progress, only errors");
}

// An option that the report would ignore is a misunderstanding.
Status check_fit(const DetectRequest& request) {
  const Report& report = *request.report;
  const struct {
    const char* option;
    bool fits;
  } table[] = {{"--others", !request.others || report.takes_others},
               {"--max-results", !request.max_results || report.has_limit},
               {request.separation != nullptr ? "--separation" : "--vertical",
                !request.vertical || report.takes_vertical},
               {"--at-risk-only", !request.at_risk_only || report.lists_all}};
  for (const auto& [option, fits] : table) {
    if (!fits) return wrong(std::string(option) + " does not apply to --report " + report.name);
  }
  return std::monostate{};
}

// What no option says alone, once all are read.
Status settle(DetectRequest& request) {
  if (request.inputs.empty() && (input_is_terminal() || request.others == "-")) {
    return wrong("say which file to read, or pipe the input in");
  }
  if (request.inputs.empty()) request.inputs.emplace_back("-");
  if (request.input() == "-" && request.others == "-") {
    return wrong("standard input can be read once; name a file for one of the two");
  }
  if (request.inputs.size() > 1 && !request.memory_bytes) {
    return wrong(io::excerpt(request.inputs[1]) +
                 " is one argument too many for 'beespace detect', unless --memory SIZE is given: "
                 "then it reads several files");
  }
  const auto form =
      output_form("detect", {request.output, request.csv, request.json, request.geojson},
                  {{Form::kText, Form::kCsv, Form::kJson, Form::kGeoJson}});
  if (!form) return form.error();
  request.form = *form;
  if (auto status =
          settle_separation("detect", request.separation, request.threshold, request.vertical);
      !status) {
    return status;
  }
  take_heights_of(request.separation, request.vertical, request.load.heights);
  request.load.units.spoken_of = spoken_of_aviation(request.separation, request.threshold);
  PairOptions& search = request.search;
  search.threshold_m = request.threshold ? request.threshold->metric : kDefaultThreshold_m;
  search.max_results = request.max_results.value_or(search.max_results);
  if (request.vertical) search.vertical_m = request.vertical->metric;
  request.load.threads = search.threads;
  request.load.format_can_be_said = true;
  if (auto status = check_fit(request); !status) return status;
  if (request.memory_bytes) return check_out_of_core(request);
  if (!request.temporary.empty()) return wrong("--temporary goes with --memory");
  return std::monostate{};
}

}  // namespace

Command detect_command() {
  const auto request = std::make_shared<DetectRequest>();
  Command detect("detect", kDescription, kDetails, [request](const Command&) {
    return settle(*request).and_then([&] {
      return request->memory_bytes ? run_detect_out_of_core(*request) : run_detect(*request);
    });
  });
  add_input_options(detect, *request);
  add_search_options(detect, *request);
  add_output_options(detect, *request);
  return detect;
}

}  // namespace beespace::cli
