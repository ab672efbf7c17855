// The beespace command: reads the command line and hands over to the subcommand.

#include "cli/advise/advise_command.hpp"
#include "cli/bench/bench_command.hpp"
#include "cli/command_line/completions.hpp"
#include "cli/command_line/parser.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/console/signals.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "cli/detect/detect_command.hpp"
#include "cli/fleet/fleet_command.hpp"
#include "cli/follow/follow_command.hpp"
#include "cli/generate/generate_command.hpp"
#include "cli/guide/guide_command.hpp"
#include "cli/recorded/predict_command.hpp"
#include "cli/recorded/replay_command.hpp"
#include "cli/recorded/verify_command.hpp"
#include "cli/show/export_command.hpp"
#include "cli/show/plot_command.hpp"
#include "cli/show/report_command.hpp"
#include "cli/show/view_command.hpp"
#include "cli/simulate/simulate_command.hpp"
#include "cli/watch/watch_command.hpp"

#include <exception>
#include <new>
#include <string_view>

namespace beespace::cli {
namespace {

constexpr const char* kDescription =
    "Who is too close to whom, exactly and fast: separation checks for swarms.";

constexpr const char* kExamples =
    "Examples:\n"
    "  beespace detect bees.csv                      who is closer than 100 m to another bee\n"
    "  beespace detect bees.csv --report pairs       who is too close to whom, and how close\n"
    "  beespace predict swarm.csv --threshold 5      who is about to come too close to whom\n"
    "  beespace predict aircraft.json --separation enroute\n"
    "                                                the same of aircraft: 5 NM and 1000 ft\n"
    "  beespace replay show.skyc                     whether a drone show keeps its distance\n"
    "  beespace replay storks.csv --threshold 50     which animals met: Movebank, trackdf, TRex, "
    "...\n"
    "  beespace verify show.skyc                     the same, and whether it keeps its limits\n"
    "  beespace replay north.ulg south.ulg           the same of flights, by the drones' logs\n"
    "  tail -f swarm.csv | beespace watch            the same live\n"
    "  beespace advise swarm.csv                     how all bees should fly to keep apart\n"
    "  beespace guide --threshold 5 --max-speed 10 --max-acceleration 5\n"
    "                                                a fleet that is not exact, by radio\n"
    "  beespace follow --agent 7 ...                 an agent of it, on its companion computer\n"
    "  beespace simulate random-swap                 a swarm that is kept apart, step by step\n"
    "  beespace verify flight.csv --threshold 5      whether a flight kept its distance\n"
    "  beespace fleet flown.csv --set set.csv        how far a fleet strays from its plan\n"
    "  beespace report bees.csv -o report.html       a page that shows it\n"
    "  beespace view show.skyc                       the same, in the browser at once\n"
    "  beespace plot bees.csv -o bees.svg            a picture of it\n"
    "  beespace export bees.csv -o bees.kml          for globes, maps and spreadsheets\n"
    "  beespace generate --points 1000 --area medellin --output bees.csv\n"
    "  beespace bench                                how fast it is on this machine\n"
    "\n"
    "'beespace help detect' says more about detect, and so on.";

ExitCode run(int argc, char** argv) {
  handle_signals();
  Program beespace{"beespace",
                   kDescription,
                   kExamples,
                   {detect_command(), predict_command(), replay_command(), watch_command(),
                    advise_command(), guide_command(), follow_command(), simulate_command(),
                    verify_command(), fleet_command(), report_command(), view_command(),
                    plot_command(), export_command(), generate_command(), bench_command()}};
  // For scripts/write-completions; no help names it.
  if (argc == 3 && std::string_view(argv[1]) == "--write-completions") {
    if (const auto text = completions_for(argv[2], beespace.commands)) return print(*text);
  }
  return run_command_line(beespace, argc, argv);
}

}  // namespace
}  // namespace beespace::cli

int main(int argc, char** argv) {
  using beespace::cli::ExitCode;
  try {
    return static_cast<int>(beespace::cli::run(argc, argv));
  } catch (const std::bad_alloc&) {
    // Said without a string, for which there may be no memory either.
    beespace::cli::say("beespace: error: out of memory; close other programs or split the input\n");
  } catch (const std::exception& problem) {
    beespace::cli::say("beespace: error: this is a defect of beespace, please report it: ");
    beespace::cli::say(problem.what());
    beespace::cli::say("\n");
  }
  return static_cast<int>(ExitCode::kSystem);
}
