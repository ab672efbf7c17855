// What obstacles of a file are called.
#pragma once

#include <beespace/obstacle.hpp>

#include <cstddef>
#include <string>

namespace beespace::io {

// "obstacles[2]".
std::string obstacle_number(std::size_t number);

// "obstacles[2], a box".
std::string obstacle_name(std::size_t number, const Obstacle& obstacle);

}  // namespace beespace::io
