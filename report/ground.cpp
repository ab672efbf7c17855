#include "report/ground.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::report {
namespace {

// Coasts are simplified by up to 2 km: over less than this they would mislead.
constexpr double kWide_m = 100'000.0;

constexpr std::string_view kBegin = "<script type=\"text/plain\" id=\"beespace-ground\">";

class Extent {
 public:
  void add(const Point& place) {
    least_ = {std::min(least_.x, place.x), std::min(least_.y, place.y), 0.0};
    most_ = {std::max(most_.x, place.x), std::max(most_.y, place.y), 0.0};
  }
  [[nodiscard]] Ground ground() const {
    const double wide_m = std::max(most_.x - least_.x, most_.y - least_.y);
    return wide_m >= kWide_m ? Ground::kWith : Ground::kWithout;
  }

 private:
  Point least_{HUGE_VAL, HUGE_VAL, 0.0};
  Point most_{-HUGE_VAL, -HUGE_VAL, 0.0};
};

}  // namespace

Ground ground_of(const SnapshotFacts& facts) {
  if (!facts.swarm.origin) return Ground::kWithout;
  Extent extent;
  for (const Point& place : facts.positions) extent.add(place);
  return extent.ground();
}

Ground ground_of(const RecordingFacts& facts) {
  if (!facts.swarm.origin) return Ground::kWithout;
  Extent extent;
  for (const Track& track : facts.tracks) {
    for (const Fix& fix : track.fixes) extent.add(fix.position);
  }
  return extent.ground();
}

std::pair<std::string_view, std::string_view> around_ground(std::string_view page) {
  const std::size_t begin = page.find(kBegin);
  if (begin == std::string_view::npos) return {page, {}};
  const std::size_t end = page.find('\n', begin);
  return {page.substr(0, begin), end == std::string_view::npos ? "" : page.substr(end + 1)};
}

}  // namespace beespace::report
