#include "out_of_core/stored_points.hpp"

#include "exact/validate.hpp"
#include "out_of_core/checksum.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace beespace::out_of_core {

namespace {

// A sample is taken in runs of neighbours, as single points would each read a page.
constexpr std::size_t kSampleRun = 32;

std::uint64_t checksum_of(const PointMemory& memory) {
  Checksum checksum;
  checksum.add(std::as_bytes(std::span(memory.points)));
  checksum.add(std::as_bytes(std::span(memory.heights)));
  return checksum.value();
}

}  // namespace

PointsView part_of(const PointsView& points, std::size_t begin, std::size_t count) {
  const auto& strides = points.stride_bytes();
  std::array<const std::byte*, 3> axes{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    axes[axis] = static_cast<const std::byte*>(points.axes()[axis]) +
                 static_cast<std::ptrdiff_t>(begin) * strides[axis];
  }
  const auto of = [&]<class Number>(const Number* /*type*/) {
    return PointsView::strided(
        {reinterpret_cast<const Number*>(axes[0]), reinterpret_cast<const Number*>(axes[1]),
         reinterpret_cast<const Number*>(axes[2])},
        count, strides);
  };
  const PointsView part = points.holds_floats() ? of(static_cast<const float*>(nullptr))
                                                : of(static_cast<const double*>(nullptr));
  return points.has_heights() ? part.with_heights(points.heights_m().subspan(begin, count)) : part;
}

Status StoredPoints::refer(const PointsView& points) {
  if (points.empty()) return std::monostate{};
  if (auto status = flush(); !status) return status;
  pieces_.push_back({points, 0, 0, 0, points.size(), false});
  size_ += points.size();
  have_heights_ = points.has_heights();
  return std::monostate{};
}

Status StoredPoints::copy(const PointsView& points, const std::string& folder,
                          std::size_t at_a_time) {
  if (points.empty()) return std::monostate{};
  const bool apart = points.has_heights();
  const std::uint64_t bytes =
      std::uint64_t{points.size()} * (sizeof(Point) + (apart ? sizeof(double) : 0));
  if (!file_) {
    auto made = TemporaryFile::make(folder, bytes);
    if (!made) return std::move(made).error();
    file_.emplace(*std::move(made));
  }
  const std::size_t pieces_before = pieces_.size();
  const PointMemory waiting_before = waiting_;
  for (std::size_t index = 0; index < points.size(); ++index) {
    waiting_.points.push_back(points[index]);
    if (apart) waiting_.heights.push_back(points.heights_m()[index]);
    if (waiting_.points.size() < at_a_time) continue;
    if (auto status = flush(); !status) {
      pieces_.resize(pieces_before);
      waiting_ = waiting_before;
      return status;
    }
  }
  size_ += points.size();
  bytes_on_disk_ += bytes;
  have_heights_ = apart;
  return std::monostate{};
}

Status StoredPoints::flush() {
  if (waiting_.points.empty()) return std::monostate{};
  const auto written = file_->append(std::as_bytes(std::span(waiting_.points)));
  if (!written) return written.error();
  const auto heights_at = file_->append(std::as_bytes(std::span(waiting_.heights)));
  if (!heights_at) return heights_at.error();
  pieces_.push_back(
      {{}, *written, *heights_at, checksum_of(waiting_), waiting_.points.size(), true});
  waiting_.points.clear();
  waiting_.heights.clear();
  return std::monostate{};
}

std::vector<Stretch> StoredPoints::stretches(std::size_t most) const {
  std::vector<Stretch> all;
  std::uint64_t id = 0;
  for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
    const std::size_t count = pieces_[piece].count;
    const std::size_t at_a_time = pieces_[piece].on_disk ? count : most;
    for (std::size_t begin = 0; begin < count; begin += at_a_time) {
      const std::size_t part = std::min(at_a_time, count - begin);
      all.push_back({piece, begin, part, id});
      id += part;
    }
  }
  return all;
}

Result<PointsView> StoredPoints::view(const Stretch& stretch, PointMemory& memory) const {
  const Piece& piece = pieces_[stretch.piece];
  if (!piece.on_disk) return part_of(piece.points, stretch.begin, stretch.count);
  memory.points.resize(piece.count);
  memory.heights.resize(have_heights_ ? piece.count : 0);
  std::array<iovec, 1> points = {{{memory.points.data(), piece.count * sizeof(Point)}}};
  if (auto status = file_->read(piece.offset, points); !status) return std::move(status).error();
  std::array<iovec, 1> heights = {
      {{memory.heights.data(), memory.heights.size() * sizeof(double)}}};
  if (auto status = file_->read(piece.heights_at, heights); !status) {
    return std::move(status).error();
  }
  if (checksum_of(memory) != piece.checksum) {
    return Error{ErrorCode::kCorrupt, "a temporary file does not hold what was written to it", {}};
  }
  return PointsView(memory.points).with_heights(memory.heights);
}

Result<std::vector<Point>> StoredPoints::sample(std::size_t count) const {
  std::vector<Point> sample;
  sample.reserve(std::min<std::uint64_t>(size_, count + kSampleRun));
  PointMemory memory;
  const std::uint64_t runs = std::max<std::uint64_t>(1, count / kSampleRun);
  const double step =
      std::max(1.0, static_cast<double>(size_) / static_cast<double>(runs * kSampleRun));
  double next = 0.0;  // the id that the next run begins with
  for (const Stretch& stretch : stretches(std::size_t{1} << 22)) {
    const std::uint64_t id = stretch.first_id;
    const double end = static_cast<double>(id + stretch.count);
    if (next >= end) continue;
    const auto view = this->view(stretch, memory);
    if (!view) return view.error();
    while (next < end) {
      const auto begin = static_cast<std::uint64_t>(next) - id;
      const std::uint64_t stop = std::min<std::uint64_t>(begin + kSampleRun, stretch.count);
      for (std::uint64_t index = begin; index < stop; ++index) {
        const Point point = (*view)[index];
        // What is no place is told when all points are looked at.
        if (core::in_domain(point.x) && core::in_domain(point.y) && core::in_domain(point.z)) {
          sample.push_back(point);
        }
      }
      next += std::max(1.0, step * static_cast<double>(kSampleRun));
    }
  }
  return sample;
}

}  // namespace beespace::out_of_core
