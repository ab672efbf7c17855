#include "search/k_nearest_search.hpp"

#include "base/dynamic_schedule.hpp"
#include "base/resize_for.hpp"
#include "base/stopping.hpp"
#include "kernels/tree_walk.hpp"
#include "tree/point_tree.hpp"

#include <algorithm>
#include <limits>
#include <new>

namespace beespace::search {

namespace {

// Neighbouring points that one worker looks up.
constexpr std::size_t kChunk = 512;

// Takes a point out of the row of the nearest ones. One that is not among them has so many others
// at its position that all of them are, with lower ids: then the last one is too many.
void leave_out(PointId self, const Nearest* found, std::size_t count, Nearest* row) {
  std::size_t at = 0;
  while (at + 1 < count && found[at].id != self) ++at;
  std::copy_n(found, at, row);
  std::copy(found + at + 1, found + count, row + at);
}

}  // namespace

void find_k_nearest(const PointsView& points, const core::Bounds& bounds, std::size_t k,
                    const core::Resources& with, const TuningOverrides& tuning,
                    std::vector<core::NearestList>& lists, NearestRows& rows) {
  const std::size_t size = points.size();
  rows.length = size == 0 ? 0 : std::min(k, size - 1);
  if (rows.length == 0) return rows.entries.clear();
  if (size > rows.entries.max_size() / rows.length) throw std::bad_alloc();
  core::resize_for(rows.entries, size * rows.length, with.crew);
  if (lists.size() < with.crew.size()) lists.resize(with.crew.size());
  const std::size_t wanted = rows.length + 1;  // the point itself is found, too
  core::PerWorker<Nearest> found(with);
  for (unsigned worker = 0; worker < with.crew.size(); ++worker) found[worker].resize(wanted);
  const core::PointTree tree(points, bounds, with);
  const cpu::TreeWalks walks = cpu::tree_walks(tuning.instruction_set);
  cpu::schedule(with.crew, size, kChunk, [&](std::size_t begin, std::size_t end, unsigned worker) {
    core::NearestList& list = lists[worker];
    double reach_m = std::numeric_limits<double>::infinity();
    for (std::size_t slot = begin; slot < end && !core::is_stopping(); ++slot) {
      const auto place = static_cast<std::uint32_t>(slot);
      const Point& point = tree.point(place);
      // As many as are around the point before, are no farther from here than from
      // there and the way between the two. Distances and sums are off by a few 2^-53.
      if (slot > begin) reach_m += distance(point, tree.point(place - 1));
      list.start(point, wanted, reach_m * (1.0 + 0x1p-48));
      walks.find_nearest(tree.view(), point, list);
      reach_m = list.reach_m();
      list.write(found[worker].data());
      const PointId id = tree.id(place);
      leave_out(id, found[worker].data(), wanted,
                rows.entries.data() + std::size_t{id} * rows.length);
    }
  });
}

}  // namespace beespace::search
