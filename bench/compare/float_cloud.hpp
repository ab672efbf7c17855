// Points as the Point Cloud Library keeps them: single precision.
#pragma once

#include <beespace/point.hpp>

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <span>

namespace beespace::compare {

inline pcl::PointCloud<pcl::PointXYZ>::Ptr float_cloud(std::span<const Point> points) {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  cloud->reserve(points.size());
  for (const Point& point : points) {
    cloud->push_back(
        {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)});
  }
  return cloud;
}

}  // namespace beespace::compare
