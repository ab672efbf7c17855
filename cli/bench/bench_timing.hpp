// How long things take: the middle one of several runs.
#pragma once

#include <beespace/point.hpp>

#include <functional>
#include <vector>

namespace beespace::cli {

// The floor that everything is compared with: reading all coordinates in order, which is summing
// them one after the other.
class ReadFloor {
 public:
  // The points must live as long as this does.
  explicit ReadFloor(const std::vector<Point>& points) : points_(points) {}

  // Reads them once. What that costs depends on what came before: after a search they are where the
  // next search finds them, since its working memory has evicted them from the caches.
  void pass();

  // Seconds of wall time: the median of all passes, of which there must be one.
  [[nodiscard]] double median_seconds() const;

 private:
  const std::vector<Point>& points_;
  std::vector<double> times_;
};

// Seconds of wall time: the median of at least three runs after one to warm up, and of more as long
// as they are short. A pass of the floor follows each; it does not count.
double median_seconds(const std::function<void()>& run, ReadFloor& floor);

}  // namespace beespace::cli
