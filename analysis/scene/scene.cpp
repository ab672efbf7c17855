#include "analysis/scene/scene.hpp"

namespace beespace::analysis {

const report::SwarmFacts& swarm_of(const Scene& scene) {
  return std::visit([](const auto& facts) -> const report::SwarmFacts& { return facts.swarm; },
                    scene);
}

report::SwarmFacts& swarm_of(Scene& scene) {
  return std::visit([](auto& facts) -> report::SwarmFacts& { return facts.swarm; }, scene);
}

bool is_risky(const Scene& scene) {
  const auto* recording = std::get_if<report::RecordingFacts>(&scene);
  if (recording != nullptr && recording->hidden) return true;
  const auto* snapshot = std::get_if<report::SnapshotFacts>(&scene);
  if (snapshot != nullptr && !snapshot->unknown.empty()) return true;
  if (snapshot != nullptr && snapshot->ahead && snapshot->ahead->count > 0) return true;
  return std::visit([](const auto& facts) { return !facts.at_risk.empty(); }, scene);
}

void set_title(Scene& scene, const std::string& title) {
  std::visit([&title](auto& facts) { facts.swarm.title = title; }, scene);
}

}  // namespace beespace::analysis
