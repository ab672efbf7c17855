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

template <class T>
std::span<const std::byte> bytes_of(const T* data, std::size_t count) {
  return std::as_bytes(std::span(data, count));
}

}  // namespace

void CellPoints::resize(std::size_t count) {
  size_ = count;
  if (count <= capacity_) return;
  capacity_ = 0;
  for (auto& axis : axes_) axis = {};
  ids_ = {};
  for (auto& axis : axes_) axis = core::Buffer<double>(count);
  ids_ = core::Buffer<std::uint64_t>(count);
  capacity_ = count;
}

PointsView CellPoints::view() const {
  return PointsView::strided({axes_[0].data(), axes_[1].data(), axes_[2].data()}, size_,
                             {sizeof(double), sizeof(double), sizeof(double)});
}

// Sorts one batch after the other by cell; one for each worker.
class Cells::Sorter {
 public:
  explicit Sorter(std::size_t cells) : counts_(cells), homes_(cells) {}

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
    bytes_.resize(entries_.size() * kBytesOnDisk);
    next_.assign(begins_.begin(), begins_.end() - 1);
    for (const Entry& entry : entries_) place(entry, points[entry.index & ~kHaloBit]);
  }

  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
  // Of the cell, in bytes().
  [[nodiscard]] std::uint64_t offset(std::size_t cell) const {
    return begins_[cell] * kBytesOnDisk;
  }
  [[nodiscard]] std::uint64_t checksum(std::size_t cell) const {
    const std::byte* const data = bytes_.data() + offset(cell);
    const std::size_t axis = counts_[cell] * sizeof(double);
    Checksum sum;
    for (std::size_t part = 0; part < 3; ++part) sum.add({data + part * axis, axis});
    sum.add({data + 3 * axis, counts_[cell] * sizeof(std::uint32_t)});
    return sum.value();
  }

 private:
  struct Entry {
    CellNumber cell;
    std::uint32_t index;  // in the batch
  };

  // All x of a cell, all y, all z, then where they stood.
  void place(const Entry& entry, const Point& point) {
    std::byte* const data = bytes_.data() + offset(entry.cell);
    const std::size_t count = counts_[entry.cell];
    const std::size_t at = next_[entry.cell]++ - begins_[entry.cell];
    const auto put = [&](std::size_t part, double coordinate) {
      std::memcpy(data + (part * count + at) * sizeof(double), &coordinate, sizeof coordinate);
    };
    put(0, point.x);
    put(1, point.y);
    put(2, point.z);
    std::memcpy(data + 3 * count * sizeof(double) + at * sizeof(std::uint32_t), &entry.index,
                sizeof entry.index);
  }

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
    Sorter sorter(segments_.size());
    std::vector<Point> memory;
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
      if (auto wrong = core::check_points(*view, 0, view->size())) {
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
  points.resize(total);
  std::vector<std::uint32_t> places;
  std::size_t at = 0;
  for (const Segment& segment : segments) {
    const std::size_t count = segment.count;
    places.resize(count);
    std::array<iovec, 4> parts{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      parts[axis] = {points.axes_[axis].data() + at, count * sizeof(double)};
    }
    parts[3] = {places.data(), count * sizeof(std::uint32_t)};
    if (auto status = file_.read(segment.offset, parts); !status) return status;

    Checksum sum;
    for (const auto& axis : points.axes_) sum.add(bytes_of(axis.data() + at, count));
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
