// Obstacles: the caller's structures as those of C++.
#include "c/obstacles/obstacles.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::c {

namespace {

// An obstacle as it is read: what was used is set to zero, so that what is left over shows.
class GivenObstacle {
 public:
  explicit GivenObstacle(const beespace_obstacle& given) : given_(given) {}

  Result<Obstacle> read() {
    Result<Obstacle> obstacle = by_kind();
    if (!obstacle) return obstacle;
    if (given_.flags != 0) {
      return invalid("flags ask for what this kind of obstacle has not", "obstacles");
    }
    if (is_anything_left()) {
      return invalid(
          "a field that this kind of obstacle has not is not zero; a height wants its flag, "
          "BEESPACE_LOWEST or BEESPACE_HIGHEST",
          "obstacles");
    }
    return obstacle;
  }

 private:
  Result<Obstacle> by_kind() {
    switch (given_.kind) {
      case BEESPACE_SPHERE:
        return Obstacle(Sphere{take_point(given_.center), take(given_.radius_m)});
      case BEESPACE_BOX:
        return Obstacle(Box{take_point(given_.low), take_point(given_.high)});
      case BEESPACE_GROUND:
        return Obstacle(Ground{take(given_.high[2])});
      case BEESPACE_CYLINDER:
        return Obstacle(UprightCylinder{take(given_.center[0]), take(given_.center[1]),
                                        take(given_.radius_m), take_heights()});
      case BEESPACE_PRISM:
        return take_prism();
      default:
        return invalid("the kind is none of BEESPACE_SPHERE to BEESPACE_PRISM", "obstacles");
    }
  }

  Result<Obstacle> take_prism() {
    const std::int64_t corners = std::exchange(given_.corners, 0);
    const double* const outline = std::exchange(given_.outline, nullptr);
    constexpr auto kMostCorners =
        static_cast<std::int64_t>(std::numeric_limits<std::uint32_t>::max());
    if (corners < 0 || corners > kMostCorners) {
      return invalid("the number of corners makes no sense", "obstacles");
    }
    if (corners > 0) {
      if (outline == nullptr) return invalid("the outline is NULL, but has corners", "obstacles");
      if (!is_aligned(outline)) {
        return invalid("the outline is not aligned as doubles are: copy it first", "obstacles");
      }
    }
    UprightPrism prism;
    prism.heights = take_heights();
    for (std::int64_t i = 0; i < corners; ++i) {
      prism.outline.push_back({outline[2 * i], outline[2 * i + 1]});
    }
    return Obstacle(std::move(prism));
  }

  static double take(double& number) { return std::exchange(number, 0.0); }
  static Point take_point(double (&numbers)[3]) {
    return {take(numbers[0]), take(numbers[1]), take(numbers[2])};
  }
  Heights take_heights() {
    Heights heights;
    if (take_flag(BEESPACE_LOWEST)) heights.low_m = take(given_.low[2]);
    if (take_flag(BEESPACE_HIGHEST)) heights.high_m = take(given_.high[2]);
    return heights;
  }
  bool take_flag(std::uint32_t flag) {
    const bool is_set = (given_.flags & flag) != 0;
    given_.flags &= ~flag;
    return is_set;
  }

  [[nodiscard]] bool is_anything_left() const {
    // A NaN is left, too: it is no zero.
    const auto is_zero = [](const double(&numbers)[3]) {
      return numbers[0] == 0.0 && numbers[1] == 0.0 && numbers[2] == 0.0;
    };
    return !is_zero(given_.center) || !is_zero(given_.low) || !is_zero(given_.high) ||
           given_.radius_m != 0.0 || given_.outline != nullptr || given_.corners != 0;
  }

  beespace_obstacle given_;
};

Error at_obstacle(Error error, std::size_t index) {
  error.location.record = index;
  return error;
}

}  // namespace

Result<ObstacleMap> map_of(const beespace_obstacle* obstacles, std::int64_t count) {
  if (count < 0) return invalid("count is below zero", "obstacles");
  if (count == 0) return ObstacleMap();
  if (obstacles == nullptr) return invalid("this is NULL, but there are obstacles", "obstacles");
  if (!is_aligned(obstacles)) {
    return invalid("the obstacles are not aligned as their type is: copy them first", "obstacles");
  }
  // All are of one version of the header, so the first one says how long each is.
  const Result<beespace_obstacle> first = read_struct(obstacles, "obstacles");
  if (!first) return at_obstacle(first.error(), 0);
  const std::size_t size = first->struct_size;
  constexpr auto kMostBytes =
      static_cast<std::uint64_t>(std::numeric_limits<std::ptrdiff_t>::max());
  if (size % alignof(beespace_obstacle) != 0 ||
      static_cast<std::uint64_t>(count) > kMostBytes / size) {
    return invalid("so many obstacles of this struct_size are beyond all memory", "obstacles");
  }
  const auto* const bytes = reinterpret_cast<const std::byte*>(obstacles);
  std::vector<Obstacle> all;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const auto* const next = reinterpret_cast<const beespace_obstacle*>(bytes + i * size);
    if (size_of_struct(next) != size) {
      return at_obstacle(invalid("struct_size differs from that of the first one", "obstacles"), i);
    }
    const Result<beespace_obstacle> given = read_struct(next, "obstacles");
    if (!given) return at_obstacle(given.error(), i);
    Result<Obstacle> obstacle = GivenObstacle(*given).read();
    if (!obstacle) return at_obstacle(std::move(obstacle).error(), i);
    all.push_back(*std::move(obstacle));
  }
  return ObstacleMap::of(std::move(all));
}

}  // namespace beespace::c

using beespace::ObstacleMap;
using beespace::Result;
using beespace::Status;

extern "C" {

beespace_code beespace_obstacles_create(const beespace_obstacle* obstacles, int64_t count,
                                        beespace_obstacles** made, beespace_error* error) {
  if (made != nullptr) *made = nullptr;
  return beespace::c::enter(error, [&]() -> Status {
    if (made == nullptr) return beespace::c::invalid("the pointer to the handle is NULL", "made");
    Result<ObstacleMap> map = beespace::c::map_of(obstacles, count);
    if (!map) return std::move(map).error();
    *made = std::make_unique<beespace_obstacles>(beespace_obstacles{*std::move(map)}).release();
    return std::monostate{};
  });
}

void beespace_obstacles_free(beespace_obstacles* obstacles) {
  delete obstacles;
}

int64_t beespace_obstacles_size(const beespace_obstacles* obstacles) {
  return obstacles == nullptr ? 0 : static_cast<int64_t>(obstacles->map.obstacles().size());
}

}  // extern "C"
