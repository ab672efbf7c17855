// Whether what `detect` is to take for a snapshot is a recording, in which every fix would count as
// a bee of its own.
#pragma once

#include "io/points/load_options.hpp"
#include "io/points/loaded_points.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace beespace::analysis {

// Whether the code says that the data makes no sense: neither what was asked, nor the system.
bool is_about_data(ErrorCode code);

// Sees a table in parts, perhaps of several files, and finds the first bee that is there at more
// than one time, or a file of several times that tells no bees apart.
class RecordingCheck {
 public:
  // Of no more bees than these it keeps the time: the first ones, so that a recording of more bees
  // is told when one of these comes again.
  RecordingCheck(std::size_t most_bees, const io::LoadOptions& options);

  void add(const io::LoadedPoints& loaded);

  // kUnsupportedFormat where a table has a column of times, as `replay` knows them, and an id of it
  // is there at more than one. Without names of columns that cannot be told.
  [[nodiscard]] std::optional<Error> problem(const std::string& path) const;

  // The same once all of a file was added, after which the next one begins; and where three records
  // or more are not all of one time and there is no id, or each comes once and is no address of an
  // aircraft, nor said by the caller to be the id, which no other column contradicts: then it may
  // number the records.
  std::optional<Error> problem_of_file(const std::string& path);

 private:
  // Of the file that is being added.
  struct File {
    std::string id_name = {};  // of its column; empty where there is none
    std::size_t id_number = 0;
    std::uint64_t records = 0;
    std::string first_time = {};
    std::string other_time = {};
    bool repeats_ids = false;
    std::string other_id = {};  // a column that has one value at several times, and which
  };

  void add(const std::string& id, const std::string& time);
  void count(const std::string& time);
  void look_at_others(const io::LoadedPoints& loaded, const std::vector<std::size_t>& times,
                      const std::vector<std::size_t>& ids);

  std::size_t most_bees_;
  bool id_is_said_;
  std::unordered_map<std::string, std::string> first_times_;
  std::optional<std::string> problem_;
  File file_;
};

// The same of a whole table, read with these options.
std::optional<Error> recording_problem(const io::LoadedPoints& loaded, const std::string& path,
                                       const io::LoadOptions& options);

// Whether a table has a column of times, and records of more than one.
bool has_several_times(const io::LoadedPoints& loaded);

// Why `path` could not be read as a snapshot: `error`, or that it is one of the recordings that are
// no tables.
Error or_recording(Error error, const std::string& path, const io::LoadOptions& options);

}  // namespace beespace::analysis
