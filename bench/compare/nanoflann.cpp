// nanoflann: a kd-tree in headers only. Queried in the order of its own leaves, with result sets
// that stop at the first neighbour, or count without keeping.
//
// The variant "sorted" copies the points in Morton order first: the tree refers to the caller's
// points, so this keeps the points of a leaf together in memory.
#include "bench/compare/contender.hpp"
#include "bench/compare/point_queries.hpp"
#include "bench/compare/space_order.hpp"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beespace::compare {
namespace {

class Cloud {
 public:
  explicit Cloud(std::span<const Point> points) : points_(points) {}

  [[nodiscard]] std::size_t kdtree_get_point_count() const { return points_.size(); }
  [[nodiscard]] double kdtree_get_pt(std::size_t index, std::size_t axis) const {
    return (&points_[index].x)[axis];
  }
  template <class Box>
  bool kdtree_get_bbox(Box& /*box*/) const {
    return false;
  }

 private:
  std::span<const Point> points_;
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 3, PointId>;

// The interface that nanoflann requires of a result set. addPoint() returns whether to go on.
class OtherThanSelf {
 public:
  using DistanceType = double;
  OtherThanSelf(PointId self, double worst) : self_(self), worst_(worst) {}

  [[nodiscard]] bool full() const { return true; }
  [[nodiscard]] double worstDist() const { return worst_; }

 protected:
  PointId self_;
  double worst_;
};

class AnyOther : public OtherThanSelf {
 public:
  using OtherThanSelf::OtherThanSelf;
  bool addPoint(double /*squared*/, PointId id) {
    found_ = id != self_;
    return !found_;
  }
  [[nodiscard]] bool found() const { return found_; }

 private:
  bool found_ = false;
};

template <class Visit>
class VisitAll : public OtherThanSelf {
 public:
  VisitAll(PointId self, double worst, Visit& visit) : OtherThanSelf(self, worst), visit_(visit) {}
  bool addPoint(double /*squared*/, PointId id) {
    visit_(id);
    return true;
  }

 private:
  Visit& visit_;
};

class NearestOther : public OtherThanSelf {
 public:
  using OtherThanSelf::OtherThanSelf;
  bool addPoint(double squared, PointId id) {
    if (id != self_ && squared < worst_) {
      worst_ = squared;
      id_ = id;
    }
    return true;
  }
  [[nodiscard]] Nearest nearest() const { return {id_, std::sqrt(worst_)}; }

 private:
  PointId id_ = Nearest::kNone;
};

// The tree offers only points whose squared distance is below worstDist().
class Queries {
 public:
  Queries(const Tree& tree, std::span<const Point> points, double threshold_m)
      : tree_(tree), points_(points), squared_(threshold_m * threshold_m) {}

  [[nodiscard]] bool has_other(PointId self) const {
    AnyOther results(self, squared_);
    search(results, self);
    return results.found();
  }
  template <class Visit>
  void visit_near(PointId self, Visit&& visit) const {
    VisitAll results(self, squared_, visit);
    search(results, self);
  }
  [[nodiscard]] std::uint32_t count_others(PointId self) const {
    std::uint32_t count = 0;
    visit_near(self, [&](PointId other) { count += other != self ? 1 : 0; });
    return count;
  }
  [[nodiscard]] Nearest nearest_other(PointId self) const {
    NearestOther results(self, std::numeric_limits<double>::infinity());
    search(results, self);
    return results.nearest();
  }

 private:
  template <class Results>
  void search(Results& results, PointId self) const {
    tree_.findNeighbors(results, &points_[self].x, nanoflann::SearchParams());
  }

  const Tree& tree_;
  std::span<const Point> points_;
  double squared_;
};

// Measured on a million points.
constexpr std::size_t kLeafSize = 32;

class Nanoflann final : public Contender {
 public:
  explicit Nanoflann(bool sorts_first) : sorts_first_(sorts_first) {}

  [[nodiscard]] Description description() const override {
    const unsigned version = NANOFLANN_VERSION;
    return {sorts_first_ ? "nanoflann, sorted" : "nanoflann",
            std::to_string(version >> 8u) + "." + std::to_string((version >> 4u) & 15u) + "." +
                std::to_string(version & 15u),
            Arithmetic::kFloat64,
            std::string(sorts_first_ ? "points copied in Morton order first; " : "") + "kd-tree, " +
                std::to_string(kLeafSize) +
                " points a leaf, queried leaf by leaf, own result sets that stop early",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    if (!sorts_first_) return answer_in_order(question, points, threshold_m);
    const std::vector<PointId> order = space_order(points);
    std::vector<Point> sorted(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) sorted[i] = points[order[i]];
    return with_ids(answer_in_order(question, sorted, threshold_m), order);
  }

 private:
  static Answer answer_in_order(Question question, std::span<const Point> points,
                                double threshold_m) {
    const Cloud cloud(points);
    const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(kLeafSize));
    return answer_point_by_point(question, tree.vAcc, Queries(tree, points, threshold_m));
  }

  // The answer about points in an order of their own, converted to the caller's ids.
  static Answer with_ids(Answer answer, const std::vector<PointId>& order) {
    std::vector<char> marks(order.size());
    for (const PointId id : answer.at_risk) marks[order[id]] = 1;
    answer.at_risk = ids_of_marks(marks);
    for (Pair& pair : answer.pairs) {
      const auto [first, second] = std::minmax(order[pair.first], order[pair.second]);
      pair = {first, second};
    }
    std::vector<Nearest> nearest(answer.nearest.size());
    for (std::size_t i = 0; i < nearest.size(); ++i) {
      const Nearest& found = answer.nearest[i];
      const PointId id = found.id == Nearest::kNone ? found.id : order[found.id];
      nearest[order[i]] = {id, found.distance_m};
    }
    std::vector<std::uint32_t> counts(answer.counts.size());
    for (std::size_t i = 0; i < counts.size(); ++i) counts[order[i]] = answer.counts[i];
    answer.nearest = std::move(nearest);
    answer.counts = std::move(counts);
    return answer;
  }

  bool sorts_first_;
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view variant) {
  return std::make_unique<Nanoflann>(variant == "sorted");
}

}  // namespace beespace::compare
