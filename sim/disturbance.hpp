// What carries an agent off its path, and how wrong its measurements are: all within bounds.
//
// A disturbance is a velocity: a drift that stays, and a gust that flips its sign. Against a
// neighbour (adversarial) both push towards it or away from it, and what is measured tells the
// agent that it is farther from where it is pushed to than it is.
#pragma once

#include "scenes/random_stream.hpp"
#include "sim/vector3.hpp"

#include <cstdint>

namespace beespace::sim {

enum class ErrorKind : std::uint8_t { kUniform, kAdversarial };

struct DisturbanceBounds {
  ErrorKind kind = ErrorKind::kUniform;
  double drift_mps = 0.0;
  double gust_mps = 0.0;
  double least_gust_s = 0.2;  // how long a gust lasts until it flips
  double most_gust_s = 3.0;
  bool planar = false;
};

class Disturbance {
 public:
  Disturbance(const DisturbanceBounds& bounds, std::uint64_t seed);

  // Goes on for so long. `towards` is a direction of length 1, to the nearest neighbour; or zero,
  // where there is none.
  void go_on(double lasts_s, const Vector3& towards);
  // The velocity now.
  [[nodiscard]] const Vector3& velocity() const { return velocity_; }
  // An error of measurement now, no longer than the bound.
  Vector3 error(double bound);

 private:
  void flip();

  DisturbanceBounds bounds_;
  scenes::RandomStream random_;
  Vector3 drift_way_;
  Vector3 gust_way_;
  Vector3 velocity_;
  double sign_ = 1.0;
  double flips_in_s_ = 0.0;
};

}  // namespace beespace::sim
