// The points of all cells, with their halos, on the disk.
//
// A batch of consecutive points is sorted by cell and written at once; a cell is then read from all
// batches, so its points are in ascending order of their ids.
#pragma once

#include "base/buffer.hpp"
#include "out_of_core/cut.hpp"
#include "out_of_core/stored_points.hpp"
#include "out_of_core/temporary_file.hpp"

#include <beespace/crew.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

// Some or all points of a cell and of its halo, ascending by id. Keeps its memory.
class CellPoints {
 public:
  // For so many points, with heights or without.
  void resize(std::size_t count, bool heights);
  // Gives its memory back.
  void release() { *this = CellPoints(); }

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] PointsView view() const;
  [[nodiscard]] std::uint64_t id(std::size_t index) const { return ids_[index] & ~kHaloFlag; }
  // Whether this cell is its home.
  [[nodiscard]] bool is_home(std::size_t index) const { return (ids_[index] & kHaloFlag) == 0; }

  // The memory of a point, besides what is read into it.
  static constexpr std::size_t bytes_a_point(bool heights) {
    return (heights ? 4 : 3) * sizeof(double) + sizeof(std::uint64_t);
  }

 private:
  friend class Cells;
  static constexpr std::uint64_t kHaloFlag = std::uint64_t{1} << 63U;

  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  bool heights_ = false;
  std::array<core::Buffer<double>, 4> columns_;  // x, y, z, and heights if there are any
  core::Buffer<std::uint64_t> ids_;
};

// Of one batch and one cell.
struct Segment {
  std::uint64_t offset = 0;
  std::uint64_t first_id = 0;  // of the batch
  std::uint64_t checksum = 0;
  std::uint32_t count = 0;
};

class Cells {
 public:
  // The bytes of a point on the disk: its coordinates, its height if it has one, and its place in
  // the batch.
  static constexpr std::size_t bytes_on_disk(bool heights) {
    return (heights ? 4 : 3) * sizeof(double) + sizeof(std::uint32_t);
  }
  // The memory that distributing takes for each point of a batch, halos included.
  static constexpr std::size_t bytes_a_batch_point(bool heights) { return heights ? 88 : 72; }

  // Of points that all have heights, or none.
  Cells(TemporaryFile file, Cut cut, bool heights)
      : heights_(heights),
        file_(std::move(file)),
        cut_(std::move(cut)),
        segments_(cut_.cells()),
        counts_(cut_.cells()) {}

  // Distributes all points, batch after batch of at most so many. Calls `done(points)` on the
  // calling thread. Errors: kNotFinite, kOutsideDomain; those of the files.
  Status distribute(const StoredPoints& points, std::size_t batch, Crew& crew,
                    const std::function<void(std::uint64_t)>& done);

  [[nodiscard]] std::size_t size() const { return segments_.size(); }
  [[nodiscard]] bool have_heights() const { return heights_; }
  // Where its home points are.
  [[nodiscard]] const Box& box(std::size_t cell) const { return cut_.boxes()[cell]; }
  // Points of a cell, its halo included; and those at home.
  [[nodiscard]] std::uint64_t count(std::size_t cell) const { return counts_[cell].all; }
  [[nodiscard]] std::uint64_t home_count(std::size_t cell) const { return counts_[cell].home; }
  [[nodiscard]] std::span<const Segment> segments(std::size_t cell) const {
    return segments_[cell];
  }

  // Reads consecutive segments of one cell. Errors: kReadFailed, kCorrupt.
  Status read(std::span<const Segment> segments, CellPoints& points) const;

 private:
  struct Counts {
    std::uint64_t all = 0;
    std::uint64_t home = 0;
  };
  class Sorter;

  bool heights_;
  TemporaryFile file_;
  Cut cut_;
  std::vector<std::vector<Segment>> segments_;  // of each cell, ascending by first_id
  std::vector<Counts> counts_;
};

}  // namespace beespace::out_of_core
