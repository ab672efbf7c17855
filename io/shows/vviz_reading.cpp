#include "io/shows/vviz_reading.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"
#include "io/recording/unit_doubts.hpp"
#include "io/shows/show_drones.hpp"
#include "io/units/units.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/point.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

Error vviz_error(ErrorCode code, std::string message) {
  return {code, std::move(message), {}};
}

// Sums of decimals keep the digits that they are written with.
double without_noise(double value) {
  constexpr double kSteps = 1e9;
  return std::round(value * kSteps) / kSteps;
}

class VvizReading {
 public:
  VvizReading(JsonElement root, RecordingAssembly& assembly) : root_(root), assembly_(assembly) {}

  std::optional<Error> read() {
    if (auto error = option_problem()) return error;
    if (auto error = read_head()) return error;
    SourceFacts facts;
    facts.frame = Frame::kMetres;
    facts.frame_reason = "a show as VVIZ counts lengths from a place of its own";
    facts.heights = HeightDatum::kHome;
    const bool said = unit_ != Unit::kUnstated;
    facts.units = {{"x, y and z", said ? unit_ : Unit::kMetre,
                    said ? UnitEvidence::kNamed : UnitEvidence::kUsual,
                    said ? "--units says so" : "no unit is named"}};
    if (!said) facts.doubted_above_mps = kFastestShow_mps;
    facts.description = "drone show, VVIZ";
    if (auto error = assembly_.agree(facts)) return error;
    assembly_.declare_show({});
    if (auto error = read_drones()) return error;
    assembly_.note("between samples drones are taken to fly in straight lines");
    if (const auto frame = json_member(root_, "globalReferenceFrame")) {
      assembly_.note(
          "the location of the show is not taken, as it does not say where x points; on a map it "
          "is shown by 'beespace export' with --origin" +
          origin_of(*frame));
    }
    drones_.note_ground(assembly_);
    return std::nullopt;
  }

 private:
  std::optional<Error> option_problem() {
    const RecordingOptions& options = assembly_.options();
    const auto invalid = [](std::string message) {
      return vviz_error(ErrorCode::kInvalidArgument, std::move(message));
    };
    if (options.frame == Frame::kWgs84 && !options.one_of_several) {
      return invalid("a show as VVIZ is in metres, but --crs wgs84 is given; leave it out");
    }
    if (!options.columns.empty() && !options.one_of_several) {
      return invalid("--columns is for text tables, but this is a show as VVIZ; leave it out");
    }
    UnitOverrides others = options.units;
    unit_ = std::exchange(others.position, Unit::kUnstated);
    if (others.any() && !options.one_of_several) {
      return invalid(
          "a show as VVIZ has positions alone; say their unit with --units position=ft, and leave "
          "other units out");
    }
    const bool timed = options.time_unit != Unit::kUnstated || options.frames_per_second;
    if (timed && !options.one_of_several) {
      return invalid("the times of VVIZ are in seconds; leave --time-unit and --fps out");
    }
    return std::nullopt;
  }

  std::optional<Error> read_head() {
    if (auto error = json_twice(
            root_, {"defaultPositionRate", "timeOffsetSecs", "performances", "coordinateFrame"})) {
      return error;
    }
    if (const auto frame = json_member(root_, "coordinateFrame")) {
      std::string_view name;
      if (!frame->get(name) || name != "ogl") {
        return vviz_error(ErrorCode::kUnsupportedFormat,
                          "coordinateFrame is not \"ogl\" (x to the right, y up, z forward), "
                          "which alone is read; export the show again");
      }
    }
    if (auto error = read_number(root_, "timeOffsetSecs", begins_s_)) return error;
    double rate = 0.0;
    if (auto error = read_number(root_, "defaultPositionRate", rate)) return error;
    if (rate < 0.0) {
      return vviz_error(ErrorCode::kMalformedRecord,
                        "defaultPositionRate is " + exact(rate) +
                            ", no number of samples a second; export the show again");
    }
    if (rate > 0.0) usual_step_s_ = 1.0 / rate;
    return std::nullopt;
  }

