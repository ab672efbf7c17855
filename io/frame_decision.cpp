#include "io/frame_decision.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace beespace::io {
namespace {

constexpr double kGreatestLongitude = 360.0;
constexpr double kGreatestLatitude = 90.0;
constexpr double kPillarSlenderness = 1000.0;  // times taller than wide
constexpr double kPillarRemoteness = 10.0;     // widths away from the origin

constexpr const char* kSayFrame =
    "say it with --crs wgs84 (longitude, latitude in degrees) or --crs metres";

std::string number_text(double value) {
  std::array<char, 32> text = {};
  const auto result =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return std::string(text.data(), result.ptr);
}

bool fits_degrees(const Point& point) {
  return std::abs(point.x) <= kGreatestLongitude && std::abs(point.y) <= kGreatestLatitude;
}

double greatest_magnitude(double lowest, double highest) {
  return std::max(std::abs(lowest), std::abs(highest));
}

bool is_pillar(const Extent& extent) {
  const double width_x = extent.highest.x - extent.lowest.x;
  const double width_y = extent.highest.y - extent.lowest.y;
  const double width = std::max(width_x, width_y);
  const double tall = extent.highest.z - extent.lowest.z;
  const double centre_x = extent.lowest.x + width_x / 2;
  const double centre_y = extent.lowest.y + width_y / 2;
  return width > 0.0 && tall >= kPillarSlenderness * width &&
         std::hypot(centre_x, centre_y) >= kPillarRemoteness * width;
}

// Some values are beyond degrees. Metres, unless nearly all of them look like degrees.
Result<FrameDecision> beyond_degrees(std::span<const Point> points, const Extent& extent) {
  const auto odd = [](const Point& point) { return !fits_degrees(point); };
  const auto count = static_cast<double>(std::count_if(points.begin(), points.end(), odd));
  if (count < 0.1 * static_cast<double>(points.size())) {
    const auto first = std::find_if(points.begin(), points.end(), odd);
    return Error{ErrorCode::kUnknownFrame,
                 "degrees or metres? Nearly all records would fit degrees, but " +
                     number_text(first->x) + ", " + number_text(first->y) +
                     " here does not; correct it, or " + kSayFrame,
                 {"", {}, {}, static_cast<std::uint64_t>(first - points.begin())}};
  }
  const double first = greatest_magnitude(extent.lowest.x, extent.highest.x);
  const double second = greatest_magnitude(extent.lowest.y, extent.highest.y);
  const bool by_first = first > kGreatestLongitude;
  return FrameDecision{Frame::kMetres, std::string("the values do not fit degrees: the ") +
                                           (by_first ? "first" : "second") +
                                           " coordinate reaches " +
                                           number_text(by_first ? first : second) + ", beyond " +
                                           (by_first ? "360" : "90")};
}

}  // namespace

void Extent::include(const Extent& other) {
  lowest = {std::min(lowest.x, other.lowest.x), std::min(lowest.y, other.lowest.y),
            std::min(lowest.z, other.lowest.z)};
  highest = {std::max(highest.x, other.highest.x), std::max(highest.y, other.highest.y),
             std::max(highest.z, other.highest.z)};
}

Extent extent_of(std::span<const Point> points) {
  Extent extent;
  for (const Point& point : points) extent.include({point, point});
  return extent;
}

FrameDecision frame_before_values(Frame asked, const FrameEvidence& evidence) {
  if (asked == Frame::kWgs84) return {asked, "asked for with --crs wgs84"};
  if (asked == Frame::kMetres) return {asked, "asked for with --crs metres"};
  return {evidence.frame, evidence.reason};
}

Result<FrameDecision> frame_from_values(std::span<const Point> points, const Extent& extent) {
  const bool all_fit =
      greatest_magnitude(extent.lowest.x, extent.highest.x) <= kGreatestLongitude &&
      greatest_magnitude(extent.lowest.y, extent.highest.y) <= kGreatestLatitude;
  if (!all_fit) return beyond_degrees(points, extent);
  const double width =
      std::max(extent.highest.x - extent.lowest.x, extent.highest.y - extent.lowest.y);
  if (is_pillar(extent)) {
    return FrameDecision{Frame::kWgs84,
                         "the values fit degrees, and in metres the swarm would be a pillar " +
                             number_text(width) + " m wide and " +
                             number_text(extent.highest.z - extent.lowest.z) +
                             " m tall, far from the origin"};
  }
  return Error{
      ErrorCode::kUnknownFrame,
      std::string("degrees or metres? The values fit both and no header tells; ") + kSayFrame,
      {}};
}

}  // namespace beespace::io
