// The nearest by the straight line among those in the cylinder: for each place a walk through the
// tree that leaves out what is outside, or farther than the nearest found so far.
#include "search/cylinder_search.hpp"

#include "base/resize_for.hpp"

#include <algorithm>
#include <limits>

namespace beespace::search {

namespace {

constexpr std::size_t kFanOut = core::CylinderTree::kFanOut;

// The lowest id below each node: of those that are equally near it counts.
core::Buffer<PointId> lowest_ids(const core::CylinderTree& tree, core::Memory& memory) {
  core::Buffer<PointId> lowest(memory, tree.node_count());
  for (std::size_t leaf = 0; leaf < tree.nodes(0); ++leaf) {
    PointId least = tree.index(tree.first_slot(0, leaf));
    for (std::size_t slot = tree.first_slot(0, leaf); slot < tree.end_slot(0, leaf); ++slot) {
      least = std::min(least, tree.index(slot));
    }
    lowest[leaf] = least;
  }
  for (unsigned level = 1; level <= tree.top(); ++level) {
    for (std::size_t node = 0; node < tree.nodes(level); ++node) {
      const PointId* const first = lowest.data() + tree.number(level - 1, tree.first_child(node));
      const std::size_t children = tree.end_child(level, node) - tree.first_child(node);
      lowest[tree.number(level, node)] = *std::min_element(first, first + children);
    }
  }
  return lowest;
}

class NearestWalk {
 public:
  NearestWalk(const core::CylinderTree& tree, const core::Buffer<PointId>& lowest,
              const core::CylinderTests& tests, const PairOptions& options)
      : tree_(tree),
        lowest_(lowest),
        tests_(tests),
        line_(options.height_unit_m),
        unit_(options.height_unit_m) {}

  // The nearest of all but `myself`, which is no valid index between two sets.
  Nearest operator()(const core::Upright& place, PointId myself, std::size_t near_leaf) {
    place_ = place;
    myself_ = myself;
    id_ = Nearest::kNone;
    least_ = std::numeric_limits<double>::infinity();
    look_into(near_leaf);  // mostly finds a first candidate
    descend(tree_.top(), 0, near_leaf);
    if (id_ == Nearest::kNone) return {};
    return {id_, line_.length(place_, best_)};
  }

  // The leaf of the last point found.
  [[nodiscard]] std::size_t last_leaf() const { return last_leaf_; }

 private:
  void descend(unsigned level, std::size_t node, std::size_t seen) {
    if (!matters(level, node)) return;
    if (level == 0) {
      if (node != seen) look_into(node);
      return;
    }
    const std::size_t end = tree_.end_child(level, node);
    for (std::size_t child = tree_.first_child(node); child < end; ++child) {
      descend(level - 1, child, seen);
    }
  }

  // The straight line to a box is rounded as that to a place is (StraightLine::squared), so a
  // margin of 32 u covers both.
  [[nodiscard]] bool matters(unsigned level, std::size_t node) const {
    const core::UprightBox& box = tree_.box(level, node);
    if (tests_.boxes(core::UprightBox{place_.at, place_.at}, box) == core::Reach::kFar) {
      return false;
    }
    if (id_ == Nearest::kNone) return true;
    double squared = 0.0;
    for (std::size_t axis = 0; axis < core::Upright::kAxes; ++axis) {
      const double gap =
          std::max({0.0, box.low[axis] - place_.at[axis], place_.at[axis] - box.high[axis]}) *
          (axis == 0 ? unit_ : 1.0);
      squared += gap * gap;
    }
    if (squared * (1.0 - 0x1p-48) > least_) return false;
    // At the same place only a lower id is better.
    return least_ > 0.0 || lowest_[tree_.number(level, node)] < id_;
  }

  void look_into(std::size_t leaf) {
    for (std::size_t slot = tree_.first_slot(0, leaf); slot < tree_.end_slot(0, leaf); ++slot) {
      const PointId id = tree_.index(slot);
      if (id == myself_) continue;
      const core::Upright other = tree_.place(slot);
      const double squared = line_.squared(place_, other);
      if (squared * (1.0 - 0x1p-48) > least_ || !tests_.places(place_, other)) continue;
      if (id_ != Nearest::kNone) {
        const int sign = line_.compare(place_, other, place_, best_);
        if (sign > 0 || (sign == 0 && id > id_)) continue;
      }
      id_ = id;
      best_ = other;
      last_leaf_ = leaf;
      least_ = squared;
    }
  }

  const core::CylinderTree& tree_;
  const core::Buffer<PointId>& lowest_;
  const core::CylinderTests& tests_;
  core::StraightLine line_;
  double unit_;
  core::Upright place_{};
  core::Upright best_{};
  PointId myself_ = Nearest::kNone;
  PointId id_ = Nearest::kNone;
  std::size_t last_leaf_ = 0;
  double least_ = 0.0;  // the square of how far `best_` is, rounded
};

}  // namespace

Status CylinderSearch::find_nearest(std::vector<Nearest>& nearest) const {
  nearest.assign(points_.size(), Nearest{});
  const auto all = trees();
  if (!all) return std::monostate{};
  const core::CylinderTree& tree = all->points;
  const core::CylinderTree& asked = all->second();
  const core::Buffer<PointId> lowest = lowest_ids(asked, with_.memory);
  with_.crew.split(tree.size(), [&](std::size_t begin, std::size_t end, unsigned) {
    NearestWalk walk(asked, lowest, tests_, options_);
    std::size_t leaf = 0;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const PointId id = tree.index(slot);
      if (!all->others) leaf = slot / kFanOut;
      nearest[id] = walk(tree.place(slot), all->others ? Nearest::kNone : id, leaf);
      leaf = walk.last_leaf();  // neighbours mostly find neighbours
    }
  });
  return std::monostate{};
}

}  // namespace beespace::search
