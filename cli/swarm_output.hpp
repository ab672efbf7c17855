// A generated swarm as a file, in any format that detect reads.
#pragma once

#include "io/atomic_output.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::cli {

struct SwarmFormat {
  enum class Kind : std::uint8_t { kCsv, kTsv, kNpy, kRawFloat64 };

  Kind kind = Kind::kCsv;
  bool compressed = false;  // gzip
};

// By the ending of a file name, in capitals or not, or a format's own name: "bees.csv.gz", "npy".
std::optional<SwarmFormat> swarm_format(std::string_view name);

// Whether a file of this name may hold this format: its ending says the same, or nothing.
bool ending_allows(std::string_view name, SwarmFormat format);

enum class SwarmUnits : std::uint8_t { kMetres, kDegrees };

// Text in metres has all digits of the doubles; text in degrees has the course format's: 11
// decimals for degrees and 2 for metres. Commits the output. Errors: kWriteFailed.
Status write_swarm(const std::vector<Point>& points, SwarmUnits units, SwarmFormat format,
                   io::AtomicOutput& output);

}  // namespace beespace::cli
