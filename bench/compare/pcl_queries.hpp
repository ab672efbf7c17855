// The questions as calls of any search structure of the Point Cloud Library: its trees share them.
#pragma once

#include <beespace/nearest.hpp>
#include <beespace/point.hpp>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace beespace::compare {

template <class Tree>
class PclQueries {
 public:
  PclQueries(Tree& tree, const pcl::PointCloud<pcl::PointXYZ>& cloud, double threshold_m)
      : tree_(tree), cloud_(cloud), threshold_m_(threshold_m) {}

  bool has_other(PointId self) {
    return tree_.radiusSearch(cloud_[self], threshold_m_, ids_, squared_, 2) > 1;
  }
  template <class Visit>
  void visit_near(PointId self, Visit&& visit) {
    tree_.radiusSearch(cloud_[self], threshold_m_, ids_, squared_);
    for (const int id : ids_) visit(static_cast<PointId>(id));
  }
  std::uint32_t count_others(PointId self) {
    return static_cast<std::uint32_t>(
        tree_.radiusSearch(cloud_[self], threshold_m_, ids_, squared_) - 1);
  }
  Nearest nearest_other(PointId self) {
    tree_.nearestKSearch(cloud_[self], 2, ids_, squared_);
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      const auto id = static_cast<PointId>(ids_[i]);
      if (id != self) return {id, std::sqrt(static_cast<double>(squared_[i]))};
    }
    return {};
  }

 private:
  Tree& tree_;
  const pcl::PointCloud<pcl::PointXYZ>& cloud_;
  double threshold_m_;
  std::vector<int> ids_;
  std::vector<float> squared_;
};

}  // namespace beespace::compare
