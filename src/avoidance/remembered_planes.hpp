// What a call reads of the planes of the call before, and writes for the next one.
#pragma once

#include "avoidance/intake.hpp"
#include "avoidance/plane_memory.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace beespace::avoidance {

// Agents are remembered by the numbers that they were given, and have others here where some were
// left out. No more visible than what it refers to.
class __attribute__((visibility("hidden"))) RememberedPlanes {
 public:
  using Wall = PlaneMemory::State::Wall;

  RememberedPlanes() = default;  // remembers nothing
  // `ids` are those of the agents as they were given; none: their numbers. `of_one`: one agent
  // is advised alone.
  RememberedPlanes(PlaneMemory::State* memory, const GivenNumbers& given,
                   std::span<const PointId> ids, bool of_one)
      : memory_(memory), given_(&given), ids_(ids), of_one_(of_one) {}

  // From the higher to the lower; zero where there is none.
  [[nodiscard]] core::Vector3 normal(PointId lower, PointId higher) const {
    return memory_ == nullptr ? core::Vector3{} : memory_->normal(id(lower), id(higher));
  }
  // Of a pair at which the first looks; the one of the lower id keeps it, for both.
  void remember(PointId bee, PointId other, const core::Vector3& normal) const {
    if (memory_ == nullptr || (bee > other && !of_one_)) return;
    memory_->remember(id(std::min(bee, other)), id(std::max(bee, other)), normal);
  }
  // Of all pieces of an obstacle.
  [[nodiscard]] std::span<const Wall> walls(PointId bee) const {
    return memory_ == nullptr ? std::span<const Wall>() : memory_->walls(id(bee));
  }
  void remember_wall(PointId bee, const Wall& wall) const {
    if (memory_ != nullptr) memory_->remember_wall(id(bee), wall);
  }

 private:
  [[nodiscard]] PointId id(PointId taken) const {
    const std::size_t given = (*given_)[taken];
    return ids_.empty() ? static_cast<PointId>(given) : ids_[given];
  }

  PlaneMemory::State* memory_ = nullptr;
  const GivenNumbers* given_ = nullptr;
  std::span<const PointId> ids_;
  bool of_one_ = false;
};

}  // namespace beespace::avoidance
