#include "io/frames/frame_decision.hpp"

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
constexpr std::size_t kSwarm = 30;             // points that it takes to speak of a pillar

constexpr const char* kSayFrame =
    "say it with --crs wgs84 (longitude, latitude in degrees) or --crs metres, or, of another "
    "length, with --units position=mm (or cm, ft)";

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

bool is_whole(double value) {
  return std::floor(value) == value;
}

// One coordinate of all points.
struct Span {
  double lowest;
  double highest;

  [[nodiscard]] double width() const { return highest - lowest; }
  [[nodiscard]] double magnitude() const { return greatest_magnitude(lowest, highest); }
  [[nodiscard]] bool whole() const { return is_whole(lowest) && is_whole(highest); }
};

Span span_of(const Extent& extent, std::size_t axis) {
  switch (axis) {
    case 0:
      return {extent.lowest.x, extent.highest.x};
    case 1:
      return {extent.lowest.y, extent.highest.y};
    default:
      return {extent.lowest.z, extent.highest.z};
  }
}

// Whether two columns could be the longitude and latitude of a swarm: a small patch of degrees,
// with decimals, far from the origin.
bool could_be_degrees(const Span& longitude, const Span& latitude) {
  if (longitude.magnitude() > kGreatestLongitude || latitude.magnitude() > kGreatestLatitude) {
    return false;
  }
  if (longitude.whole() && latitude.whole()) return false;
  const double width = std::max(longitude.width(), latitude.width());
  const double distance =
      std::hypot(longitude.lowest + longitude.width() / 2, latitude.lowest + latitude.width() / 2);
  return distance > 0.0 && distance >= kPillarRemoteness * width;
}

Error refusal(const std::string& why) {
  return {ErrorCode::kUnknownFrame, "degrees or metres? " + why, {}};
}

// What to say where the values do not show the order.
constexpr const char* kSayOrder =
    "say --crs wgs84 if they are longitude, latitude, height in this order, name the columns of a "
    "table with --columns lat=1,lon=2,height=3, or say --crs metres";

// Whether the first coordinate is 0, 1, 2, ... or 1, 2, 3, ...
bool counts_rows(std::span<const Point> points) {
  if (points.size() < 3 || (points[0].x != 0.0 && points[0].x != 1.0)) return false;
  const double first = points[0].x;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].x != first + static_cast<double>(i)) return false;
  }
  return true;
}

// Why values beyond degrees may still not be metres.
std::optional<Error> hidden_degrees(std::span<const Point> points, const Extent& extent,
                                    std::size_t dimensions, Naming naming) {
  constexpr double kScaledDegrees = 1e7;
  const std::size_t columns = naming == Naming::kNone ? dimensions : 2;
  for (std::size_t first = 0; first < columns; ++first) {
    for (std::size_t second = 0; second < columns; ++second) {
      if (first == second || !could_be_degrees(span_of(extent, first), span_of(extent, second))) {
        continue;
      }
      return refusal("The values of columns " + std::to_string(first + 1) + " and " +
                     std::to_string(second + 1) +
                     " of the position could be longitude and latitude; " + kSayOrder);
    }
  }
  const Span x = span_of(extent, 0);
  const Span y = span_of(extent, 1);
  if (x.whole() && y.whole() && std::max(x.magnitude(), y.magnitude()) >= kScaledDegrees) {
    return refusal(
        "Whole numbers of this size may be degrees times 10,000,000; divide them by that, or say "
        "--crs metres");
  }
  if (naming == Naming::kNone && dimensions == 3 && counts_rows(points)) {
    return refusal(
        "The first column counts the records; if it is no coordinate say --columns id=1 and name "
        "the others, otherwise --crs metres");
  }
  return std::nullopt;
}

// Some values are beyond degrees. Metres, unless nearly all of them look like degrees.
Result<FrameDecision> beyond_degrees(std::span<const Point> points, const Extent& extent,
                                     std::size_t dimensions, Naming naming) {
  const auto odd = [](const Point& point) { return !fits_degrees(point); };
  const auto count = static_cast<double>(std::count_if(points.begin(), points.end(), odd));
  if (count < 0.1 * static_cast<double>(points.size())) {
    const auto first = std::find_if(points.begin(), points.end(), odd);
    Error error =
        refusal("Nearly all records would fit degrees, but " + number_text(first->x) + ", " +
                number_text(first->y) + " here does not; correct it, or " + kSayFrame);
    error.location.record = static_cast<std::uint64_t>(first - points.begin());
    return error;
  }
  if (auto hidden = hidden_degrees(points, extent, dimensions, naming)) return *std::move(hidden);
  const double first = span_of(extent, 0).magnitude();
  const double second = span_of(extent, 1).magnitude();
  const bool by_first = first > kGreatestLongitude;
  return FrameDecision{Frame::kMetres,
                       std::string("the values do not fit degrees: the ") +
                           (by_first ? "first" : "second") + " coordinate reaches " +
                           number_text(by_first ? first : second) + ", beyond " +
                           (by_first ? "360" : "90"),
                       {}};
}

bool all_fit_degrees(const Extent& extent) {
  return span_of(extent, 0).magnitude() <= kGreatestLongitude &&
         span_of(extent, 1).magnitude() <= kGreatestLatitude;
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

Result<FrameDecision> frame_from_values(std::span<const Point> points, const Extent& extent,
                                        std::size_t dimensions, Naming naming) {
  if (!all_fit_degrees(extent)) return beyond_degrees(points, extent, dimensions, naming);
  if (!is_pillar(extent)) {
    return refusal(std::string("The values fit both and no header tells; ") + kSayFrame);
  }
  if (naming != Naming::kNone) {
    return refusal(
        "The header names x and y, but the values look like longitude, latitude and height; " +
        std::string(kSayFrame));
  }
  // Beyond 90 the first column cannot be the latitude; below, either order is possible.
  if (span_of(extent, 0).magnitude() <= kGreatestLatitude || points.size() < kSwarm) {
    return refusal(
        std::string(
            "The values look like degrees, but do not show which column is the longitude; ") +
        kSayOrder);
  }
  const double width = std::max(span_of(extent, 0).width(), span_of(extent, 1).width());
  return FrameDecision{Frame::kWgs84,
                       "the values fit degrees, and in metres the swarm would be a pillar " +
                           number_text(width) + " m wide and " +
                           number_text(span_of(extent, 2).width()) + " m tall, far from the origin",
                       "no header tells the order of the columns: longitude, latitude, height is "
                       "taken, for the first reaches beyond 90"};
}

std::optional<Error> contradiction_to_metres(std::span<const Point> points, const Extent& extent,
                                             std::size_t dimensions) {
  const Span x = span_of(extent, 0);
  const Span y = span_of(extent, 1);
  // Points at one place are at one place in either frame.
  if (points.empty() || !all_fit_degrees(extent) || std::max(x.width(), y.width()) == 0.0) {
    return std::nullopt;
  }
  const bool flat = dimensions == 3 && span_of(extent, 2).width() == 0.0;
  bool doubtful = is_pillar(extent) || (flat && could_be_degrees(x, y));
  if (dimensions == 2) {
    doubtful = std::any_of(points.begin(), points.end(), [](const Point& point) {
      return !is_whole(point.x) || !is_whole(point.y);
    });
  }
  if (!doubtful) return std::nullopt;
  return refusal(
      "The header names x and y, but the values could as well be longitude and latitude; " +
      std::string(kSayFrame));
}

}  // namespace beespace::io
