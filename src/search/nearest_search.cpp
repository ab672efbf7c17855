#include "search/nearest_search.hpp"

#include "base/buffer.hpp"
#include "base/hash.hpp"
#include "base/resize_for.hpp"
#include "exact/exact_distance.hpp"
#include "grid/near_pairs.hpp"
#include "grid/neighbor_probe.hpp"
#include "grid/sorted_grid.hpp"
#include "search/nearest_in_tree.hpp"
#include "sweep/expected_work.hpp"
#include "sweep/nearest_all.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace beespace::search {

namespace {

// So few are faster compared with all points than looked for in grids of their own.
constexpr std::size_t kFew = 16;

class NearestSearch {
 public:
  NearestSearch(const SearchDomain& domain, const std::optional<PairOptions>& within,
                const core::Resources& with, const TuningOverrides& tuning,
                std::vector<Nearest>& nearest)
      : domain_(domain),
        with_(with),
        tuning_(tuning),
        within_(within),
        farthest_(within ? within->threshold_m : std::numeric_limits<double>::infinity()),
        nearest_(nearest),
        ids_(with.memory, domain.points().size()),
        candidates_(&with.memory),
        open_(&with.memory) {}

  void run() {
    const std::size_t size = domain_.points().size();
    if (domain_.others().size() < (domain_.has_others() ? 1U : 2U)) {
      return nearest_.assign(size, Nearest{});
    }
    core::resize_for(nearest_, size, with_.crew);
    if (size == 0) return;
    bool all_open = true;
    if (!domain_.has_others() && domain_.expected_neighbors(domain_.widest() * kTwinCells) > 1.0) {
      nearest_.assign(size, Nearest{});
      settle_duplicates();
      all_open = false;
      if (open_.empty()) return;
    }
    double radius = std::min(domain_.side_with_some() * kFirstRadius, farthest_);
    if (radius == 0.0) radius = std::min(1.0, farthest_);  // all asked and others at one place
    if (tuning_.nearest == TuningOverrides::Nearest::kTree ||
        tuning_.nearest == TuningOverrides::Nearest::kShells) {
      return look_in_tree();
    }
    if (radius < farthest_ && is_hopeless()) return look_in_tree();
    for (;;) {
      if (!look_within(radius, all_open)) return look_in_tree();
      settle(radius, all_open);
      all_open = false;
      if (radius == farthest_ || open_.empty()) return;
      if (open_.size() <= kFew) return compare_with_all();
      if (is_costly(open_.size())) return look_in_tree();
      // The few that are left in open country may take longer steps.
      const double step = open_.size() * 32 < size ? 4.0 : 2.0;
      radius = std::min(step * radius, farthest_);
    }
  }

 private:
  // Of the cube that holds a dozen: within this radius each point of an even swarm expects three
  // others, and one in 25 finds none. Measured, between 0.40 and 0.54.
  static constexpr double kFirstRadius = 0.40;
  static constexpr double kTwinCells = 0x1p-40;

  // What grids may cost before a tree is taken for what is open; a tree costs about as much.
  // Measured: an even swarm compares up to a hundred others of each point in the first round,
  // leaves one in 25 open, and is sorted but once.
  static constexpr double kMostComparisons = 512.0;  // for each point of both sets
  static constexpr std::size_t kMostOpen = 4;        // after a round: one in so many
  static constexpr double kMostSorted = 3.0;         // times all others

  // Whether more rounds would cost more than a tree.
  [[nodiscard]] bool is_costly(std::size_t open) const {
    if (tuning_.nearest != TuningOverrides::Nearest::kAutomatic) return false;
    return open > domain_.points().size() / kMostOpen ||
           sorted_ > kMostSorted * static_cast<double>(domain_.others().size());
  }

  // Whether the first round would leave too many open, as many are far from where most are.
  [[nodiscard]] bool is_hopeless() const {
    return tuning_.nearest == TuningOverrides::Nearest::kAutomatic && domain_.is_patchy();
  }

  void look_in_tree() { find_nearest_in_tree(domain_, open_, within_, with_, tuning_, nearest_); }

