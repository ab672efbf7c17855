// The files of a search with --memory, read a block after the other.
#pragma once

#include "analysis/geometry/ground_places.hpp"
#include "analysis/snapshot/recording_check.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/detect/detection.hpp"
#include "cli/detect/out_of_core/text_store.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/stream_points.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// One of the files.
struct LargeFile {
  std::string path;
  io::LoadedPoints facts = {};  // without points and records
  std::string header = {};      // of a table; empty where there is none
  char delimiter = ',';
  bool is_table = false;
  bool own_ids = false;
  bool in_place = false;          // its points are searched where they are
  std::uint64_t first_point = 0;  // their ids go on from file to file
  std::uint64_t points = 0;
  std::optional<io::InputFile::State> state = {};
  std::optional<io::PointStream> stream = {};  // as long as it is needed
};

// Where a point is, and what a vertical threshold compares of it: its place on the ground and its
// height, or the same place and its z.
struct LargePlace {
  Point place;
  Point ground;
  double height = 0.0;
};

// Where points and what is to be known of them go.
struct LargeInputSinks {
  OutOfCore& search;
  TextStore* ids;      // null: not wanted, as these
  TextStore* records;  // as they stand
  TextStore* places;   // as the bytes of LargePlace
};

class LargeInput {
 public:
  // The request must outlive it. Errors: those of PointStream; kInvalidArgument for files that
  // cannot be taken together.
  static Result<LargeInput> open(const DetectRequest& request, std::size_t block_bytes);

  [[nodiscard]] const std::vector<LargeFile>& files() const { return files_; }
  [[nodiscard]] const LargeFile& front() const { return files_.front(); }
  // What the ids of the answer are: those of the files, or the numbers of their rows.
  [[nodiscard]] bool own_ids() const { return front().own_ids; }
  // Of all heights; where files differ in it they are compared in metres.
  [[nodiscard]] io::Unit height_unit() const;

  // Whether the search is asked about positions at height 0, with heights apart from them.
  [[nodiscard]] bool heights_are_apart() const;

  // Bad records that were left out, of all files; rows are counted on from file to file.
  [[nodiscard]] const io::SkippedRecords& skipped() const { return skipped_; }

  // Errors: kWriteFailed where the folder surely has too little room.
  [[nodiscard]] Status check_room(const std::string& folder, bool records) const;

  // All points, once. Errors: those of reading, and of `sinks`; kUnsupportedFormat for a recording.
  Status read(const LargeInputSinks& sinks, ProgressBar& bar);

  // An error about a point, with the place that it came from.
  [[nodiscard]] Error placed(Error error) const;
  // Errors: kReadFailed where a file was written to while its points were searched in it.
  [[nodiscard]] Status check_unchanged() const;

 private:
  LargeInput(const DetectRequest& request, std::size_t block_bytes)
      : request_(&request), block_bytes_(block_bytes), recording_(kBeesToWatch, request.load) {}

  Result<LargeFile> open_file(const std::string& path) const;
  [[nodiscard]] std::optional<Error> mix_problem(const LargeFile& file) const;
  // What was left out of a block.
  Status skip(LargeFile& file, std::uint64_t row, io::LoadedPoints& block);
  static void add_places(const std::vector<Point>& points, const analysis::GroundPlaces& places,
                         TextStore& store);
  Status read_file(LargeFile& file, const LargeInputSinks& sinks, io::Progress& progress);

  const DetectRequest* request_;
  std::size_t block_bytes_;
  std::vector<LargeFile> files_;
  std::vector<std::optional<std::uint64_t>> likely_sizes_;  // of each
  std::uint64_t rows_before_ = 0;                           // of files that were read
  io::SkippedRecords skipped_;
  analysis::RecordingCheck recording_;

  // Some megabytes of names.
  static constexpr std::size_t kBeesToWatch = std::size_t{1} << 14U;
};

}  // namespace beespace::cli
