// What a drone show says of itself beside its paths: how it may be flown, where, and its cues.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {

// A limit of acceleration, under its name: "maxAccelerationXY".
struct ShowAcceleration {
  enum class Direction { kAll, kHorizontal, kVertical, kNotKnown };

  std::string name;
  double most_mps2 = 0.0;
  Direction direction = Direction::kNotKnown;

  friend bool operator==(const ShowAcceleration&, const ShowAcceleration&) = default;
};

// Nothing where the show does not say.
struct ShowLimits {
  std::optional<double> horizontal_mps;  // the greatest horizontal speed
  std::optional<double> climb_mps;       // and upwards
  std::optional<double> descent_mps;     // and downwards
  std::optional<double> height_m;        // above z = 0
  std::vector<ShowAcceleration> accelerations = {};
  // Below which drones do not move sideways, under its name: "minNavAltitude".
  std::vector<std::pair<std::string, double>> navigation_m = {};
  std::vector<std::string> not_looked_at = {};  // names of others

  [[nodiscard]] bool any() const { return horizontal_mps || climb_mps || descent_mps || height_m; }
};

// Where on the Earth x = y = z = 0 lies, and where axes point.
struct ShowPlace {
  double longitude_deg = 0.0;
  double latitude_deg = 0.0;
  std::optional<double> height_m = {};  // above mean sea level
  double heading_deg = 0.0;             // of the x axis, clockwise from true north
  bool y_to_the_right = false;          // of x, seen from above; otherwise to its left

  friend bool operator==(const ShowPlace&, const ShowPlace&) = default;
};

struct ShowCue {
  double time_s = 0.0;
  std::string name = {};
};

// Shows count heights from the ground: one of which all is higher than this is no whole show,
// unless it says that all drones start and land there. Its ground is at 0, and who hovers still at
// its lowest height flies.
inline constexpr double kHighestShowGround_m = 1.0;

struct ShowFacts {
  ShowLimits limits = {};
  std::optional<ShowPlace> place = {};
  std::vector<ShowCue> cues = {};  // in the order of the show
  // The height of the lowest place of the show; higher than kHighestShowGround_m where all drones
  // are said to start and to land there.
  std::optional<double> ground_m = {};
};

}  // namespace beespace::io