  // What to type where the show says of its place but the heading: " 19.06,47.48,110,90 if ...";
  // nothing where it does not.
  static std::string origin_of(JsonElement frame) {
    const auto first_of = [frame](std::initializer_list<const char*> keys) {
      std::optional<double> found;
      for (const char* const key : keys) {
        const auto member = json_member(frame, key);
        double number = 0.0;
        if (!found && member && read_json(*member, number)) found = number;
      }
      return found;
    };
    const auto longitude = first_of({"lon", "lng", "longitude"});
    const auto latitude = first_of({"lat", "latitude"});
    if (!longitude || !latitude) return {};
    const double height_m = first_of({"alt", "altitude"}).value_or(0.0);
    return " " + exact(*longitude) + "," + exact(*latitude) + "," + exact(height_m) +
           ",90 if x points east; otherwise with its degrees from north instead of 90";
  }

  // A number that may be missing, and is then left as it is.
  static std::optional<Error> read_number(JsonElement object, const char* key, double& number) {
    const auto member = json_member(object, key);
    if (!member || read_json(*member, number)) return std::nullopt;
    return json_number_problem(*member, key);
  }

  // One that must be there.
  static std::optional<Error> need_number(JsonElement object, const char* key, double& number) {
    if (json_member(object, key)) return read_number(object, key, number);
    return vviz_error(ErrorCode::kMissingColumn,
                      "there is no " + std::string(key) + "; export the show again");
  }

  std::optional<Error> read_drones() {
    JsonArray list;
    const auto performances = json_member(root_, "performances");
    if (!performances || !performances->get(list)) {
      return vviz_error(ErrorCode::kNoPoints, "the show has no performances; export it again");
    }
    begins_with_home_ = true;
    for (const JsonElement performance : list) {
      begins_with_home_ = begins_with_home_ && begins_with_home(performance);
    }
    std::uint64_t index = 0;
    for (const JsonElement performance : list) {
      const std::string name = name_of(performance, index);
      ShowDrone drone;
      drone.name = name;
      drone.place = assembly_.source_name();
      if (auto error = read_drone(performance, drone)) {
        error->message = "drone " + excerpt(name) + ": " + error->message;
        if (auto fatal = assembly_.bad(*std::move(error), name)) return fatal;
      } else {
        drones_.add(std::move(drone));
      }
      ++index;
    }
    if (index == 0) {
      return vviz_error(ErrorCode::kNoPoints, "the show has no performances; export it again");
    }
    if (auto error = drones_.keep(assembly_)) return error;
    if (drones_.grounded() == index) {
      return vviz_error(ErrorCode::kNoPoints, std::string(kNoDroneFlies));
    }
    return std::nullopt;
  }

  // Whether the first sample says no more than home: nothing has moved, in no time.
  static bool begins_with_home(JsonElement performance) {
    const auto agent = json_member(performance, "agentDescription");
    const auto traversal = agent ? json_member(*agent, "agentTraversal") : std::nullopt;
    JsonArray samples;
    if (!traversal || !traversal->get(samples)) return false;
    for (const JsonElement first : samples) {
      for (const char* const key : {"dx", "dy", "dz"}) {
        const auto by = json_member(first, key);
        double number = 1.0;
        if (!by || !read_json(*by, number) || number != 0.0) return false;
      }
      return !json_member(first, "dt");
    }
    return false;
  }

  static std::string name_of(JsonElement performance, std::uint64_t index) {
    const auto id = json_member(performance, "id");
    std::string_view text;
    std::int64_t number = 0;
    if (id && id->get(text) && !text.empty()) return std::string(text);
    if (id && id->get(number)) return "drone " + std::to_string(number);
    return "drone " + std::to_string(index + 1);
  }

