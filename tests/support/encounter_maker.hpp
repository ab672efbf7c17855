// Encounters of two movers, many of them at the very edge between conflict and none.
#pragma once

#include "tests/support/scene_maker.hpp"

#include <beespace/closest_approach.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <ostream>
#include <utility>
#include <vector>

namespace beespace::test {

struct Encounter {
  Mover first;
  Mover second;
  PredictOptions options{.threshold_m = 100.0};

  // Every number of it: of the movers, then the threshold, the horizon and, if given, the height.
  [[nodiscard]] std::vector<double*> numbers() {
    std::vector<double*> all;
    for (Mover* mover : {&first, &second}) {
      auto& [p, v] = *mover;
      all.insert(all.end(), {&p.x, &p.y, &p.z, &v.x, &v.y, &v.z});
    }
    all.insert(all.end(), {&options.threshold_m, &options.horizon_s});
    if (options.vertical_m) all.push_back(&*options.vertical_m);
    return all;
  }

  [[nodiscard]] Encounter swapped() const { return {second, first, options}; }
  [[nodiscard]] Encounter inclusive(bool inclusive) const {
    Encounter other = *this;
    other.options.inclusive = inclusive;
    return other;
  }

  friend std::ostream& operator<<(std::ostream& out, const Encounter& e) {
    const auto show = [&](const Mover& mover) {
      const auto& [p, v] = mover;
      out << "{{" << p.x << ", " << p.y << ", " << p.z << "}, {" << v.x << ", " << v.y << ", "
          << v.z << "}} ";
    };
    out << std::hexfloat;
    show(e.first);
    show(e.second);
    out << "threshold " << e.options.threshold_m;
    if (e.options.vertical_m) out << ", vertical " << *e.options.vertical_m;
    return out << ", horizon " << e.options.horizon_s
               << (e.options.inclusive ? ", inclusive" : ", strict") << std::defaultfloat;
  }
};

class EncounterMaker {
 public:
  explicit EncounterMaker(std::uint32_t seed) : make_(seed) {}

  // Small integers, so that pairs that graze, touch at the horizon or start at the threshold do so
  // exactly. Equal places, equal velocities, standing still and no horizon are among them.
  Encounter on_lattice() {
    Encounter e;
    e.first = {{integer(3), integer(3), integer(3)}, {integer(2), integer(2), integer(2)}};
    e.second = {{integer(3), integer(3), integer(3)}, {integer(2), integer(2), integer(2)}};
    if (make_.below(12) == 0) e.second.velocity = e.first.velocity;
    if (make_.below(12) == 0) e.first.velocity = {};
    if (make_.below(25) == 0) e.second.position = e.first.position;
    e.options.threshold_m = 1.0 + static_cast<double>(make_.below(5));
    e.options.horizon_s = 0.5 * static_cast<double>(make_.below(9));
    if (make_.below(2) == 0) e.options.vertical_m = 1.0 + static_cast<double>(make_.below(4));
    e.options.inclusive = make_.below(2) == 0;
    return e;
  }

  // One number of it becomes one of the two doubles next to it; none that is zero.
  Encounter nudged(Encounter e) {
    const std::vector<double*> numbers = e.numbers();
    double& number = *numbers[make_.below(numbers.size())];
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (number != 0.0) number = std::nextafter(number, make_.below(2) == 0 ? kInfinity : 0.0);
    return e;
  }

  // The same with lengths and times in other units, from end to end of the motion domain.
  Encounter rescaled(Encounter e) {
    const int length = exponent(-98, 96);
    const int time = exponent(std::max(-98, length - 96), std::min(96, length + 98));
    for (double* number : e.numbers()) *number = std::ldexp(*number, length);
    for (Mover* mover : {&e.first, &e.second}) {
      for (double* speed : {&mover->velocity.x, &mover->velocity.y, &mover->velocity.z}) {
        *speed = std::ldexp(*speed, -time);
      }
    }
    e.options.horizon_s = std::ldexp(e.options.horizon_s, time - length);
    return e;
  }

  Encounter moved(Encounter e, const Point& by) {
    for (Mover* mover : {&e.first, &e.second}) mover->position = shifted(mover->position, by);
    return e;
  }

  // Towards each other or nearly so, at any time and miss distance around the threshold and the
  // horizon.
  Encounter ragged() {
    Encounter e;
    const auto vector = [&](double size) {
      return Point{make_.between(-size, size), make_.between(-size, size),
                   make_.between(-size, size)};
    };
    const double scale = std::ldexp(1.0, exponent(-20, 20));
    const double speed = scale * std::ldexp(1.0, exponent(-10, 10));
    const Point at = vector(30.0 * scale);
    const Point v = vector(speed);
    const Point w = vector(speed);
    const Point miss = vector(scale);
    const double time = make_.between(-0.2, 1.2) * 10.0 * scale / speed;
    e.first = {at, {v.x, v.y, v.z}};
    e.second = {{at.x + miss.x - (w.x - v.x) * time, at.y + miss.y - (w.y - v.y) * time,
                 at.z + miss.z - (w.z - v.z) * time},
                {w.x, w.y, w.z}};
    e.options.threshold_m = scale * make_.between(0.2, 1.5);
    e.options.horizon_s = time > 0.0 ? time * make_.between(0.8, 1.5) : make_.between(0.0, 9.0);
    if (make_.below(2) == 0) e.options.vertical_m = scale * make_.between(0.1, 1.0);
    e.options.inclusive = make_.below(2) == 0;
    return e;
  }

  // Every number of any magnitude of the motion domain.
  Encounter of_any_magnitude() {
    Encounter e = on_lattice();
    for (double* number : e.numbers()) {
      *number = (make_.below(2) == 0 ? -1.0 : 1.0) * make_.between(1.0, 2.0) *
                std::ldexp(1.0, exponent(-100, 99));
      if (make_.below(9) == 0) *number = make_.below(2) == 0 ? kSmallestInMotion : kLargestInMotion;
    }
    for (double* number : {&e.options.threshold_m, &e.options.horizon_s})
      *number = std::abs(*number);
    if (e.options.vertical_m) e.options.vertical_m = std::abs(*e.options.vertical_m);
    return e;
  }

  SceneMaker& random() { return make_; }

 private:
  double integer(int most) {
    return static_cast<double>(make_.below(static_cast<std::size_t>(2 * most + 1))) - most;
  }
  int exponent(int low, int high) {
    return low + static_cast<int>(make_.below(static_cast<std::size_t>(high - low + 1)));
  }

  SceneMaker make_;
};

}  // namespace beespace::test
