#include "sweep/ordered_rows.hpp"

#include "base/buffer.hpp"
#include "base/stopping.hpp"
#include "grid/sorted_grid.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <utility>

namespace beespace::cpu {

namespace {

// A tile reaches so far along x, and has so many points at most: many enough that bringing others
// into order does not count.
constexpr std::int32_t kTileReaches = 4;
constexpr std::uint32_t kMostInTile = 512;

// Query points that share the others around them. Measured.
constexpr std::uint32_t kMostInGroup = 32;

// In few steps: so frames that are much the same find the memory of the one before.
std::size_t room_for(std::size_t size) {
  constexpr std::size_t kLeast = 4096;
  constexpr std::size_t kGrowth = 8;
  std::size_t room = kLeast;
  while (room < size + core::kPadding) room *= kGrowth;
  return room;
}

// Positions and ids in memory that grows.
class PointList {
 public:
  explicit PointList(core::Memory& memory) : memory_(memory) {}

  // Empties it and makes room for so many.
  void reserve(std::size_t size) {
    size_ = 0;
    if (size + core::kPadding <= capacity_) return;
    capacity_ = room_for(size);
    words_ = {};
    words_ = core::Buffer<std::int32_t>(memory_, 4 * capacity_);
  }
  void grow(std::uint32_t count) { size_ += count; }

  [[nodiscard]] std::uint32_t size() const { return size_; }
  [[nodiscard]] Positions positions() const {
    const std::int32_t* const words = words_.data();
    return {words, words + capacity_, words + 2 * capacity_,
            reinterpret_cast<const PointId*>(words + 3 * capacity_)};
  }
  // Behind what it has.
  [[nodiscard]] PositionsOut end() {
    std::int32_t* const words = words_.data() + size_;
    return {words, words + capacity_, words + 2 * capacity_,
            reinterpret_cast<PointId*>(words + 3 * capacity_)};
  }

 private:
  core::Memory& memory_;
  core::Buffer<std::int32_t> words_;  // x, y, z, id
  std::size_t capacity_ = 0;
  std::uint32_t size_ = 0;
};

// Copies points into the order of their ids.
class IdOrder {
 public:
  explicit IdOrder(core::Memory& memory) : memory_(memory) {}

  void copy(const PointList& from, PointList& to) {
    const Positions at = from.positions();
    const std::uint32_t size = from.size();
    const Place* const sorted = sort(at.id, size);
    to.reserve(size);
    const PositionsOut out = to.end();
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t place = sorted[i].place;
      out.x[i] = at.x[place];
      out.y[i] = at.y[place];
      out.z[i] = at.z[place];
      out.id[i] = sorted[i].id;
    }
    to.grow(size);
  }

 private:
  struct Place {
    PointId id;
    std::uint32_t place;
  };
  static constexpr unsigned kDigitBits = 10;
  static constexpr std::size_t kDigitValues = std::size_t{1} << kDigitBits;

  // By the lowest digit first, up to the highest in which ids differ.
  const Place* sort(const PointId* ids, std::uint32_t size) {
    if (capacity_ < size) {
      capacity_ = room_for(size);
      places_ = {};
      places_ = core::Buffer<Place>(memory_, 2 * capacity_);
    }
    Place* from = places_.data();
    Place* to = from + capacity_;
    PointId different = 0;
    for (std::uint32_t i = 0; i < size; ++i) {
      from[i] = {ids[i], i};
      different |= ids[i] ^ ids[0];
    }
    for (unsigned shift = 0; different >> shift != 0; shift += kDigitBits) {
      const auto digit_of = [shift](PointId id) { return id >> shift & (kDigitValues - 1); };
      std::array<std::uint32_t, kDigitValues> next{};
      for (std::uint32_t i = 0; i < size; ++i) ++next[digit_of(from[i].id)];
      std::uint32_t sum = 0;
      for (std::uint32_t& place : next) sum += std::exchange(place, sum);
      for (std::uint32_t i = 0; i < size; ++i) to[next[digit_of(from[i].id)]++] = from[i];
      std::swap(from, to);
      if (shift + kDigitBits >= 32) break;
    }
    return from;
  }

  core::Memory& memory_;
  core::Buffer<Place> places_;
  std::size_t capacity_ = 0;
};

// One worker's way past its query points.
class RowWalk {
 public:
  RowWalk(const SweepQuery& question, Which which, core::Memory& memory)
      : question_(question),
        grid_(question.asked.grid),
        which_(which),
        reach_(question.reach_cells << grid_.fraction_bits),
        found_(memory),
        ordered_(memory),
        around_(memory),
        order_(memory),
        group_(memory, kMostInTile) {}
  RowWalk(const RowWalk&) = delete;
  RowWalk& operator=(const RowWalk&) = delete;
  ~RowWalk() = default;

