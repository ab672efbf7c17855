// What bees are called in a picture, where there is little room: long names that begin or end
// alike, as those of files of one flight, or of topics, are told by what differs.
#pragma once

#include "report/facts.hpp"

#include <beespace/point.hpp>

#include <string>

namespace beespace::report {

// "…vehicle1" of "2026-09-21 16-13-20 vehicle1", beside "2026-09-21 16-13-20 vehicle2".
std::string picture_name(const Names& names, PointId bee);

}  // namespace beespace::report
