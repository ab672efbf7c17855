#include "io/shows/show_reading.hpp"

#include "io/problems/excerpt.hpp"
#include "io/shows/show_drones.hpp"
#include "io/shows/show_settings.hpp"
#include "io/shows/show_trajectory.hpp"

#include <cstdint>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

Error show_error(ErrorCode code, std::string message, std::string place) {
  return {code, std::move(message), {std::move(place)}};
}

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
    drones_.note_ground(assembly_);
    return std::nullopt;
  }

 private:
  std::optional<Error> option_problem() const {
    const RecordingOptions& options = assembly_.options();
    const auto invalid = [](std::string message) {
      return Error{ErrorCode::kInvalidArgument, std::move(message), {}};
    };
    if (options.frame == Frame::kWgs84 && !options.one_of_several) {
      return invalid("a Skybrush show is in metres, but --crs wgs84 is given; leave it out");
    }
    if (!options.columns.empty() && !options.one_of_several) {
      return invalid("--columns is for text tables, but this is a Skybrush show; leave it out");
    }
    if (options.units.any() && !options.one_of_several) {
      return invalid("the numbers of a Skybrush show have their units; leave --units out");
    }
    if (options.time_unit != Unit::kUnstated && !options.one_of_several) {
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
        if (auto fatal = assembly_.bad(drone.error(), name)) return fatal;
      } else {
        drones_.add(*std::move(drone));
      }
      ++index;
    }
    if (index == 0) return no_drones(*swarm.value());
    if (auto error = drones_.keep(assembly_)) return error;
    if (drones_.grounded() == index) {
      return show_error(ErrorCode::kNoPoints, std::string(kNoDroneFlies),
                        documents_.place_of(root));
    }
    return std::nullopt;
  }

  [[nodiscard]] Error no_drones(const ShowValue& value) const {
    return show_error(ErrorCode::kNoPoints,
                      "the show has no drones (swarm.drones); export it again",
                      documents_.place_of(value));
  }

  // `name` is what it is called where it does not say so; and becomes what it says.
  Result<ShowDrone> read_drone(const ShowValue& element, std::uint64_t index, std::string& name) {
    ShowDrone drone;
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

  ShowDocuments& documents_;
  RecordingAssembly& assembly_;
  ShowDrones drones_;
};

}  // namespace

bool is_show(const ShowDocuments& documents) {
  return json_member(documents.root().element, "swarm").has_value();
}

std::optional<Error> read_show(ShowDocuments& documents, RecordingAssembly& assembly) {
  return ShowReading(documents, assembly).read();
}

}  // namespace beespace::io
