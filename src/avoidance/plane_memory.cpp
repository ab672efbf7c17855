#include "avoidance/plane_memory.hpp"

#include <algorithm>
#include <memory>

namespace beespace {

namespace {

auto entry_of(auto& row, PointId higher) {
  return std::lower_bound(row.begin(), row.end(), higher,
                          [](const auto& entry, PointId id) { return entry.other < id; });
}

}  // namespace

void PlaneMemory::State::start(std::size_t agents) {
  if (agents > last_.size()) {
    last_.resize(agents);
    coming_.resize(agents);
    last_walls_.resize(agents);
    coming_walls_.resize(agents);
  }
  for (auto& row : coming_) row.clear();
  for (auto& row : coming_walls_) row.clear();
}

core::Vector3 PlaneMemory::State::normal(PointId lower, PointId higher) const {
  const auto& row = last_[lower];
  const auto entry = entry_of(row, higher);
  return entry != row.end() && entry->other == higher ? entry->normal : core::Vector3{};
}

void PlaneMemory::State::forget(PointId agent) {
  if (agent < last_.size()) last_[agent].clear(), last_walls_[agent].clear();
  for (PointId lower = 0; lower < agent && lower < last_.size(); ++lower) {
    auto& row = last_[lower];
    const auto entry = entry_of(row, agent);
    if (entry != row.end() && entry->other == agent) row.erase(entry);
  }
}

void PlaneMemory::State::forget_all() {
  for (auto& row : last_) row.clear();
  for (auto& row : last_walls_) row.clear();
}

PlaneMemory::PlaneMemory() : state_(std::make_unique<State>()) {
}
PlaneMemory::PlaneMemory(PlaneMemory&&) noexcept = default;
PlaneMemory& PlaneMemory::operator=(PlaneMemory&&) noexcept = default;
PlaneMemory::~PlaneMemory() = default;

void PlaneMemory::forget(PointId agent) {
  state_->forget(agent);
}

}  // namespace beespace
