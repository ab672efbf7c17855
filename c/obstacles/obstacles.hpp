// What is behind beespace_obstacles: a map that copies share, so that what is made with it may keep
// one.
#pragma once

#include <beespace.h>
#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <cstdint>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_obstacles {
  beespace::ObstacleMap map;
};

namespace beespace::c {

Result<ObstacleMap> map_of(const beespace_obstacle* obstacles, std::int64_t count);

}  // namespace beespace::c
