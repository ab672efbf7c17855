// From a file, or standard input, to obstacles: JSON, plain or gzip-compressed.
//
//   {"obstacles": [
//     {"kind": "sphere", "center": [x, y, z], "radius_m": r},
//     {"kind": "box", "low": [x, y, z], "high": [x, y, z]},
//     {"kind": "ground", "height_m": h},
//     {"kind": "cylinder", "center": [x, y], "radius_m": r, "low_m": l, "high_m": h},
//     {"kind": "prism", "outline": [[x, y], [x, y], ...], "low_m": l, "high_m": h}
//   ]}
//
// Cylinders and prisms are upright; without low_m or high_m they have no end there. Metres, z up.
#pragma once

#include <beespace/obstacle.hpp>
#include <beespace/result.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// `path` is a file name, or "-" for standard input. Whether they are obstacles at all, as a box
// whose low is below its high, is for ObstacleMap::of() to say.
//
// Errors carry the file, and name the obstacle ("obstacles[2].radius_m"); what is no JSON has line
// and column: kNoPoints for an empty file, kTruncated, kCorrupt, kUnsupportedFormat (an unknown
// kind or member), kMissingColumn, kMalformedRecord, kNotANumber, kColumnCount, kOutsideDomain.
Result<std::vector<Obstacle>> load_obstacles(const std::string& path);

// The same for bytes in memory (copied); `name` stands for the file.
Result<std::vector<Obstacle>> load_obstacles_from_memory(std::string_view content,
                                                         const std::string& name);

}  // namespace beespace::io
