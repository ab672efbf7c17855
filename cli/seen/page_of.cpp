#include "cli/seen/page_of.hpp"

#include "cli/option_values.hpp"
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

}  // namespace

Result<MadePage> page_of(const char* command, const SeenRequest& request,
                         const std::string& compare, ProgressBar& progress) {
  if (Status fit = check(command, request, compare); !fit) return std::move(fit).error();
  std::vector<std::vector<std::string>> inputs{request.moving.inputs};
  if (!compare.empty()) inputs.push_back({compare});
  MadePage page;
  SeenRequest like_the_first = request;
  for (const auto& files : inputs) {
    auto seen = see(files, like_the_first, progress);
    if (!seen) return std::move(seen).error();
    like_the_first.origin = swarm_of(*seen).origin;
    page.seen.push_back(*std::move(seen));
  }
  const auto& all = page.seen;
  if (all.size() == 2 && all[0].index() != all[1].index()) {
    return usage_error(command, "'" + swarm_of(all[0]).title + "' and '" + swarm_of(all[1]).title +
                                    "' cannot be compared: one is a snapshot, the other a "
                                    "recording");
  }
  progress.enter_stage("writing");
  for (const Seen& seen : all) page.swarms.push_back(json_of(seen, page.columns));
  return page;
}

}  // namespace beespace::cli
