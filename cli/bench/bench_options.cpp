#include "cli/bench/bench_command.hpp"
#include "cli/command_line/option_values.hpp"

#include <memory>

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

Command bench_command() {
  const auto request = std::make_shared<BenchRequest>();
  Command bench("bench", kDescription, kDetails,
                [request](const Command&) { return run_bench(*request); });
  bench.option("--points", "N", request->points, whole(1'000, 100'000'000),
               "How many bees a swarm has (default: 200000)");
  bench.option("--threads", "N", request->threads, whole(0, 1'024),
               "How many threads work beside the run with one (default: 0, all)");
  bench.flag("--json", request->json, "One JSON document instead of a table");
  bench.flag("--quiet", request->quiet, "No explanations, only figures and errors");
  return bench;
}

}  // namespace beespace::cli