  // Points at one place are each other's nearest, however many there are. Only the first of each
  // place takes part in what follows: the others could be nearest to no other point.
  void settle_duplicates() {
    const PointsView& points = domain_.points();
    const std::size_t slots = std::bit_ceil(points.size() * 2);
    core::Buffer<PointId> first_at(with_.memory, slots);
    std::fill_n(first_at.data(), slots, Nearest::kNone);
    candidates_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point p = points[i];
      std::size_t slot = core::hash_place(p) & (slots - 1);
      while (first_at[slot] != Nearest::kNone && points[first_at[slot]] != p) {
        slot = (slot + 1) & (slots - 1);
      }
      const auto id = static_cast<PointId>(i);
      const PointId first = first_at[slot];
      if (first == Nearest::kNone) {
        first_at[slot] = id;
        candidates_.push_back(id);
        continue;
      }
      nearest_[id] = {first, 0.0};
      if (nearest_[first].id == Nearest::kNone) nearest_[first] = {id, 0.0};
    }
    for (const PointId id : candidates_) {
      if (nearest_[id].id == Nearest::kNone) open_.push_back(id);
    }
  }

  // A grid of points that later rounds may search again, as far as its rows are wide.
  struct Around {
    Around(core::Lattice&& of, double reach, core::SortedGrid&& sorted)
        : lattice(std::move(of)), radius(reach), grid(std::move(sorted)) {}

    // The radius in cells of this grid; none if that is more than a row, or if points more than a
    // cell away may be beyond the kernel's reach.
    [[nodiscard]] std::optional<std::int32_t> cells(double wanted) const {
      constexpr unsigned kMostUnitsBits = 28;  // positions are below 2^30
      const unsigned most =
          lattice.folded() ? 0 : std::min(grid.row_shift, kMostUnitsBits - grid.fraction_bits);
      for (unsigned shift = 0; shift <= most; ++shift) {
        const std::int32_t count = 1 << shift;
        if (count * radius >= wanted) return count;
      }
      return std::nullopt;
    }

    core::Lattice lattice;
    double radius;
    core::SortedGrid grid;
  };

  // Writes to ids_ the nearest of those that every open point sees within the radius. False, with
  // nothing done, where that would be too much work.
  bool look_within(double radius, bool all_open) {
    core::Selection asking{domain_.points()};
    if (!all_open) asking.ids = open_;
    if (around_) {
      if (const auto cells = around_->cells(radius)) {
        const core::SortedGrid asked =
            core::sort_into_grid(asking, around_->lattice, around_->grid.row_shift, with_);
        return ask(asked, around_->grid, radius, *cells);
      }
      around_.reset();
    }
    core::Lattice lattice(domain_.sets(), domain_.bounds(), radius, with_.memory,
                          tuning_.fold_beyond_cells);
    unsigned row_shift = domain_.row_shift(lattice, radius);
    if (tuning_.row_shift) row_shift = std::min(*tuning_.row_shift, 30 - lattice.fraction_bits());
    core::Selection around{domain_.others()};
    core::Vector<PointId> surrounding(&with_.memory);
    if (!candidates_.empty()) around.ids = candidates_;
    const bool few = !all_open && open_.size() * 32 < around.size();
    if (few) {
      surrounding = core::surroundings(asking, around, lattice, with_);
      around.ids = surrounding;
    }
    core::SortedGrid others = core::sort_into_grid(around, lattice, row_shift, with_);
    // Those around a few are found among all, which costs an eighth of sorting all.
    sorted_ +=
        few ? static_cast<double>(domain_.others().size()) / 8.0 : static_cast<double>(others.size);
    const bool done =
        all_open && !domain_.has_others()
            ? ask(others, others, radius, 1)
            : ask(core::sort_into_grid(asking, lattice, row_shift, with_), others, radius, 1);
    if (done && !few) around_.emplace(std::move(lattice), radius, std::move(others));
    return done;
  }

  bool ask(const core::SortedGrid& asked, const core::SortedGrid& others, double radius,
           std::int32_t reach_cells) {
    const core::SquaredLimits squared(radius, others.units_per_m);
    const core::ProximityTest unused(1.0, false);
    const cpu::SweepQuery question{{asked, domain_.points()},
                                   {others, domain_.others()},
                                   unused,
                                   {squared.surely_near, squared.surely_far},
                                   cpu::kernels(tuning_.instruction_set),
                                   !domain_.has_others(),
                                   reach_cells};
    const double all = static_cast<double>(domain_.points().size() + domain_.others().size());
    const double most = kMostComparisons * all;
    if (tuning_.nearest == TuningOverrides::Nearest::kAutomatic &&
        static_cast<double>(asked.size) * static_cast<double>(others.size) > most &&
        cpu::expected_comparisons(question) > most) {
      return false;
    }
    cpu::nearest_all(question, with_, ids_.data());
    return true;
  }

