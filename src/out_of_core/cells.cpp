#include "out_of_core/cells.hpp"

#include "base/point_block.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "out_of_core/checksum.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

namespace beespace::out_of_core {

namespace {

constexpr std::uint32_t kHaloBit = std::uint32_t{1} << 31U;

// Of doubles, a point.
constexpr std::size_t columns_of(bool heights) {
  return heights ? 4 : 3;
}

template <class T>
std::span<const std::byte> bytes_of(const T* data, std::size_t count) {
  return std::as_bytes(std::span(data, count));
}

}  // namespace

void CellPoints::resize(std::size_t count, bool heights) {
  size_ = count;
  if (count <= capacity_ && heights == heights_) return;
  capacity_ = 0;
  heights_ = heights;
  for (auto& column : columns_) column = {};
  ids_ = {};
  for (std::size_t at = 0; at < columns_of(heights); ++at) {
    columns_[at] = core::Buffer<double>(count);
  }
  ids_ = core::Buffer<std::uint64_t>(count);
  capacity_ = count;
}

PointsView CellPoints::view() const {
  const PointsView positions =
      PointsView::strided({columns_[0].data(), columns_[1].data(), columns_[2].data()}, size_,
                          {sizeof(double), sizeof(double), sizeof(double)});
  if (!heights_) return positions;
  return positions.with_heights(std::span(columns_[3].data(), size_));
}

// Sorts one batch after the other by cell; one for each worker.
class Cells::Sorter {
 public:
  Sorter(std::size_t cells, bool heights)
      : heights_(heights), counts_(cells), homes_(cells), begins_(cells), ends_(cells) {}

  [[nodiscard]] std::size_t cells() const { return counts_.size(); }
  [[nodiscard]] std::uint32_t count(std::size_t cell) const { return counts_[cell]; }
  [[nodiscard]] std::uint32_t home_count(std::size_t cell) const { return homes_[cell]; }

  void sort(const PointsView& points, const Cut& cut) {
    count(points, cut);
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      begins_[cell] = begin;
      begin += counts_[cell];
    }
    bytes_.resize(begin * bytes_on_disk(heights_));
    for (std::size_t cell = 0; cell < cells(); ++cell) {
      std::byte* const data = bytes_.data() + offset(cell);
      const std::size_t column = counts_[cell] * sizeof(double);
      ends_[cell] = {data, data + columns_of(heights_) * column, column};
    }
    core::for_each_block(0, points.size(), [&](std::size_t first, std::size_t count) {
      block_.load(points, first, count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto index = static_cast<std::uint32_t>(first + i);
        const Point point = {block_.axis(0)[i], block_.axis(1)[i], block_.axis(2)[i]};
        const double height = heights_ ? points.heights_m()[index] : 0.0;
        const std::uint32_t home = homes_of_[index];
        if ((home & kHaloBit) == 0) {
          put(home, point, height, index);
          continue;
        }
        cut.for_each_cell(point, [&](CellNumber cell, bool at_home) {
          put(cell, point, height, index | (at_home ? 0U : kHaloBit));
        });
      }
    });
  }

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  // Of the cell, in bytes().
  [[nodiscard]] std::uint64_t offset(std::size_t cell) const {
    return begins_[cell] * bytes_on_disk(heights_);
  }
  [[nodiscard]] std::uint64_t checksum(std::size_t cell) const {
    const std::byte* const data = bytes_.data() + offset(cell);
    const std::size_t columns = columns_of(heights_);
    const std::size_t column = counts_[cell] * sizeof(double);
    Checksum sum;
    for (std::size_t at = 0; at < columns; ++at) sum.add({data + at * column, column});
    sum.add({data + columns * column, counts_[cell] * sizeof(std::uint32_t)});
    return sum.value();
  }

 private:
  // Where the next point of a cell goes: all x of a cell, all y, all z, all heights, then where
  // they stood.
  struct End {
    std::byte* number = nullptr;
    std::byte* place = nullptr;
    std::size_t column = 0;  // bytes
  };

  void count(const PointsView& points, const Cut& cut) {
    std::fill(counts_.begin(), counts_.end(), 0);
    std::fill(homes_.begin(), homes_.end(), 0);
    homes_of_.resize(points.size());
    core::for_each_block(0, points.size(), [&](std::size_t first, std::size_t count) {
      block_.load(points, first, count);
      cut.find_homes(block_, count, found_);
      for (std::size_t i = 0; i < count; ++i) {
        ++homes_[found_.cell[i]];
        homes_of_[first + i] = found_.cell[i];
        if (!found_.near_border[i]) continue;
        homes_of_[first + i] |= kHaloBit;
        const Point point = {block_.axis(0)[i], block_.axis(1)[i], block_.axis(2)[i]};
        cut.for_each_cell(point,
                          [&](CellNumber cell, bool home) { counts_[cell] += home ? 0 : 1; });
      }
    });
    for (std::size_t cell = 0; cell < cells(); ++cell) counts_[cell] += homes_[cell];
  }