  // Calls task(query, below, above) for those of the sorted points [begin, end) that are wanted and
  // have others around: what each is to be compared with, in two parts, of which the task sets the
  // query's range. Ends where the task says no.
  template <class Wanted, class Task>
  void for_each(std::uint32_t begin, std::uint32_t end, const Wanted& is_wanted, const Task& task) {
    RowSweeps(question_, decided_by(question_), RowSweeps::Around::kOwnRowToo)
        .for_each(begin, end, [&](const Sweep& sweep) {
          std::uint32_t next = sweep.points.begin;
          while (next < sweep.points.end) {
            if (core::is_stopping()) return false;
            const Range tile{next, end_of_tile(sweep, next)};
            next = tile.end;
            std::uint32_t* const chosen = group_.data();
            std::uint32_t* const chosen_end = choose(tile, is_wanted);
            if (chosen == chosen_end) continue;
            find_around(sweep, chosen, chosen_end);
            order_.copy(found_, ordered_);
            if (!ask_groups(chosen, chosen_end, task)) return false;
          }
          return true;
        });
  }

 private:
  [[nodiscard]] std::uint32_t end_of_tile(const Sweep& sweep, std::uint32_t begin) const {
    const std::uint32_t most = begin + std::min(sweep.points.end - begin, kMostInTile);
    const std::int64_t beyond =
        grid_.x[begin] + std::int64_t{kTileReaches} * reach_ - (1 << grid_.slice_bits);
    std::uint32_t end = begin + 1;
    while (end < most && grid_.x[end] < beyond) ++end;
    return end;
  }

  template <class Wanted>
  std::uint32_t* choose(Range tile, const Wanted& is_wanted) {
    std::uint32_t* to = group_.data();
    for (std::uint32_t i = tile.begin; i < tile.end; ++i) {
      if (is_wanted(i)) *to++ = i;
    }
    return to;
  }

  [[nodiscard]] PositionBox box_of(const std::uint32_t* begin, const std::uint32_t* end) const {
    PositionBox box{{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (; begin != end; ++begin) {
      for (unsigned axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], along(axis)[*begin]);
        box.high[axis] = std::max(box.high[axis], along(axis)[*begin]);
      }
    }
    return box;
  }
  [[nodiscard]] const std::int32_t* along(unsigned axis) const {
    return axis == 0 ? grid_.x : axis == 1 ? grid_.y : grid_.z;
  }

  // Finds the others around query points of one row, in the order of the grid.
  void find_around(const Sweep& sweep, const std::uint32_t* begin, const std::uint32_t* end) {
    const PositionBox box = box_of(begin, end);
    // Whole slices, whose points stand in any order, and a unit more for what was rounded.
    const std::int32_t slice = -(1 << sweep.slice_bits);
    const std::int32_t first_x = (box.low[0] - reach_ - 1) & slice;
    const std::int32_t end_x = ((box.high[0] + reach_ + 1) & slice) - slice;
    std::array<Range, std::size(Sweep{}.targets)> windows;
    std::size_t size = 0;
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      const std::int32_t* const x = sweep.others.x;
      const Range row = sweep.targets[k].points;
      const auto first_from = [&](std::uint32_t from, std::int32_t bound) {
        const auto* const found = std::partition_point(
            x + from, x + row.end, [bound](std::int32_t at) { return at < bound; });
        return static_cast<std::uint32_t>(found - x);
      };
      windows[k].begin = first_from(row.begin, first_x);
      windows[k].end = first_from(windows[k].begin, end_x);
      size += windows[k].end - windows[k].begin;
    }
    found_.reserve(size);
    for (unsigned k = 0; k < sweep.target_count; ++k) {
      const std::uint32_t first = windows[k].begin;
      const Positions at = sweep.others;
      found_.grow(question_.kernels.pick_around(
          {at.x + first, at.y + first, at.z + first, at.id + first}, windows[k].end - first, box,
          question_.limits, found_.end()));
    }
  }

