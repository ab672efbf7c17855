#include "analysis/geometry/geometry.hpp"

#include <beespace/geodesy.hpp>

#include <cmath>

namespace beespace::analysis {
namespace {

GeographicPosition geographic(const Point& p) {
  return {p.x, p.y, p.z};
}

Result<InMetres> placed(const Point& position, io::Frame frame, Geometry geometry,
                        const StatedHeight& stated) {
  const bool as_stated = geometry == Geometry::kGroundAndStatedHeight;
  const double height_there = stated.unit == io::Unit::kMetre ? position.z : stated.value;
  const double height = as_stated ? io::as_compared(height_there, stated.unit) : position.z;
  if (frame == io::Frame::kMetres) {
    if (geometry == Geometry::kSpace) return InMetres{position, std::nullopt};
    return InMetres{{position.x, position.y, 0.0}, std::nullopt, height};
  }
  GeographicPosition place = geographic(position);
  // Checked as it is given; what lies below it at height 0 is as good.
  const auto ecef = to_ecef(place);
  if (!ecef) return ecef.error();
  if (geometry == Geometry::kSpace) return InMetres{*ecef, std::nullopt};
  place.height_m = 0.0;
  return InMetres{*to_ecef(place), std::nullopt, height};
}

// The climb rate, in the unit of the heights that are compared.
double climb_of(const Velocity& v, Geometry geometry, const StatedHeight& stated) {
  if (geometry == Geometry::kSpace) return 0.0;
  if (geometry == Geometry::kGroundAndHeight) return v.z;
  return flushed(io::as_compared(io::from_metric(v.z, stated.unit), stated.unit));
}

}  // namespace

Geometry geometry_for(io::Frame frame, io::Unit height_unit,
                      const std::optional<io::StatedLength>& vertical) {
  if (io::compares_as_stated(vertical, height_unit)) return Geometry::kGroundAndStatedHeight;
  return vertical && frame == io::Frame::kWgs84 ? Geometry::kGroundAndHeight : Geometry::kSpace;
}

Geometry geometry_for(const io::Recording& recording,
                      const std::optional<io::StatedLength>& vertical) {
  return geometry_for(recording.frame, recording.height_unit, vertical);
}

std::optional<double> vertical_in(Geometry geometry,
                                  const std::optional<io::StatedLength>& vertical,
                                  io::Unit height_unit) {
  if (!vertical) return std::nullopt;
  return geometry == Geometry::kGroundAndStatedHeight
             ? exactly_in(*vertical, compared_in(vertical, height_unit))
             : vertical->metric;
}

double height_unit_m(Geometry geometry, io::Unit height_unit) {
  if (geometry != Geometry::kGroundAndStatedHeight) return 1.0;
  return io::in_metric(1.0, height_unit == io::Unit::kMetre ? io::Unit::kCentimetre : height_unit);
}

StatedHeight stated_height(const io::Recording& recording, const io::RecordedBee& bee,
                           std::size_t fix) {
  if (fix >= bee.stated_heights.size()) return {};
  return {bee.stated_heights[fix], recording.height_unit};
}

bool is_known(const Velocity& velocity) {
  return std::isfinite(velocity.x) && std::isfinite(velocity.y) && std::isfinite(velocity.z);
}

double flushed(double value) {
  return std::abs(value) < kSmallestInMotion ? 0.0 : value;
}

Result<InMetres> in_metres(const Point& position, const std::optional<Velocity>& velocity,
                           io::Frame frame, Geometry geometry, const StatedHeight& stated) {
  auto at = placed(position, frame, geometry, stated);
  if (!at || !velocity || !is_known(*velocity)) return at;
  const Velocity along{velocity->x, velocity->y, heights_apart(geometry) ? 0.0 : velocity->z};
  at->climb_mps = climb_of(*velocity, geometry, stated);
  at->velocity = along;
  if (frame == io::Frame::kMetres) return at;
  const auto ecef = to_ecef_velocity(geographic(position), {along.x, along.y, along.z});
  if (!ecef) return ecef.error();
  at->velocity = *ecef;
  return at;
}

Result<InMetres> in_metres(const io::Recording& recording, std::size_t bee, std::size_t fix,
                           Geometry geometry) {
  const io::RecordedBee& of = recording.bees[bee];
  std::optional<Velocity> velocity;
  if (of.velocities.size() > fix) velocity = of.velocities[fix];
  return in_metres(of.fixes[fix].position, velocity, recording.frame, geometry,
                   stated_height(recording, of, fix));
}

}  // namespace beespace::analysis
