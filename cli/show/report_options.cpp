#include "cli/show/report_command.hpp"

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Write a page that shows who is too close, where and when";

constexpr const char* kDetails =
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
    "\n"
    "Exit status: 0 fine, 1 somebody is at risk (with --fail-on-risk), 2 wrong usage, 3 bad "
    "input,\n"
    "4 cannot open, read or write, 130 interrupted, 143 terminated, 141 closed pipe.";

void add_page_options(Command& report, MovingOptions& options) {
  report.group("Output");
  report.option("-o,--output", "FILE", options.output,
                "Where the page goes (default: standard output,\nwhich must not be a terminal)");
  report.flag("--json", options.json, "Say errors as JSON too");
  report.flag("--fail-on-risk", options.fail_on_risk,
              "Exit with 1 when somebody is at risk, or a gap or\nrecords that were left out may "
              "hide it");
  report.flag("--quiet", options.quiet, "No summary and no progress, only errors");
}

}  // namespace

void add_page_input_options(Command& command, ReportOptions& options) {
  add_scene_options(command, options.scene);
  command.group("Input");
  command.option("--compare", "FILE", options.compare,
                 "Show this beside it: what came before on the left,\nthis on the right");
}

Command report_command(ReportOptions& options) {
  Command report("report", kDescription, kDetails, [&options] { return run_report(options); });
  add_page_input_options(report, options);
  add_page_options(report, options.scene.moving);
  return report;
}

}  // namespace beespace::cli
