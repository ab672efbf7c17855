// From a file, or standard input, to points in metres.
//
// Reads text tables (the course format, x,y,z, any delimiter), .npy arrays and raw float64, each
// plain or gzip-compressed. The format is told by the content where the content says it.
#pragma once

#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace/result.hpp>

#include <string>
#include <string_view>

namespace beespace::io {

// `path` is a file name, or "-" for standard input. Errors carry file, line and column.
Result<LoadedPoints> load_points(const std::string& path, const LoadOptions& options = {});

// The same for bytes in memory (copied); `name` stands for the file in messages, and its ending
// tells raw float64 (".bin") as a file's does.
Result<LoadedPoints> load_points_from_memory(std::string_view content, const std::string& name,
                                             const LoadOptions& options = {});

}  // namespace beespace::io
