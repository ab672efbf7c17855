#include "cli/show/report_command.hpp"

#include <memory>

namespace beespace::cli {
namespace {

constexpr const char* kReportDescription =
    "Write a page that shows who is too close, where and when";

constexpr const char* kReportDetails =
    "Reads snapshots as 'beespace detect' does, and recordings as 'beespace replay' does; of\n"
    "aircraft at one instant each, where they are at the last of them. Writes one HTML file that\n"
    "needs nothing else and no network: the swarm in three dimensions, who is at risk, the worst\n"
    "pairs, and of recordings the time. Who is at risk is decided here, exactly; positions in the\n"
    "page are rounded, and it says how much. Of more than 200,000 pairs, or conflicts, the "
    "closest\n"
    "10,000 are in it.\n"
    "\n"
    "Examples:\n"
    "  beespace report bees.csv -o report.html\n"
    "  beespace report swarm.csv --threshold 5 -o report.html\n"
    "  beespace report show.skyc -o show.html\n"
    "  beespace report before.csv --compare after.csv --threshold 5 -o both.html\n"
    "  beespace report flown.csv --fleet-log fleet.ndjson --threshold 5 -o fleet.html\n"
    "\n"
    "Exit status: 0 fine, 1 a bee is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_page_options(Command& report, MovingRequest& moving) {
  report.group("Output");
  report.option("-o,--output", "FILE", moving.output,
                "Where the page goes (default: standard output,\nwhich must not be a terminal)");
  add_error_json_option(report, moving);
  add_scene_risk_option(report, moving);
  add_quiet_option(report, moving.quiet);
}

}  // namespace

void add_page_input_options(Command& command, ReportRequest& request) {
  add_scene_options(command, request.show);
  command.group("Input");
  command.option("--compare", "FILE", request.compare,
                 "Show this beside it: what came before on the left,\nthis on the right");
  command.option("--fleet-log", "FILE", request.fleet_log,
                 "What a planner said of the bees of FILES, as 'guide'\nand 'simulate --fleet-log' "
                 "write it: where each should\nbe, its tube, its claim and its contract");
  command.option(
      "--obstacles", "FILE", request.obstacles,
      "Draw these, too: JSON, as 'verify' reads it, which says\nwho keeps clear of them");
}

Command report_command() {
  const auto request = std::make_shared<ReportRequest>();
  Command report("report", kReportDescription, kReportDetails, [request](const Command&) {
    return settle(request->show.moving, "report").and_then([&] { return run_report(*request); });
  });
  add_page_input_options(report, *request);
  add_page_options(report, request->show.moving);
  return report;
}

}  // namespace beespace::cli
