// Many queries at once: in an order that suits the caches, in chunks, which free threads take.
#include "base/resize_for.hpp"
#include "base/stopping.hpp"
#include "exact/validate.hpp"
#include "index/index_levels.hpp"
#include "index/place_order.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <new>
#include <span>
#include <utility>
#include <vector>

namespace beespace::search {

namespace {

// Neighbouring queries that one worker answers.
constexpr std::size_t kChunk = 512;

// Calls work(chunk, begin, end, worker) for all chunks of [0, count).
template <class Work>
void share_out(std::size_t count, Crew& crew, Work&& work) {
  std::atomic<std::size_t> next{0};
  crew.run([&](unsigned worker) {
    for (std::size_t chunk = next++; chunk * kChunk < count && !core::is_stopping();
         chunk = next++) {
      work(chunk, chunk * kChunk, std::min((chunk + 1) * kChunk, count), worker);
    }
  });
}

class AroundAll {
 public:
  AroundAll(const IndexLevels& levels, const OrderedPlaces& places, std::span<const double> radii_m,
            const AroundOptions& options, Crew& crew)
      : levels_(levels),
        places_(places),
        radii_m_(radii_m),
        options_(options),
        crew_(crew),
        rows_(crew.size()),
        chunks_(places.size() / kChunk + 1),
        sizes_(places.size()) {}

  Result<IdRows> find() {
    share_out(places_.size(), crew_,
              [&](std::size_t chunk, std::size_t begin, std::size_t end, unsigned worker) {
                if (total_ > options_.max_results) return;
                std::vector<PointId>& ids = chunks_[chunk];
                for (std::size_t i = begin; i < end && !core::is_stopping(); ++i) {
                  probe_neighbors(i, rows_[worker], ids);
                }
                total_ += ids.size();
              });
    if (total_ > options_.max_results) return core::too_many_results(options_.max_results);
    return together();
  }

 private:
  void probe_neighbors(std::size_t i, std::vector<PointId>& row, std::vector<PointId>& ids) {
    const double radius_m = radii_m_.empty() ? options_.radius_m : radii_m_[places_.index[i]];
    levels_.find_around({places_.places[i], radius_m, options_.inclusive}, row);
    sizes_[i] = static_cast<std::uint32_t>(row.size());
    ids.insert(ids.end(), row.begin(), row.end());
  }

  // The rows one behind the other, in the caller's order.
  IdRows together() {
    IdRows rows;
    rows.offsets.resize(places_.size() + 1);
    for (std::size_t i = 0; i < sizes_.size(); ++i) rows.offsets[places_.index[i]] = sizes_[i];
    std::uint64_t before = 0;
    for (std::uint64_t& offset : rows.offsets) before += std::exchange(offset, before);
    core::resize_for(rows.ids, before, crew_);
    share_out(places_.size(), crew_,
              [&](std::size_t chunk, std::size_t begin, std::size_t end, unsigned) {
                const PointId* from = chunks_[chunk].data();
                for (std::size_t i = begin; i < end && !core::is_stopping(); ++i) {
                  PointId* const to = rows.ids.data() + rows.offsets[places_.index[i]];
                  std::copy_n(from, sizes_[i], to);
                  from += sizes_[i];
                }
              });
    return rows;
  }

  const IndexLevels& levels_;
  const OrderedPlaces& places_;
  std::span<const double> radii_m_;  // in the caller's order; or none
  const AroundOptions& options_;
  Crew& crew_;
  std::vector<std::vector<PointId>> rows_;    // of one place, by worker
  std::vector<std::vector<PointId>> chunks_;  // the rows of a chunk, one behind the other
  std::vector<std::uint32_t> sizes_;          // of the rows, in the order of the search
  std::atomic<std::uint64_t> total_{0};
};

}  // namespace

Result<IdRows> find_around_all(const IndexLevels& levels, const PointsView& places,
                               std::span<const double> radii_m, const core::Bounds& bounds,
                               const AroundOptions& options, Crew& crew) {
  if (places.empty()) return IdRows{};
  const OrderedPlaces ordered = place_order(places, bounds, crew);
  return AroundAll(levels, ordered, radii_m, options, crew).find();
}

NearestRows find_nearest_of_all(const IndexLevels& levels, const PointsView& places,
                                const core::Bounds& bounds, std::size_t k, Crew& crew) {
  if (k == 0 || places.empty()) return {};
  NearestRows rows{k, {}};
  if (places.size() > rows.entries.max_size() / k) throw std::bad_alloc();
  core::resize_for(rows.entries, places.size() * k, crew);
  const OrderedPlaces ordered = place_order(places, bounds, crew);
  share_out(places.size(), crew, [&](std::size_t, std::size_t begin, std::size_t end, unsigned) {
    core::NearestList list;
    double reach_m = std::numeric_limits<double>::infinity();
    for (std::size_t i = begin; i < end && !core::is_stopping(); ++i) {
      const Point& place = ordered.places[i];
      // As many points as around the place before lie within their distance plus the distance of
      // the two places. Distances and sums are off by a few 2^-53.
      if (i > begin) reach_m += distance(place, ordered.places[i - 1]);
      list.start(place, k, reach_m * (1.0 + 0x1p-48));
      levels.find_nearest(place, list);
      reach_m = list.reach_m();
      list.write(rows.entries.data() + std::size_t{ordered.index[i]} * k);
    }
  });
  return rows;
}

}  // namespace beespace::search
