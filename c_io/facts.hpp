// What is behind beespace_io_facts: what an input was taken for, as texts.
#pragma once

#include "io/points/loaded_points.hpp"
#include "io/recording/recording.hpp"

#include <beespace_io.h>
#include <beespace/result.hpp>

#include <cstdint>
#include <string>
#include <vector>

// NOLINTNEXTLINE(readability-identifier-naming): a name of C
struct beespace_io_facts {
  std::string frame;
  std::string frame_reason;
  std::string format;
  std::string heights;
  std::vector<std::string> notes;
  std::vector<beespace::Error> skipped;  // the first of them
  std::int64_t skipped_count = 0;
};

namespace beespace::c_io {

beespace_io_facts facts_of(const io::LoadedPoints& loaded);
beespace_io_facts facts_of(const io::Recording& recording);

}  // namespace beespace::c_io
