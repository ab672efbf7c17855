// Boost.Geometry: an R-tree, packed from all points at once and queried in the order of its leaves.
#include "bench/compare/contender.hpp"
#include "bench/compare/point_queries.hpp"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <boost/version.hpp>

#include <cmath>
#include <utility>

namespace beespace::compare {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<TreePoint, PointId>;
// Measured on a million points.
constexpr std::size_t kMostPerNode = 8;
using Tree = bgi::rtree<Entry, bgi::linear<kMostPerNode>>;

double squared_distance(const TreePoint& a, const TreePoint& b) {
  const double x = bg::get<0>(a) - bg::get<0>(b);
  const double y = bg::get<1>(a) - bg::get<1>(b);
  const double z = bg::get<2>(a) - bg::get<2>(b);
  return x * x + y * y + z * z;
}

class Queries {
 public:
  Queries(const Tree& tree, std::span<const Point> points, double threshold_m)
      : tree_(tree), points_(points), squared_(threshold_m * threshold_m) {
    // The box must hold the ball whichever way its corners are rounded.
    half_side_ = threshold_m * (1.0 + 1e-9);
  }

  [[nodiscard]] bool has_other(PointId self) const {
    const TreePoint centre = place(self);
    const auto is_near_other = [&](const Entry& entry) {
      return entry.second != self && squared_distance(entry.first, centre) < squared_;
    };
    return tree_.qbegin(bgi::intersects(box(self)) && bgi::satisfies(is_near_other)) !=
           tree_.qend();
  }
  template <class Visit>
  void visit_near(PointId self, Visit&& visit) const {
    const TreePoint centre = place(self);
    const auto check = [&](const Entry& entry) {
      if (squared_distance(entry.first, centre) < squared_) visit(entry.second);
    };
    tree_.query(bgi::intersects(box(self)), boost::make_function_output_iterator(check));
  }
  [[nodiscard]] std::uint32_t count_others(PointId self) const {
    std::uint32_t count = 0;
    visit_near(self, [&](PointId other) { count += other != self ? 1 : 0; });
    return count;
  }
  [[nodiscard]] Nearest nearest_other(PointId self) const {
    Nearest nearest;
    const TreePoint centre = place(self);
    const auto keep_other = [&](const Entry& entry) {
      if (entry.second == self) return;
      const double squared = squared_distance(entry.first, centre);
      if (squared < nearest.distance_m) nearest = {entry.second, squared};
    };
    tree_.query(bgi::nearest(centre, 2), boost::make_function_output_iterator(keep_other));
    nearest.distance_m = std::sqrt(nearest.distance_m);
    return nearest;
  }

 private:
  [[nodiscard]] TreePoint place(PointId id) const {
    return {points_[id].x, points_[id].y, points_[id].z};
  }
  [[nodiscard]] bg::model::box<TreePoint> box(PointId id) const {
    const Point& point = points_[id];
    return {{point.x - half_side_, point.y - half_side_, point.z - half_side_},
            {point.x + half_side_, point.y + half_side_, point.z + half_side_}};
  }

  const Tree& tree_;
  std::span<const Point> points_;
  double squared_;
  double half_side_;
};

class BoostRtree final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    std::string version = BOOST_LIB_VERSION;
    for (char& letter : version) {
      if (letter == '_') letter = '.';
    }
    return {"Boost.Geometry R-tree",
            version,
            Arithmetic::kFloat64,
            "packed, at most " + std::to_string(kMostPerNode) +
                " entries a node, queried leaf by leaf, stops at the first neighbour",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    std::vector<Entry> entries(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      entries[i] = {{points[i].x, points[i].y, points[i].z}, static_cast<PointId>(i)};
    }
    const Tree tree(entries);
    std::vector<PointId> order;
    order.reserve(points.size());
    for (const Entry& entry : tree) order.push_back(entry.second);
    return answer_point_by_point(question, order, Queries(tree, points, threshold_m));
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<BoostRtree>();
}

}  // namespace beespace::compare
