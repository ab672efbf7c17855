// All points of a search, piece by piece: in the caller's memory, or on the disk.
#pragma once

#include "out_of_core/temporary_file.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::out_of_core {

// Consecutive points, as many as are worked on at a time.
struct Stretch {
  std::size_t piece = 0;
  std::size_t begin = 0;  // in the piece
  std::size_t count = 0;
  std::uint64_t first_id = 0;
};

// Points, and as many heights, or none.
struct PointMemory {
  std::vector<Point> points;
  std::vector<double> heights;
};

class StoredPoints {
 public:
  [[nodiscard]] std::uint64_t size() const { return size_; }
  // Whether each has a height apart from its position; where there are points.
  [[nodiscard]] bool have_heights() const { return have_heights_; }
  [[nodiscard]] std::uint64_t bytes_on_disk() const { return bytes_on_disk_; }

  // The points must outlive this, and have heights where those before have. Errors: as copy().
  Status refer(const PointsView& points);
  // Copies them, which are valid and have heights where those before have, to a temporary file in
  // the folder, so many at a time. Errors: as TemporaryFile; then none was added.
  Status copy(const PointsView& points, const std::string& folder, std::size_t at_a_time);
  // Writes what still waits in memory.
  Status flush();

  // All points in stretches of at most so many.
  [[nodiscard]] std::vector<Stretch> stretches(std::size_t most) const;

  // A view of a stretch; of points on the disk in `memory`, which they are read into. Any number of
  // threads.
  Result<PointsView> view(const Stretch& stretch, PointMemory& memory) const;

  // The positions of about so many points, evenly spread over all; without those outside the
  // domain. Errors: as view().
  Result<std::vector<Point>> sample(std::size_t count) const;

 private:
  struct Piece {
    PointsView points = {};        // where they are in memory
    std::uint64_t offset = 0;      // where they are on the disk: as Point
    std::uint64_t heights_at = 0;  // where their heights are there, if they have any
    std::uint64_t checksum = 0;    // of those
    std::size_t count = 0;
    bool on_disk = false;
  };

  std::vector<Piece> pieces_;
  PointMemory waiting_;  // the last ones that were copied, not on the disk yet
  std::optional<TemporaryFile> file_;
  std::uint64_t size_ = 0;
  std::uint64_t bytes_on_disk_ = 0;
  bool have_heights_ = false;
};

// The points [begin, begin + count) of a view, with their heights if they have any.
PointsView part_of(const PointsView& points, std::size_t begin, std::size_t count);

}  // namespace beespace::out_of_core
