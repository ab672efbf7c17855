#include "geodesy/ecef_kernel.hpp"

#include <bit>
#include <cmath>

#define BEESPACE_ALWAYS_INLINE [[gnu::always_inline]] inline

namespace beespace::geodesy {
namespace {

// WGS84: the semi-major axis, and the first eccentricity squared f(2 - f) of f = 1/298.257223563.
constexpr double kSemiMajorAxis_m = 6'378'137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2.0 - kFlattening);
constexpr double kOneMinusEccentricitySquared = (1.0 - kFlattening) * (1.0 - kFlattening);

// pi/180 as the sum of two doubles.
constexpr double kRadiansPerDegree = 0x1.1df46a2529d39p-6;
constexpr double kRadiansPerDegreeRest = 0x1.5c1d8becdd291p-62;

// Added to a number below 2^51 it leaves no bits for a fraction: the number is rounded to an
// integer, which then stands in the lowest bits of the sum.
constexpr double kRounder = 0x1.8p+52;

struct SineCosine {
  double sine;
  double cosine;
};

// Of an angle of up to 45 degrees (and a rounding error), in radians.
//
// sin x = x + x^3 S(x^2) and cos x = 1 - x^2/2 + x^4 C(x^2), where S and C interpolate at the
// Chebyshev nodes of [0, (pi/4)^2]. Truncation: 1.4e-17 and 0.9e-18, an eighth of 2^-53 and less.
BEESPACE_ALWAYS_INLINE SineCosine sine_cosine_of_small(double x) {
  const double z = x * x;
  double s = 0x1.5e0b19f8b1451p-33;
  s = s * z - 0x1.ae600b02b6262p-26;
  s = s * z + 0x1.71de37968a100p-19;
  s = s * z - 0x1.a01a019e83aaep-13;
  s = s * z + 0x1.1111111110bb2p-7;
  s = s * z - 0x1.5555555555555p-3;
  double c = -0x1.907da367a37cbp-37;
  c = c * z + 0x1.1eeb68e93b64cp-29;
  c = c * z - 0x1.27e4fa17da09ep-22;
  c = c * z + 0x1.a01a019f4eb01p-16;
  c = c * z - 0x1.6c16c16c16967p-10;
  c = c * z + 0x1.5555555555555p-5;
  // 1 - z/2 rounds; what it loses is recovered exactly and added to the small terms.
  const double half = 0.5 * z;
  const double head = 1.0 - half;
  const double lost = (1.0 - head) - half;
  return {x + x * (z * s), head + (z * (z * c) + lost)};
}

// Of an angle in degrees, |degrees| < 2^50. The reduction to at most 45 degrees is exact: the
// difference of two numbers within a factor of two of each other has no rounding error.
BEESPACE_ALWAYS_INLINE SineCosine sine_cosine(double degrees) {
  const double rounded = degrees * (1.0 / 90.0) + kRounder;
  const double quarters = rounded - kRounder;
  const double rest = degrees - quarters * 90.0;
  const SineCosine small =
      sine_cosine_of_small(rest * kRadiansPerDegree + rest * kRadiansPerDegreeRest);

  // Each quarter turn takes (cos, sin) to (-sin, cos). As masks, so that vectors need no branch.
  const auto turns = std::bit_cast<std::uint64_t>(rounded);
  const std::uint64_t odd = std::uint64_t{0} - (turns & 1u);
  const std::uint64_t sine_sign = (turns & 2u) << 62u;
  const std::uint64_t cosine_sign = ((turns + 1u) & 2u) << 62u;
  const auto s = std::bit_cast<std::uint64_t>(small.sine);
  const auto c = std::bit_cast<std::uint64_t>(small.cosine);
  const std::uint64_t swapped = (s ^ c) & odd;
  return {std::bit_cast<double>(s ^ swapped ^ sine_sign),
          std::bit_cast<double>(c ^ swapped ^ cosine_sign)};
}

// Heiskanen and Moritz, Physical Geodesy, 1967, 5-3, with n the radius of curvature in the prime
// vertical. Adding 0.0 turns -0.0 into 0.0, so that -0 and 0 degrees have the same bits.
BEESPACE_ALWAYS_INLINE Point convert_one(double longitude_deg, double latitude_deg,
                                         double height_m) {
  const SineCosine lambda = sine_cosine(longitude_deg);
  const SineCosine phi = sine_cosine(latitude_deg);
  const double n = kSemiMajorAxis_m / std::sqrt(1.0 - kEccentricitySquared * (phi.sine * phi.sine));
  const double from_axis = (n + height_m) * phi.cosine;
  return {from_axis * lambda.cosine + 0.0, from_axis * lambda.sine + 0.0,
          (n * kOneMinusEccentricitySquared + height_m) * phi.sine + 0.0};
}

// The highest bit is set when the value is below 0, or is not finite. Comparisons would do, but
// GCC does not vectorise a loop with them for SSE2.
BEESPACE_ALWAYS_INLINE std::uint64_t is_negative_bit(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

BEESPACE_ALWAYS_INLINE std::uint64_t is_not_finite_bit(double value) {
  // An exponent of only ones carries into the sign.
  constexpr std::uint64_t kOneExponent = std::uint64_t{1} << 52u;
  return std::bit_cast<std::uint64_t>(std::abs(value)) + kOneExponent;
}

// The highest bit is set when the position is not valid. (-0.0 cannot come out of the
// differences, and the sign of a NaN does not matter beside the test for finite values.)
BEESPACE_ALWAYS_INLINE std::uint64_t is_invalid_bit(double longitude_deg, double latitude_deg,
                                                    double height_m) {
  return is_negative_bit(360.0 - std::abs(longitude_deg)) |
         is_negative_bit(90.0 - std::abs(latitude_deg)) |
         is_negative_bit(height_m - kLowestHeight_m) |
         is_negative_bit(kGreatestHeight_m - height_m) | is_not_finite_bit(longitude_deg) |
         is_not_finite_bit(latitude_deg) | is_not_finite_bit(height_m);
}

constexpr std::uint64_t kHighestBit = std::uint64_t{1} << 63u;

BEESPACE_ALWAYS_INLINE bool convert_all(EcefBlock& block) {
  std::uint64_t invalid = 0;
  for (std::size_t i = 0; i < EcefBlock::kSize; ++i) {
    const double longitude_deg = block.longitude_deg[i];
    const double latitude_deg = block.latitude_deg[i];
    const double height_m = block.height_m[i];
    invalid |= is_invalid_bit(longitude_deg, latitude_deg, height_m);
    const Point point = convert_one(longitude_deg, latitude_deg, height_m);
    block.x[i] = point.x;
    block.y[i] = point.y;
    block.z[i] = point.z;
  }
  return (invalid & kHighestBit) == 0;
}

bool convert_baseline(EcefBlock& block) {
  return convert_all(block);
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] bool convert_avx2(EcefBlock& block) {
  return convert_all(block);
}

[[gnu::target("avx512f,avx512dq")]] bool convert_avx512(EcefBlock& block) {
  return convert_all(block);
}
#endif

}  // namespace

#if defined(__x86_64__)
bool is_available(EcefVariant variant) {
  switch (variant) {
    case EcefVariant::kBaseline:
      return true;
    case EcefVariant::kAvx2:
      return __builtin_cpu_supports("avx2") != 0;
    case EcefVariant::kAvx512:
      return __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0;
  }
  return false;
}

EcefConversion conversion(EcefVariant variant) {
  switch (variant) {
    case EcefVariant::kBaseline:
      return convert_baseline;
    case EcefVariant::kAvx2:
      return convert_avx2;
    case EcefVariant::kAvx512:
      return convert_avx512;
  }
  return convert_baseline;
}
#else
bool is_available(EcefVariant variant) {
  return variant == EcefVariant::kBaseline;
}

EcefConversion conversion(EcefVariant) {
  return convert_baseline;
}
#endif

EcefConversion fastest_conversion() {
  for (const EcefVariant variant : {EcefVariant::kAvx512, EcefVariant::kAvx2}) {
    if (is_available(variant)) return conversion(variant);
  }
  return convert_baseline;
}

LocalVelocity course_velocity(double ground_speed_mps, double track_deg, double climb_mps) {
  const SineCosine track = sine_cosine(track_deg);
  return {ground_speed_mps * track.sine, ground_speed_mps * track.cosine, climb_mps};
}

Velocity convert_velocity(const GeographicPosition& position, const LocalVelocity& velocity) {
  const SineCosine lambda = sine_cosine(position.longitude_deg);
  const SineCosine phi = sine_cosine(position.latitude_deg);
  const double outward = velocity.up_mps * phi.cosine - velocity.north_mps * phi.sine;
  return {outward * lambda.cosine - velocity.east_mps * lambda.sine,
          outward * lambda.sine + velocity.east_mps * lambda.cosine,
          velocity.up_mps * phi.sine + velocity.north_mps * phi.cosine};
}

Point convert_position(const GeographicPosition& position) {
  return convert_one(position.longitude_deg, position.latitude_deg, position.height_m);
}

bool is_valid(const GeographicPosition& position) {
  return (is_invalid_bit(position.longitude_deg, position.latitude_deg, position.height_m) &
          kHighestBit) == 0;
}

}  // namespace beespace::geodesy
