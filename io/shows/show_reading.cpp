#include "io/shows/show_reading.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/show_ground.hpp"
#include "io/shows/show_settings.hpp"
#include "io/shows/show_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

Error show_error(ErrorCode code, std::string message, std::string place) {
  return {code, std::move(message), {std::move(place)}};
}

// What is read of a drone, and where.
struct Drone {
  std::string name = {};
  Trajectory trajectory = {};
  Ground ground = {};
  std::string place = {};  // of a trajectory of a single point
  std::uint64_t index = 0;
};

class ShowReading {
 public:
  ShowReading(ShowDocuments& documents, RecordingAssembly& assembly)
      : documents_(documents), assembly_(assembly) {}

  std::optional<Error> read() {
    if (auto error = option_problem()) return error;
    const ShowValue root = documents_.root();
    if (auto error = json_twice(root.element, {"version"})) {
      error->location.source = documents_.place_of(root);
      return error;
    }
    if (const auto version = json_member(root.element, "version")) {
      double number = 0.0;
      if (!version->get(number) || number != 1.0) {
        return show_error(ErrorCode::kUnsupportedFormat,
                          "the show is of another version; version 1 is read",
                          documents_.place_of(root));
      }
    }
    if (auto error = read_show_settings(documents_, assembly_)) return error;
    SourceFacts facts;
    facts.frame = Frame::kMetres;
    facts.frame_reason = "a Skybrush show is in metres";
    facts.heights = HeightDatum::kHome;
    facts.units = {
        {"x, y and z", Unit::kMetre, UnitEvidence::kNamed, "a Skybrush show is in metres"}};
    facts.description = "Skybrush show";
    if (auto error = assembly_.agree(facts)) return error;
    if (auto error = read_drones(root)) return error;
    note_ground();
    return std::nullopt;
  }

 private:
  std::optional<Error> option_problem() const {
    const RecordingOptions& options = assembly_.options();
    const auto invalid = [](std::string message) {
      return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
    };
    if (options.frame == Frame::kWgs84) {
      return invalid("a Skybrush show is in metres, but --crs wgs84 is given; leave it out");
    }
    if (!options.columns.empty()) {
      return invalid("--columns is for text tables, but this is a Skybrush show; leave it out");
    }
    if (options.units.any()) {
      return invalid("the numbers of a Skybrush show have their units; leave --units out");
    }
    if (options.time_unit != Unit::kUnstated) {
      return invalid("the times of a Skybrush show are in seconds; leave --time-unit out");
    }
    return std::nullopt;
  }

  std::optional<Error> read_drones(const ShowValue& root) {
    auto swarm = documents_.member(root, "swarm");
    if (!swarm) return swarm.error();
    if (!swarm.value()) return no_drones(root);
    auto drones = documents_.member(*swarm.value(), "drones");
    if (!drones) return drones.error();
    JsonArray list;
    if (!drones.value() || !drones.value()->element.get(list)) {
      return no_drones(*swarm.value());
    }
    // The list lies in a document that must stay, even when it is no longer needed for references.
    const std::string list_member = drones.value()->member;
    const bool may_forget = list_member == root.member;
    std::uint64_t index = 0;
    for (const JsonElement element : list) {
      if (may_forget) documents_.forget_parts();
      std::string name = "drone " + std::to_string(index + 1);
      auto drone = read_drone({element, list_member}, index, name);
      if (!drone) {
        Error error = drone.error();
        error.location.record = index;
        if (auto fatal = assembly_.bad(std::move(error), name)) return fatal;
      } else {
        drones_.push_back(*std::move(drone));
      }
      ++index;
    }
    if (index == 0) return no_drones(*swarm.value());
    if (auto error = keep_drones()) return error;
    if (grounded_ == index) {
      return show_error(ErrorCode::kNoPoints,
                        "no drone of this show leaves the ground; --grounded checks them there",
                        documents_.place_of(root));
    }
    return std::nullopt;
  }

  // What is the ground, is known when all are read.
  std::optional<Error> keep_drones() {
    double ground_m = std::numeric_limits<double>::infinity();
    for (const Drone& drone : drones_) {
      ground_m = std::min(ground_m, lowest_of(drone.trajectory, drone.ground));
    }
    // As high as a roof only where all of them say so, and do so: otherwise a part of a show would
    // look like the whole.
    if (ground_m > kHighestShowGround_m) {
      raised_ = std::all_of(drones_.begin(), drones_.end(), [ground_m](const Drone& drone) {
        return starts_and_lands_at(drone.trajectory, drone.ground, ground_m);
      });
      if (raised_) {
        raised_m_ = ground_m;
      } else {
        ground_m = 0.0;
      }
    }
    if (!drones_.empty()) assembly_.declare_ground(ground_m);
    const bool all = assembly_.options().grounded;
    for (Drone& drone : drones_) {
      BezierPath& path = drone.trajectory.path;
      const bool single = path.pieces.empty();
      if (single && (all || !on_ground(path.begin.z, ground_m))) {
        if (auto fatal = assembly_.bad(single_point(drone), drone.name)) return fatal;
        continue;
      }
      count_takeoff(drone.trajectory);
      const bool stood = !all && keep_flight(drone.trajectory, ground_m);
      if (path.pieces.empty()) {
        ++grounded_;
        assembly_.tracks().add_standing(std::move(drone.name), path.begin);
        continue;
      }
      if (stood) ++stood_;
      assembly_.tracks().add_path(std::move(drone.name), std::move(path));
    }
    drones_.clear();
    return std::nullopt;
  }