  void put(CellNumber cell, const Point& point, double height, std::uint32_t place) {
    End& end = ends_[cell];
    std::memcpy(end.number, &point.x, sizeof(double));
    std::memcpy(end.number + end.column, &point.y, sizeof(double));
    std::memcpy(end.number + 2 * end.column, &point.z, sizeof(double));
    if (heights_) std::memcpy(end.number + 3 * end.column, &height, sizeof(double));
    std::memcpy(end.place, &place, sizeof place);
    end.number += sizeof(double);
    end.place += sizeof place;
  }

  bool heights_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> homes_;
  std::vector<std::size_t> begins_;
  std::vector<End> ends_;
  std::vector<CellNumber> homes_of_;  // of each point; with kHaloBit where it may be in halos
  std::vector<std::byte> bytes_;
  core::PointBlock block_;
  Cut::Homes found_;
};

Status Cells::distribute(const StoredPoints& points, std::size_t batch, Crew& crew,
                         const std::function<void(std::uint64_t)>& done) {
  const std::vector<Stretch> stretches = points.stretches(batch);
  std::mutex mutex;
  std::size_t failed = stretches.size();  // the first stretch that failed
  std::optional<Error> error;
  std::uint64_t finished = 0;
  std::atomic<std::size_t> next = 0;

  crew.run([&](unsigned worker) {
    Sorter sorter(segments_.size(), heights_);
    PointMemory memory;
    for (std::size_t at = next++; at < stretches.size() && !core::is_stopping(); at = next++) {
      const Stretch& stretch = stretches[at];
      const auto fail = [&](Error why) {
        const std::scoped_lock lock(mutex);
        if (at < failed) {
          failed = at;
          error = std::move(why);
        }
        next = stretches.size();
      };
      const auto view = points.view(stretch, memory);
      if (!view) return fail(view.error());
      auto wrong = core::check_points(*view, 0, view->size());
      if (!wrong) wrong = core::check_heights(*view);
      if (wrong) {
        if (wrong->location.record) *wrong->location.record += stretch.first_id;
        return fail(*std::move(wrong));
      }
      sorter.sort(*view, cut_);
      const auto written = file_.append(sorter.bytes());
      if (!written) return fail(written.error());

      const std::scoped_lock lock(mutex);
      for (std::size_t cell = 0; cell < sorter.cells(); ++cell) {
        if (sorter.count(cell) == 0) continue;
        segments_[cell].push_back({*written + sorter.offset(cell), stretch.first_id,
                                   sorter.checksum(cell), sorter.count(cell)});
        counts_[cell].all += sorter.count(cell);
        counts_[cell].home += sorter.home_count(cell);
      }
      finished += stretch.count;
      if (worker == 0) done(finished);
    }
  });

  if (error) return *std::move(error);
  for (auto& segments : segments_) {
    std::sort(segments.begin(), segments.end(),
              [](const Segment& a, const Segment& b) { return a.first_id < b.first_id; });
  }
  return std::monostate{};
}

Status Cells::read(std::span<const Segment> segments, CellPoints& points) const {
  std::size_t total = 0;
  for (const Segment& segment : segments) total += segment.count;
  points.resize(total, heights_);
  const std::size_t columns = columns_of(heights_);
  std::vector<std::uint32_t> places;
  std::size_t at = 0;
  for (const Segment& segment : segments) {
    const std::size_t count = segment.count;
    places.resize(count);
    std::array<iovec, 5> parts{};
    for (std::size_t column = 0; column < columns; ++column) {
      parts[column] = {points.columns_[column].data() + at, count * sizeof(double)};
    }
    parts[columns] = {places.data(), count * sizeof(std::uint32_t)};
    if (auto status = file_.read(segment.offset, std::span(parts).first(columns + 1)); !status) {
      return status;
    }

    Checksum sum;
    for (std::size_t column = 0; column < columns; ++column) {
      sum.add(bytes_of(points.columns_[column].data() + at, count));
    }
    sum.add(bytes_of(places.data(), count));
    if (sum.value() != segment.checksum) {
      return Error{
          ErrorCode::kCorrupt, "a temporary file does not hold what was written to it", {}};
    }
    for (std::size_t index = 0; index < count; ++index) {
      const std::uint64_t id = segment.first_id + (places[index] & ~kHaloBit);
      points.ids_[at + index] = id | ((places[index] & kHaloBit) != 0 ? CellPoints::kHaloFlag : 0);
    }
    at += count;
  }
  return std::monostate{};
}

}  // namespace beespace::out_of_core
