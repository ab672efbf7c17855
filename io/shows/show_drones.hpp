// The drones of a show, once all are read: what is the ground, who stands on it, and when.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/shows/show_trajectory.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {

inline constexpr std::string_view kNoDroneFlies =
    "no drone of this show leaves the ground; --grounded checks them there";

// What is read of a drone, and where.
struct ShowDrone {
  std::string name = {};
  Trajectory trajectory = {};
  Ground ground = {};
  std::string place = {};  // of a trajectory of a single point
};

class ShowDrones {
 public:
  void add(ShowDrone drone) { drones_.push_back(std::move(drone)); }

  // Into the source that `assembly` has begun. What is the ground, is known when all are there.
  std::optional<Error> keep(RecordingAssembly& assembly);
  // How many of them never leave the ground.
  [[nodiscard]] std::uint64_t grounded() const { return grounded_; }
  // What is to be said of them.
  void note_ground(RecordingAssembly& assembly) const;

 private:
  void count_takeoff(const Trajectory& trajectory);

  std::vector<ShowDrone> drones_;
  bool raised_ = false;    // the ground is higher than kHighestShowGround_m:
  double raised_m_ = 0.0;  // so high
  std::uint64_t stood_ = 0;
  std::uint64_t grounded_ = 0;
  std::uint64_t shifted_ = 0;  // by takeoffTime
  double first_takeoff_s_ = std::numeric_limits<double>::infinity();
  double last_takeoff_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace beespace::io
