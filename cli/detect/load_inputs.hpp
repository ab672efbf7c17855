// Reading what a detection is about: the swarm, and the others where there are some.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "cli/detect/detection.hpp"

#include "io/points/repeated_ids.hpp"
#include "io/units/heights.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// Errors: those of reading, and kUnsupportedFormat for a recording; kInvalidArgument where the two
// are in different frames, or the form of the answer needs another one.
Result<Inputs> load_inputs(const DetectRequest& request, ProgressBar& progress);

// For messages: "'bees.csv'", and "'bees.csv' was taken for metres (...)".
std::string quoted_source(const std::string& path);
std::string taken_for(const io::LoadedPoints& loaded, const std::string& path);

bool has_heights(const io::LoadedPoints& loaded);
// Never some by pressure and some by satellites.
bool can_compare(io::HeightDatum some, io::HeightDatum others);

// With --unique-ids.
Error repeated_error(const io::RepeatedIds& repeated, const std::string& path);

}  // namespace beespace::cli
