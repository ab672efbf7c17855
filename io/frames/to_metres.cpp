#include "io/frames/to_metres.hpp"

#include "io/bytes/worker_threads.hpp"

#include <beespace/geodesy.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

namespace beespace::io {
namespace {

bool in_domain(double coordinate) {
  const double magnitude = std::abs(coordinate);
  return magnitude == 0.0 ||
         (magnitude >= kSmallestCoordinate_m && magnitude <= kLargestCoordinate_m);
}

std::optional<std::size_t> bad_axis(const Point& point, Frame frame, ErrorCode& code) {
  if (frame == Frame::kWgs84) {
    if (!(std::abs(point.x) <= 360.0)) return code = ErrorCode::kInvalidLongitude, 0;
    if (!(std::abs(point.y) <= 90.0)) return code = ErrorCode::kInvalidLatitude, 1;
    code = ErrorCode::kInvalidHeight;
    if (!(point.z >= kLowestHeight_m && point.z <= kGreatestHeight_m)) return 2;
    return std::nullopt;
  }
  code = ErrorCode::kOutsideDomain;
  if (!in_domain(point.x)) return 0;
  if (!in_domain(point.y)) return 1;
  if (!in_domain(point.z)) return 2;
  return std::nullopt;
}

constexpr std::string_view kUnknownAdvice =
    ", and seems to stand for a place that is not known; leave such records out with --skip-bad, "
    "or empty their fields";

// 999, -9999.99: nines alone, as many tools write where they know nothing.
bool stands_for_unknown(double value) {
  constexpr std::array<double, 8> kNines = {999.0,     9999.0,     99999.0,     999999.0,
                                            9999999.0, 99999999.0, 999999999.0, 9999999999.0};
  const double magnitude = std::abs(value);
  return std::any_of(kNines.begin(), kNines.end(), [magnitude](double nines) {
    return magnitude >= nines && magnitude < nines + 1.0;
  });
}

}  // namespace

bool surely_in_range(const Extent& extent, Frame frame) {
  const Point& low = extent.lowest;
  const Point& high = extent.highest;
  if (frame == Frame::kWgs84) {
    return low.x >= -360.0 && high.x <= 360.0 && low.y >= -90.0 && high.y <= 90.0 &&
           low.z >= kLowestHeight_m && high.z <= kGreatestHeight_m;
  }
  // A box does not show coordinates that are too small.
  return false;
}

std::optional<RangeProblem> find_out_of_range(std::span<const Point> points, std::size_t from,
                                              Frame frame) {
  ErrorCode code = ErrorCode::kOutsideDomain;
  for (std::size_t i = from; i < points.size(); ++i) {
    if (const auto axis = bad_axis(points[i], frame, code)) return RangeProblem{i, *axis, code};
  }
  return std::nullopt;
}

Error range_error(const RangeProblem& problem, const Point& point, const std::string& shown,
                  std::string_view unit) {
  std::string message;
  switch (problem.code) {
    case ErrorCode::kInvalidLongitude:
      message = "longitude " + shown + " is beyond 360 degrees";
      message += stands_for_unknown(point.x)
                     ? std::string(kUnknownAdvice)
                     : "; correct it, or say --crs metres if these are metres";
      break;
    case ErrorCode::kInvalidLatitude:
      message = "latitude " + shown + " is beyond 90 degrees";
      message += stands_for_unknown(point.y) ? std::string(kUnknownAdvice)
                 : std::abs(point.x) <= 90.0
                     ? "; are longitude and latitude swapped? Then say --columns lon=2,lat=1,..."
                     : "; correct it, or say --crs metres if these are metres";
      break;
    case ErrorCode::kInvalidHeight:
      message = "height " + shown + " " + std::string(unit) +
                " is no height of a bee (-12,000 to 1,000,000 m); is it in "
                "millimetres or feet (see --units), or are columns swapped? See --columns";
      break;
    default:
      message = "coordinate " + shown + " is too " +
                (shown.find("e-") != std::string::npos ? "small" : "large") +
                " to compare exactly; use 0, or 3.9e-121 m to 2.6e+120 m";
      break;
  }
  return {problem.code, std::move(message), {}};
}

void skip_out_of_range(std::vector<Point>& points, Frame frame, SkippedRecords& skipped,
                       const Explain& explain) {
  SkippedRecords found;
  std::size_t kept = 0;
  std::size_t done = 0;
  while (const auto problem = find_out_of_range(points, done, frame)) {
    std::copy(points.begin() + static_cast<std::ptrdiff_t>(done),
              points.begin() + static_cast<std::ptrdiff_t>(problem->index),
              points.begin() + static_cast<std::ptrdiff_t>(kept));
    kept += problem->index - done;
    done = problem->index + 1;
    const std::uint64_t row = skipped.row_of(problem->index);
    found.rows.push_back(row);
    if (found.errors.size() < kMostSkippedListed) {
      found.errors.push_back(explain(row, points[problem->index], *problem));
    }
  }
  std::copy(points.begin() + static_cast<std::ptrdiff_t>(done), points.end(),
            points.begin() + static_cast<std::ptrdiff_t>(kept));
  points.resize(kept + points.size() - done);
  skipped.merge(std::move(found));
}

Status convert_to_metres(std::span<Point> points, Frame frame, unsigned threads) {
  constexpr std::size_t kLeastPerThread = 10'000;
  if (frame != Frame::kWgs84) return std::monostate{};
  const std::size_t workers =
      std::clamp<std::size_t>(points.size() / kLeastPerThread, 1, std::max(threads, 1u));
  std::vector<std::optional<Error>> errors(workers);
  run_on_threads(static_cast<unsigned>(workers), [&](unsigned worker) {
    const std::size_t begin = points.size() * worker / workers;
    const std::size_t end = points.size() * (worker + std::size_t{1}) / workers;
    const std::span<Point> part = points.subspan(begin, end - begin);
    Status status = to_ecef(PointsView(std::span<const Point>(part)), part);
    if (!status) errors[worker] = status.error();
  });
  for (auto& error : errors) {
    if (error) return *std::move(error);
  }
  return std::monostate{};
}

}  // namespace beespace::io
