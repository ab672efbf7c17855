// Bodies that motion capture followed: their coordinates beside each other, a line for each
// picture.
#pragma once

#include "io/recording/recording_assembly.hpp"
#include "io/tracks/long_records.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Where a body's coordinates are, in the order of x, y, z of the file.
struct BodyColumns {
  std::string name;
  std::array<std::size_t, 3> axes = {0, 0, 0};
  // What says with -1 that the body was not seen.
  std::optional<std::size_t> residual = {};
};

struct BodyTable {
  std::string_view program;  // "Motive (OptiTrack)"
  char delimiter = ',';
  std::string unit = {};  // of lengths: "mm"
  std::vector<BodyColumns> bodies = {};
  std::size_t columns = 0;
  std::size_t time = 0;                            // the column of seconds,
  std::optional<double> pictures_per_second = {};  // or of pictures, so many a second
  bool by_line = false;  // without a column of pictures: each line is the next one
  bool y_is_up = false;
  std::uint64_t lines_before = 0;
};

// Whether two of them have one name, or one has none.
bool has_unclear_names(const std::vector<BodyColumns>& bodies);

// A record for each body in each line of `rows`, which are those behind the header.
LongRecords body_records(std::string_view rows, const BodyTable& table);

// Times count from the beginning of each recording: beside other inputs, what to say.
std::optional<Error> own_beginning(const BodyTable& table, const RecordingAssembly& assembly);

}  // namespace beespace::io
