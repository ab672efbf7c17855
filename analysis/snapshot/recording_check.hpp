// Whether what `detect` is to take for a snapshot is a recording, in which every fix would count as
// a bee of its own.
#pragma once

#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <unordered_map>

namespace beespace::analysis {

// Whether the code says that the data makes no sense: neither what was asked, nor the system.
bool is_about_data(ErrorCode code);

// Sees a table in parts, perhaps of several files, and finds the first bee that is there at more
// than one time.
class RecordingCheck {
 public:
  // Of no more bees than these it keeps the time: the first ones, so that a recording of more bees
  // is told when one of these comes again.
  explicit RecordingCheck(std::size_t most_bees) : most_bees_(most_bees) {}

  void add(const io::LoadedPoints& loaded);

  // kUnsupportedFormat where a table has a time column, and an id of it is there at more than one
  // time. Without names of columns that cannot be told.
  [[nodiscard]] std::optional<Error> problem(const std::string& path) const;

 private:
  void add(const std::string& id, const std::string& time);

  std::size_t most_bees_;
  std::unordered_map<std::string, std::string> first_times_;
  std::optional<std::string> problem_;
};

// The same of a whole table.
std::optional<Error> recording_problem(const io::LoadedPoints& loaded, const std::string& path);

// Whether a table has a time column, and records of more than one time.
bool has_several_times(const io::LoadedPoints& loaded);

// Why `path` could not be read as a snapshot: `error`, or that it is one of the recordings that are
// no tables.
Error or_recording(Error error, const std::string& path, const io::LoadOptions& options);

}  // namespace beespace::analysis