  // Halves the query points at the middle of their box's longest side until they are few.
  template <class Task>
  bool ask_groups(std::uint32_t* begin, std::uint32_t* end, const Task& task) {
    const PositionBox box = box_of(begin, end);
    unsigned longest = 0;
    for (unsigned axis = 1; axis < 3; ++axis) {
      if (box.high[axis] - box.low[axis] > box.high[longest] - box.low[longest]) longest = axis;
    }
    const std::int32_t side = box.high[longest] - box.low[longest];
    if (end - begin <= kMostInGroup || side == 0) return ask_group(begin, end, box, task);
    const std::int32_t middle = box.low[longest] + side / 2;
    const std::int32_t* const at = along(longest);
    std::uint32_t* const second =
        std::partition(begin, end, [&](std::uint32_t i) { return at[i] <= middle; });
    return ask_groups(begin, second, task) && ask_groups(second, end, task);
  }

  template <class Task>
  bool ask_group(const std::uint32_t* begin, const std::uint32_t* end, const PositionBox& box,
                 const Task& task) {
    around_.reserve(ordered_.size());
    around_.grow(question_.kernels.pick_around(ordered_.positions(), ordered_.size(), box,
                                               question_.limits, around_.end()));
    const Positions at = around_.positions();
    RowQuery query{0, 0, 0, 0, at, {0, 0}, question_.limits, {decide, this}};
    for (; begin != end; ++begin) {
      if (core::is_stopping()) return false;
      const std::uint32_t i = *begin;
      query.x = grid_.x[i];
      query.y = grid_.y[i];
      query.z = grid_.z[i];
      query.asked = i;
      const Range left_out = left_out_by(grid_.id[i]);
      if (!task(query, Range{0, left_out.begin}, Range{left_out.end, around_.size()})) return false;
    }
    return true;
  }

  // Which of the others around are not looked at: itself, or all that are not above it.
  [[nodiscard]] Range left_out_by(PointId id) const {
    const PointId* const ids = around_.positions().id;
    const PointId* const end = ids + around_.size();
    if (which_ == Which::kAll && !question_.same_set) return {0, 0};
    const PointId* const own = std::lower_bound(ids, end, id);
    const auto first = static_cast<std::uint32_t>(own - ids);
    const std::uint32_t after = first + (own != end && *own == id ? 1U : 0U);
    return {which_ == Which::kAboveOnly ? 0 : first, after};
  }

  static bool decide(void* context, std::uint32_t asked, std::uint32_t other) {
    const auto& self = *static_cast<const RowWalk*>(context);
    const SweepQuery& question = self.question_;
    return !core::is_stopping() &&
           question.closer(question.asked.point(asked),
                           question.others.points[self.around_.positions().id[other]]);
  }

  const SweepQuery& question_;
  const core::SortedGrid& grid_;
  Which which_;
  std::int32_t reach_;  // in units
  PointList found_;
  PointList ordered_;
  PointList around_;
  IdOrder order_;
  core::Buffer<std::uint32_t> group_;  // query points of a tile
};

}  // namespace

std::uint64_t count_rows(const SweepQuery& question, Which which, const core::Resources& with,
                         std::uint64_t most, std::uint32_t* lengths) {
  std::atomic<std::uint64_t> total = 0;
  with.crew.split(
      question.asked.grid.size, [&](std::size_t begin, std::size_t end, unsigned worker) {
        if (begin == end) return;
        std::fill(lengths + begin, lengths + end, 0U);  // of points that have no others around
        RowWalk(question, which, with.memory.of(worker))
            .for_each(
                static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                [](std::uint32_t) { return true; },
                [&](RowQuery& query, Range below, Range above) {
                  query.range = below;
                  std::uint32_t length = question.kernels.count_row(query);
                  query.range = above;
                  length += question.kernels.count_row(query);
                  lengths[query.asked] = length;
                  return total.fetch_add(length, std::memory_order_relaxed) + length <= most;
                });
      });
  return total;
}

void visit_rows(const SweepQuery& question, Which which, const core::Resources& with,
                const std::uint32_t* lengths, const VisitRow& visit) {
  with.crew.split(question.asked.grid.size,
                  [&](std::size_t begin, std::size_t end, unsigned worker) {
                    if (begin == end) return;
                    const std::size_t longest = *std::max_element(lengths + begin, lengths + end);
                    core::Buffer<PointId> row(with.memory.of(worker), room_for(longest));
                    RowWalk(question, which, with.memory.of(worker))
                        .for_each(
                            static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end),
                            [&](std::uint32_t i) { return lengths[i] != 0; },
                            [&](RowQuery& query, Range below, Range above) {
                              query.range = below;
                              std::uint32_t length = question.kernels.write_row(query, row.data());
                              query.range = above;
                              length += question.kernels.write_row(query, row.data() + length);
                              // Once stopped, what is open is not decided.
                              if (length == lengths[query.asked])
                                visit(query.asked, row.data(), length);
                              return true;
                            });
                  });
}

}  // namespace beespace::cpu
