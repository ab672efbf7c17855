// Counts the pairs of two sets of points that are tiny next to their distance from each other.
//
// Seen from so far away, the sets are next to one-dimensional: which points are near is, but for a
// thin slab, a matter of how far along the line between the sets they are. So one set is sorted
// along that line, and for each point of the other the first ones of it are counted at once.
//
// With corners A and B of the boxes, D = B - A, and points A + P and B + Q:
//   |D + Q - P|^2 = |D|^2 + 2 D Q - 2 D P + |Q - P|^2,   0 <= |Q - P|^2 <= G,
// where G follows from the boxes. So with w = 2 D Q, v = 2 D P, and C = T^2 - |D|^2,
//   w < v + C - G proves that the points are closer than T, w > v + C that they are not.
// Rounding. D, P and Q are right to u = 2^-53 relatively, axis by axis, so v and w to less than
// 16 u S with S = sum of |D_i| times both sizes of the boxes on axis i; C, of two doubles, to
// u |C| + 2^-98 (T^2 + |D|^2); the sums of these lose a few u (S + |C| + G). All that is less than
//   E = 2^-46 (S + |C| + G) + 2^-96 (T^2 + |D|^2),
// which is added to both limits. What is between them is decided exactly.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "tree/box_tree.hpp"

#include <cstddef>
#include <cstdint>

namespace beespace::cpu {

// A node of a tree; by slot of the tree, how many points there are, and where their counts are
// added up; null: they are not wanted.
struct LineSide {
  const core::BoxTree& tree;
  core::BoxNode node;
  const std::uint32_t* weights;
  std::uint32_t* sums;

  [[nodiscard]] std::size_t first() const { return tree.first_slot(node); }
  [[nodiscard]] std::size_t end() const { return tree.end_slot(node); }
};

class LineCounts {
 public:
  // The test must outlive this object.
  LineCounts(double threshold, const core::ProximityTest& closer, core::Memory& memory)
      : threshold_(threshold),
        closer_(closer),
        sorted_(&memory),
        added_(&memory),
        found_(&memory) {}

  // Whether two boxes are small enough, if their distance is about the threshold.
  [[nodiscard]] bool suits(const core::Bounds& a, const core::Bounds& b) const;

  // Counts the pairs of points of two nodes. False, with nothing counted, where so many are between
  // the limits that they had better be told apart by smaller boxes. Cost: of sorting the second.
  bool count(const LineSide& one, const LineSide& two);

 private:
  struct Key {
    double along;
    std::uint32_t slot;
  };
  struct Found {
    std::uint32_t near;       // the first ones of the sorted are near
    std::uint32_t not_after;  // from there on they are far
  };
  // From a point's v to the limits of w.
  struct Limits {
    double near;
    double far;
  };

  [[nodiscard]] Limits limits(const core::Bounds& a, const core::Bounds& b) const;
  void sort(const LineSide& two, const Point& corner);
  bool find(const LineSide& one, const Point& corner, const Limits& limits);
  void add(const LineSide& one, const LineSide& two);
  void decide(const LineSide& one, std::size_t slot, const LineSide& two, const Found& found);
  [[nodiscard]] double along(const Point& point, const Point& corner) const;

  double threshold_;
  const core::ProximityTest& closer_;
  Point towards_;                      // twice D
  core::Vector<Key> sorted_;           // of the second set
  core::Vector<std::uint32_t> added_;  // to all before a place of the sorted
  core::Vector<Found> found_;          // of each point of the first set
};

}  // namespace beespace::cpu
