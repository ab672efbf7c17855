// The Point Cloud Library's octree, in single precision, queried along a Morton curve.
#include "bench/compare/contender.hpp"
#include "bench/compare/float_cloud.hpp"
#include "bench/compare/pcl_queries.hpp"
#include "bench/compare/point_queries.hpp"
#include "bench/compare/space_order.hpp"

#include <pcl/octree/octree_search.h>
#include <pcl/pcl_config.h>

namespace beespace::compare {
namespace {

class PclOctree final : public Contender {
 public:
  [[nodiscard]] Description description() const override {
    return {"PCL octree",
            PCL_VERSION_PRETTY,
            Arithmetic::kFloat32,
            "OctreePointCloudSearch, voxels of one threshold, queried in Morton order, at most two "
            "results for at risk",
            {Question::kAtRisk, Question::kPairs, Question::kNearest, Question::kCounts}};
  }

  Answer answer(Question question, std::span<const Point> points, double threshold_m) override {
    const auto cloud = float_cloud(points);
    pcl::octree::OctreePointCloudSearch<pcl::PointXYZ> tree(threshold_m);
    tree.setInputCloud(cloud);
    tree.addPointsFromInputCloud();
    return answer_point_by_point(question, space_order(points),
                                 PclQueries(tree, *cloud, threshold_m));
  }
};

}  // namespace

std::unique_ptr<Contender> make_contender(std::string_view) {
  return std::make_unique<PclOctree>();
}

}  // namespace beespace::compare
