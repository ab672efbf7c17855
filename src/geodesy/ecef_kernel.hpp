// Degrees to ECEF for a block of positions: the arithmetic, and its variants for this processor.
//
// Every variant is the same source compiled for another instruction set, without contraction into
// fused operations, so all of them return the same bits; they differ in speed only.
#pragma once

#include <beespace/geodesy.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::geodesy {

// Positions as separate arrays, of a fixed size that every vector width divides; 6 KiB, so that
// it stays in the first-level cache.
struct EcefBlock {
  static constexpr std::size_t kSize = 128;

  alignas(64) std::array<double, kSize> longitude_deg;
  alignas(64) std::array<double, kSize> latitude_deg;
  alignas(64) std::array<double, kSize> height_m;
  alignas(64) std::array<double, kSize> x;
  alignas(64) std::array<double, kSize> y;
  alignas(64) std::array<double, kSize> z;
};

enum class EcefVariant : std::uint8_t { kBaseline, kAvx2, kAvx512 };

// Whether this processor can run the variant. The baseline runs everywhere.
bool is_available(EcefVariant variant);

// Converts all kSize positions. False when at least one of them is not valid (see is_valid);
// the results of the invalid ones are then unspecified. A variant must be available to be named.
using EcefConversion = bool (*)(EcefBlock&);
EcefConversion conversion(EcefVariant variant);
EcefConversion fastest_conversion();

// One position, with the same bits as in a block.
Point convert_position(const GeographicPosition& position);

LocalVelocity course_velocity(double ground_speed_mps, double track_deg, double climb_mps);

// The velocity of a valid position.
Velocity convert_velocity(const GeographicPosition& position, const LocalVelocity& velocity);

// Finite, and inside the limits of geodesy.hpp.
bool is_valid(const GeographicPosition& position);

}  // namespace beespace::geodesy
