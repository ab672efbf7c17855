#include "cli/bench/bench_command.hpp"
#include "cli/command_line/option_checks.hpp"

#include <beespace/version.hpp>

#include <CLI/CLI.hpp>

#include <string>

namespace beespace::cli {
namespace {

constexpr const char* kDescription = "Take a quick look at how fast the searches are here";

constexpr const char* kDetails =
    "Makes five swarms, from crowded to sparse, asks five questions about each, compares a part\n"
    "of every answer with brute force, and only then times it, with one thread and with all.\n"
    "Figures are nanoseconds a bee, and multiples of the time to read the coordinates in order,\n"
    "as a search finds the points: between its repetitions. Takes some seconds.\n"
    "\n"
    "Examples:\n"
    "  beespace bench\n"
    "  beespace bench --points 1000000 --json > bench.json";

}  // namespace

CLI::App* add_bench_command(CLI::App& command, BenchOptions& options) {
  CLI::App* bench = command.add_subcommand("bench", kDescription);
  bench->footer(kDetails);
  bench->set_version_flag("--version", std::string(version()), "Print the version and exit");
  bench->add_option("--points", options.points, "How many bees a swarm has (default: 200000)")
      ->type_name("N");
  bench
      ->add_option("--threads", options.threads,
                   "How many threads work beside the run with one (default: 0, all)")
      ->type_name("N");
  bench->add_flag("--json", options.json, "One JSON document instead of a table");
  bench->add_flag("--quiet", options.quiet, "No explanations, only figures and errors");
  refuse_pointless_values(*bench);
  return bench;
}

}  // namespace beespace::cli
