#include "cli/show/scene_summary.hpp"

#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace beespace::cli {
namespace {

std::string risk_of(const report::SnapshotFacts& facts) {
  if (facts.at_risk.empty() && !facts.unknown.empty()) {
    return bold("none of those that are known") + "; " + facts.unknown;
  }
  if (facts.at_risk.empty()) return bold("none");
  return red(io::grouped(facts.at_risk.size()) + " of " + io::grouped(facts.positions.size())) +
         ": " + io::counted(facts.pair_count, "pair", "pairs") + " in " +
         io::counted(facts.group_count, "group", "groups");
}

std::string risk_of(const report::RecordingFacts& facts) {
  if (facts.conflict_count == 0 && !facts.unknown.empty()) {
    return bold("none in the known time") + "; " + facts.unknown;
  }
  if (facts.conflict_count == 0) return bold("none");
  return red(io::counted(facts.conflict_count, "conflict", "conflicts")) + " of " +
         io::counted(facts.pair_count, "pair", "pairs");
}

std::size_t bees_of(const report::SnapshotFacts& facts) {
  return facts.positions.size();
}
std::size_t bees_of(const report::RecordingFacts& facts) {
  return facts.tracks.size();
}

}  // namespace

void append_scene(std::string& out, const analysis::Scene& scene, const MovingRequest& request) {
  const report::SwarmFacts& swarm = analysis::swarm_of(scene);
  append_summary_line(out, "input", printable(swarm.title) + " (" + printable(swarm.source) + ")");
  for (const std::string& note : swarm.notes) append_summary_line(out, "note", printable(note));
  append_summary_line(
      out, "bees",
      std::visit([](const auto& facts) { return io::grouped(bees_of(facts)); }, scene));
  append_summary_line(out, "threshold",
                      separation_text(swarm.threshold_m, swarm.vertical_m, swarm.inclusive,
                                      request.threshold, request.vertical) +
                          usual_text(request.separation));
  append_summary_line(out, "at risk",
                      std::visit([](const auto& facts) { return risk_of(facts); }, scene));
}

void append_written(std::string& out, const std::string& output, const SceneTimings& timings) {
  if (output != "-") {
    std::error_code unknown;
    const auto bytes = std::filesystem::file_size(output, unknown);
    append_summary_line(out, "written",
                        printable(output) + (unknown ? "" : " (" + io::byte_count(bytes) + ")"));
  }
  append_summary_line(out, "time",
                      "read " + io::duration(timings.read_s) + ", find " +
                          io::duration(timings.find_s) + ", write " +
                          io::duration(timings.write_s));
}

}  // namespace beespace::cli
