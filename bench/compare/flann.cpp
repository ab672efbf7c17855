// FLANN: its single kd-tree, which is exact, queried along a Morton curve with result sets of our
// own.
#include "bench/compare/contender.hpp"
#include "bench/compare/point_queries.hpp"
#include "bench/compare/space_order.hpp"

#include <flann/flann.hpp>

#include <cmath>
#include <limits>

namespace beespace::compare {
namespace {

using Metric = flann::L2_Simple<double>;
using Tree = flann::KDTreeSingleIndex<Metric>;

// The tree goes on while it finds points nearer than worstDist(): nothing is after a neighbour.
class AnyOther final : public flann::ResultSet<double> {
 public:
  AnyOther(PointId self, double squared) : self_(self), worst_(squared) {}
  [[nodiscard]] bool full() const override { return true; }
  void addPoint(double squared, std::size_t id) override {
    if (id != self_ && squared < worst_) worst_ = -1.0;
  }
  [[nodiscard]] double worstDist() const override { return worst_; }
  [[nodiscard]] bool found() const { return worst_ < 0.0; }

 private:
  PointId self_;
  double worst_;
};

template <class Visit>
class VisitAll final : public flann::ResultSet<double> {
 public:
  VisitAll(double squared, Visit& visit) : squared_(squared), visit_(visit) {}
  [[nodiscard]] bool full() const override { return true; }
  void addPoint(double squared, std::size_t id) override {
    if (squared < squared_) visit_(static_cast<PointId>(id));
  }
  [[nodiscard]] double worstDist() const override { return squared_; }

 private:
  double squared_;
  Visit& visit_;
};

class NearestOther final : public flann::ResultSet<double> {
 public:
  explicit NearestOther(PointId self) : self_(self) {}
  [[nodiscard]] bool full() const override { return true; }
  void addPoint(double squared, std::size_t id) override {
    if (id == self_ || squared >= worst_) return;
    worst_ = squared;
    id_ = static_cast<PointId>(id);
  }
  [[nodiscard]] double worstDist() const override { return worst_; }
  [[nodiscard]] Nearest nearest() const { return {id_, std::sqrt(worst_)}; }

 private:
  PointId self_;
  PointId id_ = Nearest::kNone;
  double worst_ = std::numeric_limits<double>::infinity();
};

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
    VisitAll results(squared_, visit);
    search(results, self);
  }
  [[nodiscard]] std::uint32_t count_others(PointId self) const {
    std::uint32_t count = 0;
    visit_near(self, [&](PointId other) { count += other != self ? 1 : 0; });
    return count;
  }
  [[nodiscard]] Nearest nearest_other(PointId self) const {
    NearestOther results(self);
    search(results, self);
    return results.nearest();
  }

 private:
  void search(flann::ResultSet<double>& results, PointId self) const {
    tree_.findNeighbors(results, &points_[self].x, search_);
  }

  const Tree& tree_;
  std::span<const Point> points_;
  double squared_;
  flann::SearchParams search_{flann::FLANN_CHECKS_UNLIMITED, 0.0F, false};
};

// Measured on a million points.
constexpr int kLeafSize = 32;

class Flann final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"FLANN",
            FLANN_VERSION_,
            Arithmetic::kFloat64,
            "single kd-tree, " + std::to_string(kLeafSize) +
                " points a leaf, points reordered, queried in Morton order",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    // FLANN does not change its input, but its matrix is not for constants.
    const flann::Matrix<double> matrix(const_cast<double*>(&points.front().x), points.size(), 3);
    Tree tree(matrix, flann::KDTreeSingleIndexParams(kLeafSize, true));
    tree.buildIndex();
    return answer_point_by_point(question, space_order(points), Queries(tree, points, threshold_m));
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<Flann>();
}

}  // namespace beespace::compare
