// What a call reads of the planes of the call before, and writes for the next one.
#pragma once

#include "avoidance/intake.hpp"
#include "avoidance/plane_memory.hpp"

#include <cstddef>
#include <span>

namespace beespace::avoidance {

// Agents are remembered by the numbers that they were given, and have others here where some were
// left out.
class RememberedPlanes {
 public:
  using Wall = PlaneMemory::State::Wall;

  RememberedPlanes() = default;  // remembers nothing
  RememberedPlanes(PlaneMemory::State* memory, const GivenNumbers& given)
      : memory_(memory), given_(&given) {}

  // From the higher to the lower; zero where there is none.
  [[nodiscard]] core::Vector3 normal(PointId lower, PointId higher) const {
    return memory_ == nullptr ? core::Vector3{} : memory_->normal(id(lower), id(higher));
  }
  void remember(PointId lower, PointId higher, const core::Vector3& normal) const {
    if (memory_ != nullptr) memory_->remember(id(lower), id(higher), normal);
  }
  // Of all pieces of an obstacle.
  [[nodiscard]] std::span<const Wall> walls(PointId bee) const {
    return memory_ == nullptr ? std::span<const Wall>() : memory_->walls(id(bee));
  }
  void remember_wall(PointId bee, const Wall& wall) const {
    if (memory_ != nullptr) memory_->remember_wall(id(bee), wall);
  }

 private:
  [[nodiscard]] PointId id(PointId taken) const { return static_cast<PointId>((*given_)[taken]); }

  PlaneMemory::State* memory_ = nullptr;
  const GivenNumbers* given_ = nullptr;
};

}  // namespace beespace::avoidance
