#include "report/map/map_obstacles.hpp"

#include "io/obstacle_name.hpp"
#include "report/map/map_places.hpp"
#include "report/map/map_tracks.hpp"
#include "report/number_label.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>
#include <variant>

namespace beespace::report {
namespace {

// So many corners stand for a circle.
constexpr std::size_t kRound = 48;
constexpr double kThinnest_m = 0.1;
// What has no end reaches so far beyond its other end, and beyond where bees fly.
constexpr double kOpenEnd_m = 10.0;

// Of where bees fly; that of no bee is upside down.
struct FlownHeights {
  double low_m = HUGE_VAL;
  double high_m = -HUGE_VAL;

  void add(const Point& place) {
    low_m = std::min(low_m, place.z);
    high_m = std::max(high_m, place.z);
  }
};

FlownHeights flown_heights(const SnapshotFacts& facts) {
  FlownHeights flown;
  for (const Point& place : facts.positions) flown.add(place);
  return flown;
}

FlownHeights flown_heights(const RecordingFacts& facts) {
  FlownHeights flown;
  for (const Track& track : facts.tracks) {
    for (const Fix& fix : track.fixes) flown.add(fix.position);
  }
  return flown;
}

std::string metres(double value) {
  return decimal_label(value, value == std::round(value) ? 0 : 1) + " m";
}

std::string height_words(const Heights& heights) {
  const bool has_low = std::isfinite(heights.low_m);
  const bool has_high = std::isfinite(heights.high_m);
  if (has_low && has_high) return metres(heights.low_m) + " to " + metres(heights.high_m) + " high";
  if (has_low) return "from " + metres(heights.low_m) + " upwards, with no upper end";
  if (has_high) return "up to " + metres(heights.high_m) + ", with no lower end";
  return "at all heights";
}

std::vector<Corner> rectangle(const Box& box) {
  const auto widened = [](double low, double high) {
    const double more = std::max(0.0, 0.5 * (kThinnest_m - (high - low)));
    return std::pair(low - more, high + more);
  };
  const auto [west, east] = widened(box.low.x, box.high.x);
  const auto [south, north] = widened(box.low.y, box.high.y);
  return {{west, south}, {east, south}, {east, north}, {west, north}};
}

// Its sides touch the circle.
std::vector<Corner> around_circle(double x, double y, double radius_m) {
  const double angle = 2.0 * std::numbers::pi / static_cast<double>(kRound);
  const double reach_m = std::max(radius_m, 0.5 * kThinnest_m) / std::cos(0.5 * angle);
  std::vector<Corner> corners;
  corners.reserve(kRound);
  for (std::size_t i = 0; i < kRound; ++i) {
    const double at = angle * static_cast<double>(i);
    corners.push_back({x + reach_m * std::cos(at), y + reach_m * std::sin(at)});
  }
  return corners;
}

std::vector<Corner> once_around(std::vector<Corner> outline) {
  const Corner& first = outline.front();
  const Corner& last = outline.back();
  if (first.x == last.x && first.y == last.y) outline.pop_back();
  return outline;
}

class Drawing {
 public:
  Drawing(const SwarmFacts& swarm, FlownHeights flown)
      : axes_(*swarm.placed), places_(swarm), flown_(flown) {}

  [[nodiscard]] MapObstacle draw(std::size_t number, const Obstacle& obstacle) const {
    MapObstacle drawn =
        std::visit([this](const auto& solid) { return draw_solid(solid); }, obstacle);
    drawn.name = io::obstacle_name(number, obstacle);
    return drawn;
  }

