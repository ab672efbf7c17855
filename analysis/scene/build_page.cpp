#include "analysis/scene/build_page.hpp"

#include "report/recording_json.hpp"
#include "report/snapshot_json.hpp"

#include <utility>
#include <variant>

namespace beespace::analysis {
namespace {

Error refused(std::string message) {
  return {ErrorCode::kInvalidArgument, std::move(message), {}};
}

// Two that are compared are two of a kind, in the same frame.
Status check_alike(const Scene& one, const Scene& other) {
  const report::SwarmFacts& first = swarm_of(one);
  const report::SwarmFacts& second = swarm_of(other);
  const auto differ = [&](const std::string& what) {
    return refused("'" + first.title + "' and '" + second.title + "' cannot be compared: one is " +
                   what);
  };
  if (one.index() != other.index()) return differ("a snapshot, the other a recording");
  if (first.origin.has_value() != second.origin.has_value()) {
    return differ(
        "in degrees, the other in metres; how far drones were from a show tells 'beespace fleet "
        "FLOWN --set SHOW'");
  }
  return std::monostate{};
}

}  // namespace

Status check_has_page() {
  if (!report::page_template().empty()) return std::monostate{};
  return refused(
      "this build has no page in it; build beespace with Node.js and npm, and without "
      "-DBEESPACE_WEB=OFF");
}

Result<Page> build_page(const std::vector<Scene>& scenes) {
  if (Status has = check_has_page(); !has) return std::move(has).error();
  if (scenes.empty() || scenes.size() > 2)
    return refused("a page shows one scene, or compares two");
  if (scenes.size() == 2) {
    if (Status alike = check_alike(scenes[0], scenes[1]); !alike) return std::move(alike).error();
  }
  Page page;
  for (const Scene& scene : scenes) {
    if (std::visit([](const auto& facts) { return report::ground_of(facts); }, scene) ==
        report::Ground::kWith) {
      page.ground = report::Ground::kWith;
    }
  }
  const auto write_swarms = [&](io::JsonWriter& json) {
    for (const Scene& scene : scenes) {
      std::visit([&](const auto& facts) { report::write_swarm(json, facts, page.columns); }, scene);
    }
  };
  page.json = report::page_json(write_swarms, page.ground);
  return page;
}

void write_page(const Page& page, const report::PageSink& sink) {
  report::write_page(report::page_template(), page.json, page.columns, sink, page.ground);
}

}  // namespace beespace::analysis
