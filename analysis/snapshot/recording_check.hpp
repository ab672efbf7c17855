// Whether what `detect` is to take for a snapshot is a recording, in which every fix would count as
// a bee of its own.
#pragma once

#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>

namespace beespace::analysis {

// Whether the code says that the data makes no sense: neither what was asked, nor the system.
bool is_about_data(ErrorCode code);

// kUnsupportedFormat where a table has a time column, and an id of it is there at more than one
// time. Without names of columns that cannot be told.
std::optional<Error> recording_problem(const io::LoadedPoints& loaded, const std::string& path);

// Whether a table has a time column, and records of more than one time.
bool has_several_times(const io::LoadedPoints& loaded);

// Why `path` could not be read as a snapshot: `error`, or that it is one of the recordings that are
// no tables.
Error or_recording(Error error, const std::string& path, const io::LoadOptions& options);

}  // namespace beespace::analysis
