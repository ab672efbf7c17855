#include "cli/show/scene_summary.hpp"

#include "analysis/recorded/usual_horizon.hpp"
#include "analysis/scene/worst_link.hpp"
#include "cli/command_line/option_values.hpp"
#include "cli/console/recipe_text.hpp"
#include "cli/console/summary_line.hpp"
#include "cli/console/terminal.hpp"
#include "cli/input/moving_output.hpp"
#include "io/bytes/number_text.hpp"
#include "report/ahead_words.hpp"

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace beespace::cli {
namespace {

// Also where there is a risk: it may be a greater one.
std::string and_unknown(const std::string& unknown) {
  return unknown.empty() ? unknown : "; " + unknown;
}

std::string risk_of(const report::SnapshotFacts& facts) {
  if (facts.at_risk.empty() && !facts.unknown.empty()) {
    return bold("none of those that are known") + "; " + facts.unknown;
  }
  if (facts.at_risk.empty()) return bold(facts.moment.empty() ? "none" : "none at this moment");
  return red(io::grouped(facts.at_risk.size()) + " of " + io::grouped(facts.positions.size())) +
         ": " + io::counted(facts.pair_count, "pair", "pairs") + " in " +
         io::counted(facts.group_count, "group", "groups") + and_unknown(facts.unknown);
}

std::string risk_of(const report::RecordingFacts& facts) {
  if (facts.nothing_compared) {
    return bold("nothing to compare") + ": no two " + facts.swarm.noun.several +
           " are there at the same time" + and_unknown(facts.unknown);
  }
  const std::string but_for = facts.low_count > 0 ? ", but for " + facts.low_text : "";
  if (facts.conflict_count == 0 && !facts.unknown.empty()) {
    return bold("none in the known time") + but_for + "; " + facts.unknown;
  }
  if (facts.conflict_count == 0) return bold("none") + but_for;
  return red(io::counted(facts.conflict_count, "conflict", "conflicts")) + " of " +
         io::counted(facts.pair_count, "pair", "pairs") + but_for + and_unknown(facts.unknown);
}

std::size_t bees_of(const report::SnapshotFacts& facts) {
  return facts.positions.size();
}
std::size_t bees_of(const report::RecordingFacts& facts) {
  return facts.tracks.size() + facts.nowhere_count;
}

// What comes after the moment that is shown.
void append_ahead(std::string& out, const report::SnapshotFacts& facts,
                  const MovingRequest& request) {
  const std::string words = printable(report::ahead_words(facts));
  if (words.empty()) return;
  const bool risk = facts.ahead && facts.ahead->count > 0;
  append_summary_line(out, "ahead", risk ? red(words) : words);
  if (!risk || request.inputs.size() != 1 || request.inputs.front() == "-") return;
  const double horizon_s = facts.ahead->horizon_s;
  const bool usual = horizon_s == analysis::usual_horizon_s(facts.swarm.noun.one == "aircraft");
  append_summary_line(out, "",
                      "'beespace predict " + printable(typed_name(request.inputs.front())) +
                          separation_typed(request) +
                          (usual ? "" : " --horizon " + io::exact(horizon_s)) + "' tells more");
}

}  // namespace

void append_scene(std::string& out, const analysis::Scene& scene, const MovingRequest& request) {
  const report::SwarmFacts& swarm = analysis::swarm_of(scene);
  append_summary_line(out, "input", printable(swarm.title) + " (" + printable(swarm.source) + ")");
  for (const std::string& note : swarm.notes) append_summary_line(out, "note", printable(note));
  append_summary_line(
      out, swarm.noun.several,
      std::visit([](const auto& facts) { return io::grouped(bees_of(facts)); }, scene));
  if (const auto* snapshot = std::get_if<report::SnapshotFacts>(&scene)) {
    if (!snapshot->moment.empty()) append_summary_line(out, "now", printable(snapshot->moment));
  }
  append_summary_line(out, "threshold",
                      separation_text(swarm.threshold_m, swarm.vertical_m, swarm.inclusive,
                                      request.threshold, request.vertical) +
                          usual_text(request.separation) + swarm.threshold_words);
  append_summary_line(out, "at risk",
                      std::visit([](const auto& facts) { return risk_of(facts); }, scene));
  if (const auto* snapshot = std::get_if<report::SnapshotFacts>(&scene)) {
    append_ahead(out, *snapshot, request);
  }
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

void append_worst_link(std::string& out, const std::string& address,
                       const std::vector<analysis::Scene>& scenes) {
  if (scenes.size() != 1) return;
  const std::string link = analysis::worst_link(scenes.front());
  if (!link.empty()) append_summary_line(out, "worst pair", printable(address + link));
}

std::string file_address(const std::string& path) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::error_code unknown;
  const std::string whole = std::filesystem::absolute(path, unknown).string();
  std::string address = "file://";
  for (const char c : unknown ? path : whole) {
    if (kPlain.find(c) != std::string_view::npos) {
      address += c;
    } else {
      const auto byte = static_cast<unsigned char>(c);
      address += {'%', kDigits[byte >> 4u], kDigits[byte & 15u]};
    }
  }
  return address;
}

}  // namespace beespace::cli
