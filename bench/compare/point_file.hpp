// The format in which the programs of the comparison pass points: a file of doubles x0 y0 z0 x1 ...
//
// Both end the process with a message when the file cannot be read or written.
#pragma once

#include <beespace/point.hpp>

#include <string>
#include <vector>

namespace beespace::compare {

std::vector<Point> read_points(const std::string& path);
void write_points(const std::string& path, const std::vector<Point>& points);

}  // namespace beespace::compare
