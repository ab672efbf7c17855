// Rows of numbers, more than memory holds, in ascending order: sorted in runs, which wait in a
// temporary file and are merged.
#pragma once

#include "io/bytes/scratch_file.hpp"

#include <beespace/out_of_core.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {

// Of an answer: two points and how far apart they are, or a point and a number.
struct LargeRow {
  std::uint64_t first = 0;
  std::uint64_t second = 0;
  double distance_m = 0.0;

  friend bool operator<(const LargeRow& a, const LargeRow& b) {
    return a.first != b.first ? a.first < b.first : a.second < b.second;
  }
};

// The first error is kept, and all that comes later does nothing.
class SortedRows {
 public:
  SortedRows(std::string folder, std::size_t memory_bytes);

  void add(const LargeRow& row);
  [[nodiscard]] std::uint64_t size() const { return size_; }

  // All rows, by first, then second. Once, when all were added.
  void for_each(const std::function<void(const LargeRow&)>& visit);

  // Errors: those of ScratchFile.
  [[nodiscard]] const Status& status() const { return status_; }

 private:
  using Run = std::vector<io::ScratchFile::Block>;
  class Reading;

  void write_run();
  void merge(const std::function<void(const LargeRow&)>& visit);

  std::string folder_;
  std::size_t most_;      // rows in memory
  std::size_t in_block_;  // rows
  std::optional<io::ScratchFile> file_;
  std::vector<LargeRow> rows_;
  std::vector<Run> runs_;
  std::uint64_t size_ = 0;
  Status status_ = std::monostate{};
};

}  // namespace beespace::cli
