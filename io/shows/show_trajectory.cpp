#include "io/shows/show_trajectory.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {
namespace {

constexpr double kGroundTolerance_m = 0.1;

Error malformed(ErrorCode code, std::string message) {
  return {code, std::move(message), {}};
}

struct Entry {
  double time_s = 0.0;
  Point point = {};
  std::array<Point, 2> controls = {};
  std::uint8_t control_count = 0;
};

std::optional<Error> read_controls(JsonElement element, const std::string& path, Entry& entry) {
  JsonArray controls;
  if (!element.get(controls)) {
    return malformed(ErrorCode::kMalformedRecord,
                     path + " is " + std::string(json_kind(element)) +
                         " where the control points should be; write [] for a straight line");
  }
  for (const JsonElement control : controls) {
    if (entry.control_count == 2) {
      return malformed(ErrorCode::kUnsupportedFormat,
                       path + " has " + std::to_string(controls.size()) +
                           " control points; up to two are read (cubic curves), export the show "
                           "with such");
    }
    if (!read_json(control, entry.controls[entry.control_count])) {
      return json_point_problem(control,
                                path + "[" + std::to_string(int{entry.control_count}) + "]");
    }
    ++entry.control_count;
  }
  return std::nullopt;
}

// [t, [x, y, z], [controls]], where the last may be missing.
std::optional<Error> read_entry(JsonElement element, std::size_t index, Entry& entry) {
  const auto path = [index](std::string_view part) {
    return "points[" + std::to_string(index) + "]" + std::string(part);
  };
  JsonArray parts;
  if (!element.get(parts) || parts.size() < 2 || parts.size() > 3) {
    return malformed(ErrorCode::kMalformedRecord,
                     path("") + " is no [time, [x, y, z], [control points]]; correct it");
  }
  int part = 0;
  for (const JsonElement item : parts) {
    if (part == 0 && !read_json(item, entry.time_s)) return json_number_problem(item, path("[0]"));
    if (part == 1 && !read_json(item, entry.point)) return json_point_problem(item, path("[1]"));
    if (part == 2) {
      JsonArray controls;
      const bool none = item.get(controls) && controls.size() == 0;
      if (!none) {
        if (auto error = read_controls(item, path("[2]"), entry)) return error;
      }
    }
    ++part;
  }
  return std::nullopt;
}

// Their times count from take-off, as Skybrush's own player has it.
std::optional<Error> read_points(JsonElement points, double takeoff_s, BezierPath& path) {
  JsonArray entries;
  if (!points.get(entries)) {
    return malformed(ErrorCode::kMalformedRecord, "points is " + std::string(json_kind(points)) +
                                                      " where an array should be; correct it");
  }
  std::size_t index = 0;
  double before_s = 0.0;
  for (const JsonElement element : entries) {
    Entry entry;
    if (auto error = read_entry(element, index, entry)) return error;
    entry.time_s += takeoff_s;
    if (!std::isfinite(entry.time_s)) {
      return malformed(ErrorCode::kNotFinite,
                       "takeoffTime and the time of points[" + std::to_string(index) +
                           "] are together too large; correct the trajectory");
    }
    if (index == 0) {
      if (entry.control_count > 0) {
        return malformed(ErrorCode::kMalformedRecord,
                         "points[0] lists control points, but no piece ends there; remove them");
      }
      path.begins_s = entry.time_s;
      path.begin = entry.point;
    } else if (!(entry.time_s > before_s)) {
      return malformed(ErrorCode::kTimeOrder,
                       "the time of points[" + std::to_string(index) +
                           "] does not come after the one before it; correct the trajectory");
    } else {
      path.pieces.push_back({entry.time_s, entry.point, entry.controls, entry.control_count});
    }
    before_s = entry.time_s;
    ++index;
  }
  if (index == 0) return malformed(ErrorCode::kNoPoints, "points is empty; a path needs some");
  return std::nullopt;
}

std::optional<Error> read_optional_time(JsonElement trajectory, const char* key,
                                        std::optional<double>& time_s) {
  const auto found = json_member(trajectory, key);
  if (!found) return std::nullopt;
  double value = 0.0;
  if (!read_json(*found, value)) return json_number_problem(*found, key);
  time_s = value;
  return std::nullopt;
}

// Until take-off it is where its first point is.
void wait_for_takeoff(Trajectory& trajectory) {
  BezierPath& path = trajectory.path;
  const double waits_from_s = path.begins_s - trajectory.takeoff_s.value_or(0.0);
  if (path.pieces.empty() || !(waits_from_s < path.begins_s)) return;
  path.pieces.insert(path.pieces.begin(), BezierPiece{path.begins_s, path.begin, {}, 0});
  path.begins_s = waits_from_s;
}

const Point& start_of(const BezierPath& path, std::size_t piece) {
  return piece == 0 ? path.begin : path.pieces[piece - 1].end;
}

bool stands_still(const BezierPath& path, std::size_t index) {
  const BezierPiece& piece = path.pieces[index];
  const Point& start = start_of(path, index);
  bool still = piece.end == start;
  for (std::size_t i = 0; i < piece.control_count; ++i) {
    still = still && piece.controls[i] == start;
  }
  return still;
}

}  // namespace

