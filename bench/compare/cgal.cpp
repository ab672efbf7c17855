// CGAL: its kd-tree ("dD Spatial Searching"), queried in the order of the tree with a query object
// of our own, which leaves out the point itself, so that search_any_point() stops at a neighbour.
#include "bench/compare/contender.hpp"
#include "bench/compare/point_queries.hpp"

#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::compare {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using TreePoint = Kernel::Point_3;
using Entry = std::pair<TreePoint, PointId>;
using Traits = CGAL::Search_traits_adapter<Entry, CGAL::First_of_pair_property_map<Entry>,
                                           CGAL::Search_traits_3<Kernel>>;
using Splitter = CGAL::Sliding_midpoint<Traits>;
using Tree = CGAL::Kd_tree<Traits, Splitter, CGAL::Tag_true, CGAL::Tag_false>;
using Distance = CGAL::Distance_adapter<Entry, CGAL::First_of_pair_property_map<Entry>,
                                        CGAL::Euclidean_distance<CGAL::Search_traits_3<Kernel>>>;
using NearestSearch = CGAL::Orthogonal_k_neighbor_search<Traits, Distance, Splitter, Tree>;
using Box = CGAL::Kd_tree_rectangle<double, CGAL::Dimension_tag<3>>;

// The open ball around a point, as CGAL's concept FuzzyQueryItem wants it.
class Ball {
 public:
  using D = Traits::Dimension;

  Ball(const TreePoint& centre, double squared) : centre_(centre), squared_(squared) {}

  [[nodiscard]] bool contains(const Entry& entry) const {
    return CGAL::squared_distance(entry.first, centre_) < squared_;
  }
  [[nodiscard]] bool inner_range_intersects(const Box& box) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double beyond =
          std::max({box.min_coord(axis) - centre_[axis], centre_[axis] - box.max_coord(axis), 0.0});
      sum += beyond * beyond;
    }
    return sum < squared_;
  }
  [[nodiscard]] bool outer_range_contains(const Box& box) const {
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double farther =
          std::max(centre_[axis] - box.min_coord(axis), box.max_coord(axis) - centre_[axis]);
      sum += farther * farther;
    }
    return sum < squared_;
  }

 private:
  TreePoint centre_;
  double squared_;
};

class BallWithoutSelf : public Ball {
 public:
  BallWithoutSelf(const TreePoint& centre, double squared, PointId self)
      : Ball(centre, squared), self_(self) {}

  [[nodiscard]] bool contains(const Entry& entry) const {
    return entry.second != self_ && Ball::contains(entry);
  }
  // A box is never taken as a whole: it might contain only the point itself.
  [[nodiscard]] bool outer_range_contains(const Box& /*box*/) const { return false; }

 private:
  PointId self_;
};

// An output iterator that CGAL may assign, which those around lambdas are not.
template <class Visit>
class Visitor {
 public:
  explicit Visitor(Visit& visit) : visit_(&visit) {}
  Visitor& operator*() { return *this; }
  Visitor& operator++() { return *this; }
  Visitor& operator++(int) { return *this; }
  Visitor& operator=(const Entry& entry) {
    (*visit_)(entry.second);
    return *this;
  }

 private:
  Visit* visit_;
};

class Queries {
 public:
  Queries(const Tree& tree, std::span<const Point> points, double threshold_m)
      : tree_(tree), points_(points), squared_(threshold_m * threshold_m) {}

  [[nodiscard]] bool has_other(PointId self) const {
    return static_cast<bool>(tree_.search_any_point(BallWithoutSelf(place(self), squared_, self)));
  }
  template <class Visit>
  void visit_near(PointId self, Visit&& visit) const {
    tree_.search(Visitor(visit), Ball(place(self), squared_));
  }
  [[nodiscard]] std::uint32_t count_others(PointId self) const {
    std::uint32_t count = 0;
    visit_near(self, [&](PointId other) { count += other != self ? 1 : 0; });
    return count;
  }
  [[nodiscard]] Nearest nearest_other(PointId self) const {
    Nearest nearest;
    const NearestSearch search(tree_, place(self), 2);
    for (const auto& [entry, squared] : search) {
      if (entry.second != self && squared < nearest.distance_m) nearest = {entry.second, squared};
    }
    nearest.distance_m = std::sqrt(nearest.distance_m);
    return nearest;
  }

 private:
  [[nodiscard]] TreePoint place(PointId id) const {
    return {points_[id].x, points_[id].y, points_[id].z};
  }

  const Tree& tree_;
  std::span<const Point> points_;
  double squared_;
};

// Measured on a million points.
constexpr unsigned kLeafSize = 20;

class Cgal final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"CGAL kd-tree",
            CGAL_VERSION_STR,
            Arithmetic::kFloat64,
            "sliding midpoint, " + std::to_string(kLeafSize) +
                " points a leaf, queried leaf by leaf, search_any_point with a query object of its "
                "own",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    std::vector<Entry> entries(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      entries[i] = {{points[i].x, points[i].y, points[i].z}, static_cast<PointId>(i)};
    }
    Tree tree(entries.begin(), entries.end(), Splitter(kLeafSize));
    tree.build();
    std::vector<PointId> order;
    order.reserve(points.size());
    for (const Entry& entry : tree) order.push_back(entry.second);
    return answer_point_by_point(question, order, Queries(tree, points, threshold_m));
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<Cgal>();
}

}  // namespace beespace::compare
