#include "out_of_core/search_cells.hpp"

#include "base/memory.hpp"
#include "base/stopping.hpp"
#include "out_of_core/cells.hpp"
#include "out_of_core/temporary_file.hpp"

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace beespace::out_of_core {

namespace {

// Cells are cut for this share of what can be searched at a time: a sample errs, and halos come to
// it.
constexpr double kShareOfCell = 0.7;

// Halos are so many times as wide as the nearest ones of a usual point are far.
constexpr double kNearestInReach = 3.0;

double share_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

// Of the temporary file of all cells.
std::uint64_t expected_bytes(const std::vector<Point>& sample, const Cut& cut,
                             const StoredPoints& points) {
  std::uint64_t copies = 0;
  for (const Point& point : sample) {
    cut.for_each_cell(point, [&](CellNumber /*cell*/, bool home) { copies += home ? 0 : 1; });
  }
  return static_cast<std::uint64_t>(
      static_cast<double>(points.size()) * (1.0 + share_of(copies, sample.size())) *
      static_cast<double>(Cells::bytes_on_disk(points.have_heights())));
}

// Tells the caller, but not all the time.
std::function<void(std::uint64_t)> progress_of(const Workplace& at, OutOfCoreProgress::Phase phase,
                                               std::uint64_t size) {
  if (!at.progress) return [](std::uint64_t /*done*/) {};
  return [&at, phase, size,
          last = std::chrono::steady_clock::time_point()](std::uint64_t done) mutable {
    constexpr std::chrono::milliseconds kPause(100);
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kPause && done < size) return;
    last = now;
    at.progress({phase, done, size});
  };
}

// A batch is small, so that it is sorted in the caches, and large enough that what it has for each
// cell is read without much seeking.
std::size_t batch_for(std::size_t cells, std::size_t most) {
  constexpr std::size_t kSmall = std::size_t{1} << 17U;
  constexpr std::size_t kForEachCell = 4096;
  return std::min(most, std::max(kSmall, cells * kForEachCell));
}

Result<Cells> distribute(const StoredPoints& points, const Reach& reach, const Workplace& at) {
  auto sample = points.sample(at.plan.sample);
  if (!sample) return std::move(sample).error();
  const auto most = static_cast<std::size_t>(kShareOfCell * static_cast<double>(at.plan.cell) *
                                             share_of(sample->size(), points.size()));
  Cut cut = Cut::of_sample(*sample, most, reach);
  auto file = TemporaryFile::make(at.folder, expected_bytes(*sample, cut, points));
  if (!file) return std::move(file).error();
  std::vector<Point>().swap(*sample);  // `= {}` would keep the memory

  const std::size_t batch = batch_for(cut.cells(), at.plan.batch);
  Cells cells(*std::move(file), std::move(cut), points.have_heights());
  core::StoppableCrew workers(at.crew, at.stop);
  auto status =
      cells.distribute(points, batch, workers,
                       progress_of(at, OutOfCoreProgress::Phase::kDistributing, points.size()));
  if (!status) return std::move(status).error();
  return cells;
}

}  // namespace

Reach reach_of(const SearchOptions& options, bool heights) {
  const double level = options.threshold_m;
  return {level, level, heights ? level : options.vertical_m.value_or(level)};
}

Result<Reach> reach_of_closest_pair(StoredPoints& points, const RunOptions& run,
                                    const Workplace& at) {
  if (auto status = points.flush(); !status) return std::move(status).error();
  const auto sample = points.sample(at.plan.sample);
  if (!sample) return sample.error();
  const auto closest = find_closest_pair(*sample, run);
  if (!closest) return closest.error();
  // Above zero, and not below the true distance, which is rounded four times.
  const double distance_m = *closest ? (*closest)->distance_m : 0.0;
  const double reach = std::max(kSmallestCoordinate_m, distance_m * (1.0 + 0x1p-40));
  return Reach{reach, reach, reach};
}

Result<Reach> reach_of_nearest(StoredPoints& points, std::size_t k, const RunOptions& run,
                               const Workplace& at) {
  if (auto status = points.flush(); !status) return std::move(status).error();
  const auto sample = points.sample(at.plan.sample);
  if (!sample) return sample.error();
  // Of the k nearest of all, so many are in the sample; distances go with the third root.
  const double among = static_cast<double>(k) * share_of(sample->size(), points.size());
  const auto found = find_k_nearest(*sample, static_cast<std::size_t>(std::ceil(among)), run);
  if (!found) return found.error();
  std::vector<double> farthest;
  for (const auto row : *found) farthest.push_back(row.back().distance_m);
  double reach = 0.0;
  if (!farthest.empty()) {
    const auto middle = farthest.begin() + static_cast<std::ptrdiff_t>(farthest.size() / 2);
    std::nth_element(farthest.begin(), middle, farthest.end());
    reach = kNearestInReach * *middle * std::cbrt(among / std::ceil(among));
  }
  reach = std::max(kSmallestCoordinate_m, reach);
  return Reach{reach, reach, reach};
}

Status search_cells(StoredPoints& points, const Reach& reach, const Workplace& at,
                    CellQuestion& question, OutOfCoreFacts& facts) {
  facts = {};
  if (auto status = points.flush(); !status) return status;
  return core::unless_stopped([&]() -> Status {
    const auto cells = distribute(points, reach, at);
    if (!cells) return cells.error();
    core::trim_freed_memory(std::min<std::size_t>(points.size(), at.plan.batch) *
                            Cells::bytes_a_batch_point(points.have_heights()));
    for (std::size_t cell = 0; cell < cells->size(); ++cell) {
      if (cells->home_count(cell) > 0) ++facts.cells;
      facts.copies += cells->count(cell) - cells->home_count(cell);
      facts.largest_cell = std::max(facts.largest_cell, cells->count(cell));
    }
    return walk_cells(*cells, at.plan.cell, question, at.stop,
                      progress_of(at, OutOfCoreProgress::Phase::kSearching, points.size()),
                      facts.crowded_cells);
  });
}

}  // namespace beespace::out_of_core