Result<Trajectory> read_trajectory(JsonElement trajectory) {
  if (!trajectory.is_object()) {
    return malformed(ErrorCode::kMalformedRecord,
                     "the trajectory is " + std::string(json_kind(trajectory)) +
                         " where an object should be; export the show again");
  }
  if (auto error = json_twice(trajectory, {"version", "points", "takeoffTime", "landingTime"})) {
    return *std::move(error);
  }
  if (const auto version = json_member(trajectory, "version")) {
    double number = 0.0;
    if (!version->get(number) || number != 1.0) {
      return malformed(ErrorCode::kUnsupportedFormat,
                       "the trajectory is of another version; version 1 is read");
    }
  }
  const auto points = json_member(trajectory, "points");
  if (!points) {
    return malformed(ErrorCode::kMissingColumn,
                     "the trajectory has no 'points'; export the show again");
  }
  Trajectory read;
  if (auto error = read_optional_time(trajectory, "takeoffTime", read.takeoff_s)) {
    return *std::move(error);
  }
  if (auto error = read_points(*points, read.takeoff_s.value_or(0.0), read.path)) {
    return *std::move(error);
  }
  std::optional<double> landing_s;
  if (auto error = read_optional_time(trajectory, "landingTime", landing_s)) {
    return *std::move(error);
  }
  if (read.takeoff_s && landing_s && *landing_s < *read.takeoff_s) {
    return malformed(ErrorCode::kTimeOrder,
                     "landingTime comes before takeoffTime; correct the trajectory");
  }
  wait_for_takeoff(read);
  return read;
}

double lowest_of(const Trajectory& trajectory, const Ground& ground) {
  double lowest_m = trajectory.path.begin.z;
  for (const BezierPiece& piece : trajectory.path.pieces) {
    lowest_m = std::min(lowest_m, piece.end.z);
  }
  // Skybrush counts heights from the ground.
  lowest_m = std::min(lowest_m, ground.home ? ground.home->z : 0.0);
  return ground.land_at ? std::min(lowest_m, ground.land_at->z) : lowest_m;
}

bool starts_and_lands_at(const Trajectory& trajectory, const Ground& ground, double ground_m) {
  constexpr double kAtHome_m = 1.0;
  const BezierPath& path = trajectory.path;
  const Point& last = path.pieces.empty() ? path.begin : path.pieces.back().end;
  const auto is_at = [ground_m](const Point& place, const std::optional<Point>& said) {
    return said && std::abs(said->z - ground_m) <= kGroundTolerance_m &&
           std::abs(place.z - ground_m) <= kGroundTolerance_m &&
           std::hypot(place.x - said->x, place.y - said->y) <= kAtHome_m;
  };
  if (!is_at(path.begin, ground.home) || !is_at(last, ground.land_at)) return false;
  // Who stays at that height, or moves sideways at it, hovers there.
  constexpr double kTakesOff_m = 1.0;
  bool takes_off = false;
  Point from = path.begin;
  for (const BezierPiece& piece : path.pieces) {
    const bool low = std::max(from.z, piece.end.z) <= ground_m + kGroundTolerance_m;
    if (low && (from.x != piece.end.x || from.y != piece.end.y)) return false;
    takes_off = takes_off || piece.end.z >= ground_m + kTakesOff_m;
    from = piece.end;
  }
  return takes_off;
}

bool on_ground(double height_m, double ground_m) {
  return height_m - ground_m <= kGroundTolerance_m;
}

bool keep_flight(Trajectory& trajectory, double ground_m) {
  BezierPath& path = trajectory.path;
  double lowest_m = std::min(ground_m, path.begin.z);
  for (const BezierPiece& piece : path.pieces) {
    lowest_m = std::min(lowest_m, piece.end.z);
    for (std::size_t i = 0; i < piece.control_count; ++i) {
      lowest_m = std::min(lowest_m, piece.controls[i].z);
    }
  }
  const auto stands = [&](std::size_t piece) {
    return stands_still(path, piece) && on_ground(start_of(path, piece).z, lowest_m);
  };
  std::size_t first = 0;
  std::size_t behind = path.pieces.size();
  while (first < behind && stands(first)) ++first;
  while (first < behind && stands(behind - 1)) --behind;
  if (first == 0 && behind == path.pieces.size()) return false;

  const double begins_s = first == 0 ? path.begins_s : path.pieces[first - 1].ends_s;
  const Point begin = start_of(path, first);
  path.pieces.resize(behind);
  path.pieces.erase(path.pieces.begin(), path.pieces.begin() + static_cast<std::ptrdiff_t>(first));
  path.begins_s = begins_s;
  path.begin = begin;
  return true;
}

}  // namespace beespace::io
