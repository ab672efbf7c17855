#include "cli/analysis/page_of.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/stopwatch.hpp"
#include "report/recording_json.hpp"
#include "report/snapshot_json.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace beespace::cli {
namespace {

std::string json_of(const Seen& seen, report::Columns& columns) {
  if (const auto* snapshot = std::get_if<report::SnapshotFacts>(&seen)) {
    return report::snapshot_json(*snapshot, columns);
  }
  return report::recording_json(std::get<report::RecordingFacts>(seen), columns);
}

Status check(const char* command, const SeenRequest& request, const std::string& compare) {
  if (report::page_template().empty()) {
    return usage_error(command,
                       "this build has no page in it; build beespace with Node.js and npm, and "
                       "without -DBEESPACE_WEB=OFF");
  }
  const auto& inputs = request.moving.inputs;
  if (compare == "-" && std::count(inputs.begin(), inputs.end(), "-") > 0) {
    return usage_error(command, "standard input can be read once");
  }
  return std::monostate{};
}

// Two that are compared are two of a kind, in the same frame.
Status check_alike(const char* command, const std::vector<Seen>& seen) {
  if (seen.size() < 2) return std::monostate{};
  const report::SwarmFacts& first = swarm_of(seen[0]);
  const report::SwarmFacts& second = swarm_of(seen[1]);
  const auto differ = [&](const std::string& what) {
    return usage_error(command, "'" + first.title + "' and '" + second.title +
                                    "' cannot be compared: one is " + what);
  };
  if (seen[0].index() != seen[1].index()) return differ("a snapshot, the other a recording");
  if (first.origin.has_value() != second.origin.has_value()) {
    return differ("in degrees, the other in metres");
  }
  return std::monostate{};
}

}  // namespace

Result<MadePage> page_of(const char* command, const SeenRequest& request,
                         const std::string& compare, ProgressBar& progress) {
  if (Status fit = check(command, request, compare); !fit) return std::move(fit).error();
  std::vector<std::vector<std::string>> inputs{request.moving.inputs};
  if (!compare.empty()) inputs.push_back({compare});
  MadePage page;
  SeenRequest like_the_first = request;
  for (const auto& files : inputs) {
    auto seen = see(files, like_the_first, progress, page.timings);
    if (!seen) return std::move(seen).error();
    like_the_first.origin = swarm_of(*seen).origin;
    page.seen.push_back(*std::move(seen));
  }
  if (Status alike = check_alike(command, page.seen); !alike) return std::move(alike).error();
  progress.enter_stage("writing");
  Stopwatch watch;
  for (const Seen& seen : page.seen) page.swarms.push_back(json_of(seen, page.columns));
  page.timings.write_s = watch.lap();
  return page;
}

}  // namespace beespace::cli