  static Error single_point(const Drone& drone) {
    Error error = show_error(ErrorCode::kMalformedRecord,
                             "drone " + excerpt(drone.name) +
                                 ": points has a single point, which does not say how long the "
                                 "drone is there; add a second point with the time until which",
                             drone.place);
    error.location.record = drone.index;
    return error;
  }

  void count_takeoff(const Trajectory& trajectory) {
    const double takeoff_s = trajectory.takeoff_s.value_or(0.0);
    if (takeoff_s != 0.0) ++shifted_;
    first_takeoff_s_ = std::min(first_takeoff_s_, takeoff_s);
    last_takeoff_s_ = std::max(last_takeoff_s_, takeoff_s);
  }

  [[nodiscard]] Error no_drones(const ShowValue& value) const {
    return show_error(ErrorCode::kNoPoints,
                      "the show has no drones (swarm.drones); export it again",
                      documents_.place_of(value));
  }

  // `name` is what it is called where it does not say so; and becomes what it says.
  Result<Drone> read_drone(const ShowValue& element, std::uint64_t index, std::string& name) {
    Drone drone;
    auto value = documents_.resolve(element);
    if (!value) return value.error();
    auto settings = documents_.member(*value, "settings");
    if (!settings) return settings.error();
    if (!settings.value()) return no_trajectory(*value, index);
    const ShowValue& of_drone = *settings.value();
    name = name_of(of_drone, name);
    drone.name = name;
    if (auto error = json_twice(of_drone.element, {"name"})) {
      error->location.source = documents_.place_of(of_drone);
      return *std::move(error);
    }
    auto found = documents_.member(of_drone, "trajectory");
    if (!found) return found.error();
    if (!found.value()) return no_trajectory(of_drone, index);
    auto trajectory = read_trajectory(found.value()->element);
    if (!trajectory) {
      Error error = trajectory.error();
      error.message = "drone " + excerpt(drone.name) + ": " + error.message;
      error.location.source = documents_.place_of(*found.value());
      return error;
    }
    auto ground = read_ground(of_drone, drone.name);
    if (!ground) return ground.error();
    if (trajectory->path.pieces.empty()) drone.place = documents_.place_of(*found.value());
    drone.trajectory = *std::move(trajectory);
    drone.ground = *std::move(ground);
    drone.index = index;
    return drone;
  }

  [[nodiscard]] Error no_trajectory(const ShowValue& value, std::uint64_t index) const {
    return show_error(
        ErrorCode::kMissingColumn,
        "drone " + std::to_string(index + 1) + " has no settings.trajectory; export the show again",
        documents_.place_of(value));
  }

  static std::string name_of(const ShowValue& settings, const std::string& otherwise) {
    std::string_view name;
    const auto member = json_member(settings.element, "name");
    if (member && member->get(name) && !name.empty()) {
      return std::string(name);
    }
    return otherwise;
  }

  Result<Ground> read_ground(const ShowValue& settings, const std::string& drone) {
    Ground ground;
    for (const char* const key : {"home", "landAt"}) {
      auto value = documents_.member(settings, key);
      if (!value) return value.error();
      if (!value.value()) continue;
      Point point;
      if (!read_json(value.value()->element, point)) {
        Error error = json_point_problem(value.value()->element, key);
        error.message = "drone " + excerpt(drone) + ": " + error.message;
        error.location.source = documents_.place_of(*value.value());
        return error;
      }
      (key == std::string_view("home") ? ground.home : ground.land_at) = point;
    }
    return ground;
  }

  void note_ground() {
    if (shifted_ > 0) {
      assembly_.note("the times of the points of " + std::to_string(shifted_) +
                     (shifted_ == 1 ? " drone" : " drones") +
                     " count from takeoffTime, which is not 0" +
                     (first_takeoff_s_ < last_takeoff_s_ ? " and not the same for all" : "") +
                     ", as Skybrush plays them");
    }
    if (raised_) {
      assembly_.note("the ground is at z = " + exact(raised_m_) +
                     " m, where all drones start and land, as their home and landAt say");
    }
    if (stood_ > 0) assembly_.note(standing_note(stood_));
    if (grounded_ > 0) assembly_.note(grounded_note(grounded_));
  }

  ShowDocuments& documents_;
  RecordingAssembly& assembly_;
  std::vector<Drone> drones_;
  bool raised_ = false;    // the ground is higher than kHighestShowGround_m:
  double raised_m_ = 0.0;  // so high
  std::uint64_t stood_ = 0;
  std::uint64_t grounded_ = 0;
  std::uint64_t shifted_ = 0;  // by takeoffTime
  double first_takeoff_s_ = std::numeric_limits<double>::infinity();
  double last_takeoff_s_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

bool is_show(const ShowDocuments& documents) {
  return json_member(documents.root().element, "swarm").has_value();
}

std::optional<Error> read_show(ShowDocuments& documents, RecordingAssembly& assembly) {
  return ShowReading(documents, assembly).read();
}

}  // namespace beespace::io