  // A point that has found one within the radius has found the nearest. At the last radius, a point
  // that has found none within the threshold has none. The others stay open.
  void settle(double radius, bool all_open) {
    const bool last = radius == farthest_;
    const core::ProximityTest closer(radius, last && within_->inclusive);
    const std::size_t size = all_open ? domain_.points().size() : open_.size();
    const PointsView points = domain_.original_points();
    const PointsView others = domain_.original_others();
    core::PerWorker<PointId> still_open(with_);
    with_.crew.split(size, [&](std::size_t begin, std::size_t end, unsigned worker) {
      for (std::size_t i = begin; i < end; ++i) {
        constexpr std::size_t kAhead = 16;
        if (all_open && i + kAhead < end) prefetch_found(static_cast<PointId>(i + kAhead));
        const PointId id = all_open ? static_cast<PointId>(i) : open_[i];
        const PointId found = ids_[id];
        if (found != Nearest::kNone) {
          // As the caller has them, not as they are turned: sums of squares round differently.
          const Point p = points[id];
          const Point q = others[found];
          if (closer(p, q)) {
            nearest_[id] = {found, std::sqrt(core::squared_distance(p, q))};
            continue;
          }
        }
        nearest_[id] = Nearest{};
        if (!last) still_open[worker].push_back(id);
      }
    });
    open_ = std::move(still_open).joined();
  }

  void prefetch_found(PointId id) const {
    const PointId found = ids_[id];
    if (found == Nearest::kNone) return;
    const auto* place = static_cast<const std::byte*>(domain_.original_others().axes()[0]);
    place += static_cast<std::ptrdiff_t>(found) * domain_.original_others().stride_bytes()[0];
    __builtin_prefetch(place);
    __builtin_prefetch(place + sizeof(Point) - 1);  // one in four lies across two lines
  }

  // By the points as the caller has them, not as they are turned: sums of squares round
  // differently.
  [[nodiscard]] double found_distance(PointId id, PointId found) const {
    return distance(domain_.original_points()[id], domain_.original_others()[found]);
  }

  void compare_with_all() {
    const PointsView& points = domain_.points();
    const PointsView& others = domain_.others();
    for (const PointId id : open_) {
      const Point place = points[id];
      PointId best = Nearest::kNone;
      double surely_farther = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < others.size(); ++j) {
        const double squared = core::squared_distance(place, others[j]);
        if (squared > surely_farther) continue;
        const auto other = static_cast<PointId>(j);
        if (!domain_.has_others() && other == id) continue;
        if (best != Nearest::kNone &&
            core::compare_distances(place, others[other], place, others[best]) >= 0) {
          continue;  // ids ascend, so a tie stays with the lower one
        }
        best = other;
        surely_farther = squared * (1.0 + 0x1p-49);  // both carry at most 5 * 2^-53
      }
      if (best == Nearest::kNone) continue;
      if (within_ &&
          !core::ProximityTest(within_->threshold_m, within_->inclusive)(place, others[best])) {
        continue;
      }
      nearest_[id] = {best, found_distance(id, best)};
    }
  }

  const SearchDomain& domain_;
  const core::Resources& with_;
  const TuningOverrides& tuning_;
  const std::optional<PairOptions>& within_;
  double farthest_;
  std::vector<Nearest>& nearest_;
  core::Buffer<PointId> ids_;
  core::Vector<PointId> candidates_;  // empty: all
  std::optional<Around> around_;
  double sorted_ = 0.0;         // points, again and again
  core::Vector<PointId> open_;  // those without their nearest yet, once not all are
};

}  // namespace

void find_nearest(const SearchDomain& domain, const std::optional<PairOptions>& within,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<Nearest>& nearest) {
  NearestSearch(domain, within, with, tuning, nearest).run();
}

std::optional<ClosestPair> find_closest_between(const SearchDomain& domain,
                                                const core::Resources& with,
                                                const TuningOverrides& tuning,
                                                std::vector<Nearest>& nearest) {
  find_nearest(domain, std::nullopt, with, tuning, nearest);
  const PointsView& points = domain.points();
  const PointsView& others = domain.others();
  std::optional<ClosestPair> closest;
  for (PointId id = 0; id < nearest.size(); ++id) {
    const Nearest& found = nearest[id];
    if (found.id == Nearest::kNone) continue;
    if (closest && core::compare_distances(points[id], others[found.id], points[closest->first],
                                           others[closest->second]) >= 0) {
      continue;  // ids ascend, so a tie stays with the lower ones
    }
    closest = {id, found.id, found.distance_m};
  }
  return closest;
}

}  // namespace beespace::search
