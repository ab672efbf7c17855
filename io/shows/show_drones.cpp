#include "io/shows/show_drones.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/show_facts.hpp"
#include "io/recording/show_ground.hpp"

#include <beespace/bezier_path.hpp>

#include <algorithm>

namespace beespace::io {
namespace {

Error single_point(const ShowDrone& drone) {
  Error error{ErrorCode::kMalformedRecord,
              "drone " + excerpt(drone.name) +
                  ": points has a single point, which does not say how long the "
                  "drone is there; add a second point with the time until which",
              {drone.place}};
  return error;
}

}  // namespace

std::optional<Error> ShowDrones::keep(RecordingAssembly& assembly) {
  double ground_m = std::numeric_limits<double>::infinity();
  for (const ShowDrone& drone : drones_) {
    ground_m = std::min(ground_m, lowest_of(drone.trajectory, drone.ground));
  }
  // As high as a roof only where all of them say so, and do so: otherwise a part of a show would
  // look like the whole.
  if (ground_m > kHighestShowGround_m) {
    raised_ = std::all_of(drones_.begin(), drones_.end(), [ground_m](const ShowDrone& drone) {
      return starts_and_lands_at(drone.trajectory, drone.ground, ground_m);
    });
    if (raised_) {
      raised_m_ = ground_m;
    } else {
      ground_m = 0.0;
    }
  }
  if (!drones_.empty()) assembly.declare_ground(ground_m);
  const bool all = assembly.options().grounded;
  for (ShowDrone& drone : drones_) {
    BezierPath& path = drone.trajectory.path;
    const bool single = path.pieces.empty();
    if (single && (all || !on_ground(path.begin.z, ground_m))) {
      if (auto fatal = assembly.bad(single_point(drone), drone.name)) return fatal;
      continue;
    }
    count_takeoff(drone.trajectory);
    const bool stood = !all && keep_flight(drone.trajectory, ground_m);
    if (path.pieces.empty()) {
      ++grounded_;
      assembly.tracks().add_standing(std::move(drone.name), path.begin);
      continue;
    }
    if (stood) ++stood_;
    assembly.tracks().add_path(std::move(drone.name), std::move(path));
  }
  drones_.clear();
  return std::nullopt;
}

void ShowDrones::count_takeoff(const Trajectory& trajectory) {
  const double takeoff_s = trajectory.takeoff_s.value_or(0.0);
  if (takeoff_s != 0.0) ++shifted_;
  first_takeoff_s_ = std::min(first_takeoff_s_, takeoff_s);
  last_takeoff_s_ = std::max(last_takeoff_s_, takeoff_s);
}

void ShowDrones::note_ground(RecordingAssembly& assembly) const {
  if (shifted_ > 0) {
    assembly.note("the times of the points of " + std::to_string(shifted_) +
                  (shifted_ == 1 ? " drone" : " drones") +
                  " count from takeoffTime, which is not 0" +
                  (first_takeoff_s_ < last_takeoff_s_ ? " and not the same for all" : "") +
                  ", as Skybrush plays them");
  }
  if (raised_) {
    assembly.note("the ground is at z = " + exact(raised_m_) +
                  " m, where all drones start and land, as their home and landAt say");
  }
  if (stood_ > 0) assembly.note(standing_note(stood_));
  if (grounded_ > 0) assembly.note(grounded_note(grounded_));
}

}  // namespace beespace::io
