// Points that are inserted, removed and moved, kept in trees.
//
// A stack of trees, each at most an eighth of the one below, and a few recent points on top:
//
//   recent points    at most 64, in no tree yet
//   trees_[2]        at most an eighth of trees_[1]
//   trees_[1]        at most an eighth of trees_[0]
//   trees_[0]        most of the points
//
// When there are too many recent points, a tree is made of them and of all trees on top of the
// stack that would be too large to lie below it. So there are about log8(n / 64) trees at most, and
// a point is built into one a few times on its way down. A point that leaves a tree is discarded in
// its place; when half of all places are empty, everything is built anew.
#pragma once

#include "tree/point_tree.hpp"

#include <beespace/crew.hpp>
#include <beespace/points_view.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

class ChangingPoints {
 public:
  struct Recent {
    Point point;
    PointId id;
  };

  // The points, all in the domain, under the ids 0, 1, 2, ...
  ChangingPoints(const PointsView& points, const core::Bounds& bounds, Crew& crew);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t ids() const { return level_.size(); }
  [[nodiscard]] bool contains(PointId id) const { return id < ids() && level_[id] != kGone; }
  [[nodiscard]] const Point& point(PointId id) const;

  [[nodiscard]] const std::vector<core::PointTree>& trees() const { return trees_; }
  [[nodiscard]] const std::vector<Recent>& recent() const { return recent_; }

  // The id must not be in use, the point in the domain.
  PointId insert(const Point& point);
  // The id must be in use.
  void move(PointId id, const Point& point);
  void remove(PointId id);
  void rebuild(Crew& crew);

 private:
  // The place of a point: in the tree of this number, among the recent points, or none.
  using Level = std::uint8_t;
  static constexpr Level kRecent = 254;
  static constexpr Level kGone = 255;

  static constexpr std::size_t kMostRecent = 64;
  static constexpr std::size_t kShrink = 8;

  void put_among_recent(PointId id, const Point& point);
  void take_out(PointId id);
  // Makes one tree of the recent points and all trees from `first` on.
  void merge_from(std::size_t first, Crew& crew);
  void note_places(std::size_t tree);

  std::vector<core::PointTree> trees_;
  std::vector<Recent> recent_;
  std::vector<Level> level_;          // by id
  std::vector<std::uint32_t> place_;  // by id: the slot in the tree, or where in recent_
  std::size_t size_ = 0;
  std::size_t kept_ = 0;  // places in trees, empty ones included
};

}  // namespace beespace::search
