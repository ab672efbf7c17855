// What the bees of a recording are called.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/point.hpp>

#include <string>

namespace beespace::analysis {

// A bee's id, and what it is called beside it, as a flight is; or nothing.
struct BeeName {
  std::string id;
  std::string label;
};

// "a1b2c3 (UAL123)".
std::string text_of(const BeeName& name);

BeeName name_of(PointId bee, const io::Recording& recording);
// The same at that time: an aircraft may be several flights one after the other.
BeeName name_at(double time_s, PointId bee, const io::Recording& recording);

// Whether any bee has a label.
bool has_labels(const io::Recording& recording);

}  // namespace beespace::analysis
