// The normals of the planes between agents, from one call to the next.
#pragma once

#include "base/vector3.hpp"

#include <beespace/advise.hpp>
#include <beespace/pairs.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace beespace {

// Each pair belongs to the agent of the lower id. While the planes of the last call are read, those
// of this one are written: by agent, so that several threads may write.
class __attribute__((visibility("hidden"))) PlaneMemory::State {
 public:
  struct Entry {
    PointId other;
    core::Vector3 normal;  // from the other to the agent of the lower id
  };

  struct Wall {
    std::size_t obstacle;
    core::Vector3 normal;  // from a piece of it to the agent
  };

  // Makes room for the planes of a call with so many agents.
  void start(std::size_t agents);
  // Zero where none is remembered.
  [[nodiscard]] core::Vector3 normal(PointId lower, PointId higher) const;
  // In ascending order of `higher` for each `lower`.
  void remember(PointId lower, PointId higher, const core::Vector3& normal) {
    coming_[lower].push_back({higher, normal});
  }
  [[nodiscard]] std::span<const Wall> walls(PointId agent) const { return last_walls_[agent]; }
  void remember_wall(PointId agent, const Wall& wall) { coming_walls_[agent].push_back(wall); }
  // From now on the planes of this call are those of the last one.
  void finish() { last_.swap(coming_), last_walls_.swap(coming_walls_); }
  void forget(PointId agent);
  void forget_all();

 private:
  std::vector<std::vector<Entry>> last_;
  std::vector<std::vector<Entry>> coming_;
  std::vector<std::vector<Wall>> last_walls_;
  std::vector<std::vector<Wall>> coming_walls_;
};

}  // namespace beespace
