// The caller's beespace_io_options as those of the readers.
#pragma once

#include "io/points/load_options.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/stated_length.hpp"

#include <beespace_io.h>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::c_io {

// Errors: kInvalidArgument; also of options that the other kind of input alone has.
Result<io::LoadOptions> points_options(const beespace_io_options* options);
Result<io::RecordingOptions> recording_options(const beespace_io_options* options);
// How closely straight lines follow the curves of a show, in metres.
Result<double> tolerance_of(const beespace_io_options* options);

// The path as the readers take it, to whom "-" means standard input.
Result<std::string> path_of(const char* path, const char* name = "path");

// Those that are read as one input. Errors: kInvalidArgument, with the index of the path.
Result<std::vector<std::string>> paths_of(const char* const* paths, std::int64_t count);

// A vertical threshold; nothing of an empty text, or NULL. Errors: kInvalidArgument, about `place`.
Result<std::optional<io::StatedLength>> vertical_of(const char* text, const char* place);

// Below which height above where they took off two are left out: 0, or above. Errors:
// kInvalidArgument, about `place`.
Status check_ignore_below(double metres, const char* place);

// How many threads the library is to take: 0 of C is one, and 0 of the library is all.
unsigned threads_of(std::uint32_t threads);

}  // namespace beespace::c_io