  std::optional<Error> read_drone(JsonElement performance, ShowDrone& drone) const {
    const auto agent = json_member(performance, "agentDescription");
    if (!agent || !agent->is_object()) {
      return vviz_error(ErrorCode::kMissingColumn,
                        "there is no agentDescription; export the show again");
    }
    if (auto error = json_twice(*agent, {"homeX", "homeY", "homeZ", "agentTraversal"})) {
      return error;
    }
    std::array<double, 3> at = {};
    constexpr std::array<const char*, 3> kHome = {"homeX", "homeY", "homeZ"};
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      if (auto error = need_number(*agent, kHome[axis], at[axis])) return error;
    }
    JsonArray samples;
    const auto traversal = json_member(*agent, "agentTraversal");
    if (!traversal || !traversal->get(samples)) {
      return vviz_error(ErrorCode::kMissingColumn,
                        "there is no list agentTraversal; export the show again");
    }
    BezierPath& path = drone.trajectory.path;
    path.begins_s = begins_s_;
    path.begin = place_of(at);
    drone.ground.home = path.begin;
    std::uint64_t number = 0;
    double time_s = begins_s_;
    for (const JsonElement sample : samples) {
      if (number == 0 && begins_with_home_) {
        ++number;
        continue;
      }
      if (auto error = read_sample(sample, at, time_s, path)) {
        error->message = "agentTraversal[" + std::to_string(number) + "]: " + error->message;
        return error;
      }
      ++number;
    }
    return std::nullopt;
  }

  std::optional<Error> read_sample(JsonElement sample, std::array<double, 3>& at, double& time_s,
                                   BezierPath& path) const {
    constexpr std::array<const char*, 3> kMoves = {"dx", "dy", "dz"};
    if (auto error = json_twice(sample, {"dt", "dx", "dy", "dz"})) return error;
    double step_s = usual_step_s_;
    if (auto error = read_number(sample, "dt", step_s)) return error;
    bool moves = false;
    for (std::size_t axis = 0; axis < at.size(); ++axis) {
      double by = 0.0;
      if (auto error = need_number(sample, kMoves[axis], by)) return error;
      moves = moves || by != 0.0;
      at[axis] += by;
    }
    // The first sample may say again where it is at home.
    if (step_s == 0.0 && !moves && json_member(sample, "dt")) return std::nullopt;
    if (!(step_s > 0.0)) {
      return vviz_error(
          ErrorCode::kTimeOrder,
          json_member(sample, "dt")
              ? "dt is " + exact(step_s) + ", and no time in which it moves; correct it"
              : "there is no dt, and the show has no defaultPositionRate; export it "
                "again");
    }
    time_s += step_s;
    BezierPiece piece;
    piece.ends_s = without_noise(time_s);
    piece.end = place_of(at);
    path.pieces.push_back(piece);
    return std::nullopt;
  }

  // Of the axes of the file, y up and z forward, in metres.
  [[nodiscard]] Point place_of(const std::array<double, 3>& at) const {
    const Unit unit = unit_ == Unit::kUnstated ? Unit::kMetre : unit_;
    const auto metres = [unit](double value) { return in_metric(without_noise(value), unit); };
    return {metres(at[0]), metres(at[2]), metres(at[1])};
  }

  JsonElement root_;
  RecordingAssembly& assembly_;
  ShowDrones drones_;
  Unit unit_ = Unit::kUnstated;
  // Of all drones: who writes that means the beginning by it; where some do not, it is a sample as
  // any other.
  bool begins_with_home_ = false;
  double begins_s_ = 0.0;
  double usual_step_s_ = 0.0;
};

}  // namespace

bool is_vviz(JsonElement root) {
  JsonArray list;
  const auto performances = json_member(root, "performances");
  if (!performances || !performances->get(list)) return false;
  for (const JsonElement first : list) {
    return json_member(first, "agentDescription").has_value();
  }
  return true;
}

std::optional<Error> read_vviz(JsonElement root, RecordingAssembly& assembly) {
  return VvizReading(root, assembly).read();
}

}  // namespace beespace::io
