// Velocities that are in a table of points, and are not read: points have none.
#pragma once

#include "io/points/loaded_points.hpp"

#include <string>

namespace beespace::c_io {

// What is to be said of them; nothing where the header names no velocity.
std::string left_out_velocities(const io::LoadedPoints& loaded);

}  // namespace beespace::c_io
