#include "geodesy/ecef_kernel.hpp"

#include <beespace/geodesy.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace beespace {
namespace {

using geodesy::EcefBlock;

// The shortest text of the same double; "nan" and "inf" as they are.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

bool is_finite(const GeographicPosition& position) {
  return std::isfinite(position.longitude_deg) && std::isfinite(position.latitude_deg) &&
         std::isfinite(position.height_m);
}

// The error of an invalid position.
Error explain(const GeographicPosition& position) {
  if (!is_finite(position)) {
    return {ErrorCode::kNotFinite,
            "the position " + number(position.longitude_deg) + ", " +
                number(position.latitude_deg) + ", " + number(position.height_m) +
                " is not finite; remove it or correct it",
            {}};
  }
  if (!(std::abs(position.latitude_deg) <= 90.0)) {
    return {ErrorCode::kInvalidLatitude,
            "the latitude " + number(position.latitude_deg) +
                " is beyond +-90 degrees; check the order of the columns, or say that these are "
                "metres",
            {}};
  }
  if (!(std::abs(position.longitude_deg) <= 360.0)) {
    return {ErrorCode::kInvalidLongitude,
            "the longitude " + number(position.longitude_deg) +
                " is beyond +-360 degrees; check the order of the columns, or say that these are "
                "metres",
            {}};
  }
  return {ErrorCode::kInvalidHeight,
          "the height " + number(position.height_m) +
              " is not between -12,000 and 1,000,000 m; check its unit and the order of the "
              "columns",
          {}};
}

GeographicPosition position_at(const EcefBlock& block, std::size_t i) {
  return {block.longitude_deg[i], block.latitude_deg[i], block.height_m[i]};
}

// Copies positions first ... first + count - 1 into the block, and fills the rest with a valid one.
void fill(EcefBlock& block, const PointsView& positions, std::size_t first, std::size_t count) {
  constexpr auto kPacked = static_cast<std::ptrdiff_t>(sizeof(Point));
  const auto& axes = positions.axes();
  const auto* const longitudes = static_cast<const double*>(axes[0]);
  const bool packed = !positions.holds_floats() &&
                      positions.stride_bytes() == std::array{kPacked, kPacked, kPacked} &&
                      axes[1] == longitudes + 1 && axes[2] == longitudes + 2;
  if (packed) {
    const double* from = longitudes + 3 * first;
    for (std::size_t i = 0; i < count; ++i) {
      block.longitude_deg[i] = from[3 * i];
      block.latitude_deg[i] = from[3 * i + 1];
      block.height_m[i] = from[3 * i + 2];
    }
  } else {
    for (std::size_t i = 0; i < count; ++i) {
      block.longitude_deg[i] = positions.coordinate(0, first + i);
      block.latitude_deg[i] = positions.coordinate(1, first + i);
      block.height_m[i] = positions.coordinate(2, first + i);
    }
  }
  for (std::size_t i = count; i < EcefBlock::kSize; ++i) {
    block.longitude_deg[i] = 0.0;
    block.latitude_deg[i] = 0.0;
    block.height_m[i] = 0.0;
  }
}

Error first_error(const EcefBlock& block, std::size_t first) {
  std::size_t i = 0;
  while (geodesy::is_valid(position_at(block, i))) ++i;
  Error error = explain(position_at(block, i));
  error.location.array = "points";
  error.location.record = first + i;
  return error;
}

}  // namespace

Result<Point> to_ecef(const GeographicPosition& position) {
  if (!geodesy::is_valid(position)) return explain(position);
  return geodesy::convert_position(position);
}

Status to_ecef(const PointsView& positions, std::span<Point> ecef) {
  if (!positions.fits()) {
    const auto& [x, y, z] = positions.lengths();
    return Error{ErrorCode::kInvalidArgument,
                 std::to_string(x) + " longitudes, " + std::to_string(y) + " latitudes and " +
                     std::to_string(z) + " heights; give one of each for every position",
                 {}};
  }
  if (positions.size() != ecef.size()) {
    return Error{ErrorCode::kInvalidArgument,
                 "there are " + std::to_string(positions.size()) + " positions but room for " +
                     std::to_string(ecef.size()) + " points; both must be of one size",
                 {}};
  }
  const geodesy::EcefConversion convert = geodesy::fastest_conversion();
  EcefBlock block;
  for (std::size_t first = 0; first < ecef.size(); first += EcefBlock::kSize) {
    const std::size_t count = std::min(EcefBlock::kSize, ecef.size() - first);
    fill(block, positions, first, count);
    if (!convert(block)) return first_error(block, first);
    for (std::size_t i = 0; i < count; ++i) {
      ecef[first + i] = {block.x[i], block.y[i], block.z[i]};
    }
  }
  return std::monostate{};
}

Result<Velocity> to_ecef_velocity(const GeographicPosition& position,
                                  const LocalVelocity& velocity) {
  if (!geodesy::is_valid(position)) return explain(position);
  if (!std::isfinite(velocity.east_mps) || !std::isfinite(velocity.north_mps) ||
      !std::isfinite(velocity.up_mps)) {
    return Error{ErrorCode::kNotFinite,
                 "the velocity " + number(velocity.east_mps) + ", " + number(velocity.north_mps) +
                     ", " + number(velocity.up_mps) + " m/s is not finite; correct it",
                 {}};
  }
  return geodesy::convert_velocity(position, velocity);
}

LocalVelocity local_velocity(double ground_speed_mps, double track_deg, double climb_mps) {
  return geodesy::course_velocity(ground_speed_mps, track_deg, climb_mps);
}

}  // namespace beespace