 private:
  [[nodiscard]] MapObstacle draw_solid(const Sphere& sphere) const {
    const Point& c = sphere.center;
    const double r = sphere.radius_m;
    MapObstacle drawn = upright("sphere", around_circle(c.x, c.y, r), {c.z - r, c.z + r});
    drawn.round = RoundShape{places_.of(axes_(c)), r, true};
    drawn.words = "radius " + metres(r) + ", " + drawn.words;
    return drawn;
  }
  [[nodiscard]] MapObstacle draw_solid(const Box& box) const {
    return upright("box", rectangle(box), {box.low.z, box.high.z});
  }
  [[nodiscard]] MapObstacle draw_solid(const beespace::Ground&) const { return {}; }
  [[nodiscard]] MapObstacle draw_solid(const UprightCylinder& cylinder) const {
    MapObstacle drawn = upright(
        "cylinder", around_circle(cylinder.x, cylinder.y, cylinder.radius_m), cylinder.heights);
    GeographicPosition middle = places_.of(axes_({cylinder.x, cylinder.y, 0.0}));
    middle.height_m = 0.5 * (drawn.low_m + drawn.high_m);
    drawn.round = RoundShape{middle, cylinder.radius_m, false};
    drawn.words = "radius " + metres(cylinder.radius_m) + ", " + drawn.words;
    return drawn;
  }
  [[nodiscard]] MapObstacle draw_solid(const UprightPrism& prism) const {
    return upright("prism", once_around(prism.outline), prism.heights);
  }

  [[nodiscard]] MapObstacle upright(const char* shape, const std::vector<Corner>& outline,
                                    const Heights& given) const {
    MapObstacle drawn;
    drawn.shape = shape;
    drawn.heights = {rounded_height(given.low_m), rounded_height(given.high_m)};
    drawn.words = height_words(drawn.heights);
    std::tie(drawn.low_m, drawn.high_m) = ends_of(drawn.heights);
    drawn.outline.reserve(outline.size());
    for (const Corner& corner : outline) {
      drawn.outline.push_back(places_.of(axes_({corner.x, corner.y, 0.0})));
      drawn.outline.back().height_m = drawn.low_m;
    }
    if (is_clockwise(outline) != axes_.mirrors()) {
      std::reverse(drawn.outline.begin(), drawn.outline.end());
    }
    return drawn;
  }

  [[nodiscard]] double rounded_height(double z) const {
    return std::isfinite(z) ? places_.of({0.0, 0.0, axes_.height_of(z)}).height_m : z;
  }

  // Where it is drawn to.
  [[nodiscard]] std::pair<double, double> ends_of(const Heights& heights) const {
    const bool has_low = std::isfinite(heights.low_m);
    const bool has_high = std::isfinite(heights.high_m);
    if (!has_low && !has_high && flown_.low_m > flown_.high_m) return {-kOpenEnd_m, kOpenEnd_m};
    const double low_m =
        has_low ? heights.low_m
                : std::min(flown_.low_m, has_high ? heights.high_m : HUGE_VAL) - kOpenEnd_m;
    const double high_m = has_high ? heights.high_m : std::max(flown_.high_m, low_m) + kOpenEnd_m;
    return {low_m, high_m};
  }

  static bool is_clockwise(const std::vector<Corner>& outline) {
    double doubled_area = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Corner& a = outline[i];
      const Corner& b = outline[(i + 1) % outline.size()];
      const Corner& origin = outline.front();
      doubled_area += (a.x - origin.x) * (b.y - origin.y) - (b.x - origin.x) * (a.y - origin.y);
    }
    return doubled_area < 0.0;
  }

  PlacementAxes axes_;
  MapPlaces places_;
  FlownHeights flown_;
};

template <class Facts>
MapObstacles drawn_obstacles(const Facts& facts) {
  MapObstacles map;
  const std::vector<Obstacle>& all = facts.swarm.obstacles;
  if (all.empty()) return map;
  const Drawing drawing(facts.swarm, flown_heights(facts));
  const std::size_t count = marks_shown(all.size(), "obstacles", map.notes);
  for (std::size_t i = 0; i < count; ++i) {
    if (std::holds_alternative<beespace::Ground>(all[i])) {
      map.notes.push_back(io::obstacle_name(i, all[i]) + ", is everywhere, and is not drawn");
    } else {
      map.obstacles.push_back(drawing.draw(i, all[i]));
    }
  }
  return map;
}

}  // namespace

MapObstacles map_obstacles(const SnapshotFacts& facts) {
  return drawn_obstacles(facts);
}

MapObstacles map_obstacles(const RecordingFacts& facts) {
  return drawn_obstacles(facts);
}

}  // namespace beespace::report
