#include "out_of_core/cells.hpp"

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
  Sorter(std::size_t cells, bool heights) : heights_(heights), counts_(cells), homes_(cells) {}

  [[nodiscard]] std::size_t cells() const { return counts_.size(); }
  [[nodiscard]] std::uint32_t count(std::size_t cell) const { return counts_[cell]; }
  [[nodiscard]] std::uint32_t home_count(std::size_t cell) const { return homes_[cell]; }

  void sort(const PointsView& points, const Cut& cut) {
    std::fill(counts_.begin(), counts_.end(), 0);
    std::fill(homes_.begin(), homes_.end(), 0);
    entries_.clear();
    for (std::size_t index = 0; index < points.size(); ++index) {
      cut.for_each_cell(points[index], [&](CellNumber cell, bool home) {
        ++counts_[cell];
        if (home) ++homes_[cell];
        entries_.push_back({cell, static_cast<std::uint32_t>(index) | (home ? 0U : kHaloBit)});
      });
    }
    begins_.assign(1, 0);
    for (const std::uint32_t count : counts_) begins_.push_back(begins_.back() + count);
    bytes_.resize(entries_.size() * bytes_on_disk(heights_));
    next_.assign(begins_.begin(), begins_.end() - 1);
    for (const Entry& entry : entries_) place(entry, points);
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
  struct Entry {
    CellNumber cell;
    std::uint32_t index;  // in the batch
  };

  // All x of a cell, all y, all z, all heights, then where they stood.
  void place(const Entry& entry, const PointsView& points) {
    std::byte* const data = bytes_.data() + offset(entry.cell);
    const std::size_t count = counts_[entry.cell];
    const std::size_t at = next_[entry.cell]++ - begins_[entry.cell];
    const auto put = [&](std::size_t column, double number) {
      std::memcpy(data + (column * count + at) * sizeof(double), &number, sizeof number);
    };
    const std::size_t index = entry.index & ~kHaloBit;
    const Point point = points[index];
    put(0, point.x);
    put(1, point.y);
    put(2, point.z);
    if (heights_) put(3, points.heights_m()[index]);
    std::memcpy(data + columns_of(heights_) * count * sizeof(double) + at * sizeof(std::uint32_t),
                &entry.index, sizeof entry.index);
  }

  bool heights_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> homes_;
  std::vector<Entry> entries_;
  std::vector<std::size_t> begins_;
  std::vector<std::size_t> next_;
  std::vector<std::byte> bytes_;
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
