#include "io/recording/unit_doubts.hpp"

#include "io/bytes/number_text.hpp"
#include "io/recording/feet_doubt.hpp"
#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::size_t kFewest = 8;  // steps, to say anything

double speed_of(const Velocity& velocity) {
  return std::hypot(velocity.x, velocity.y, velocity.z);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Steps {
  std::vector<double> seconds;
  std::vector<double> speeds;  // of those that move
  std::vector<double> ratios;  // of such a speed to the one that the input states
};

Steps steps_of(const Recording& recording) {
  constexpr std::size_t kMost = 100'000;
  constexpr double kMoves_mps = 0.001;
  Steps steps;
  for (const RecordedBee& bee : recording.bees) {
    for (std::size_t i = 1; i < bee.fixes.size() && steps.seconds.size() < kMost; ++i) {
      const double seconds = bee.fixes[i].time_s - bee.fixes[i - 1].time_s;
      const double metres =
          flat_distance_m(bee.fixes[i - 1].position, bee.fixes[i].position, recording.frame);
      steps.seconds.push_back(seconds);
      if (!(metres > 0.0)) continue;
      steps.speeds.push_back(metres / seconds);
      if (bee.velocities.empty()) continue;
      const double stated = speed_of(bee.velocities[i - 1]);
      if (stated > kMoves_mps) steps.ratios.push_back(metres / seconds / stated);
    }
  }
  return steps;
}

std::string short_number(double value) {
  std::array<char, 32> text = {};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3)
          .ptr;
  return {text.data(), end};
}

// The unit of which a thousand are one; or the other way round.
Unit smaller(Unit unit) {
  if (unit == Unit::kSecond) return Unit::kMillisecond;
  if (unit == Unit::kMillisecond) return Unit::kMicrosecond;
  return unit == Unit::kMicrosecond ? Unit::kNanosecond : Unit::kUnstated;
}

Unit larger(Unit unit) {
  if (unit == Unit::kNanosecond) return Unit::kMicrosecond;
  if (unit == Unit::kMicrosecond) return Unit::kMillisecond;
  return unit == Unit::kMillisecond ? Unit::kSecond : Unit::kUnstated;
}

Error doubt(const Steps& steps, Unit named, Unit other, double times, const std::string& why) {
  const double speed = median(steps.speeds);
  const double seconds = median(steps.seconds);
  const std::string is(time_unit_option(named));
  const std::string would_be(time_unit_option(other));
  return {ErrorCode::kInvalidArgument,
          "are the times in " + is + ", as the header says? Then bees move at " +
              short_number(speed) + " m/s and are heard of every " + short_number(seconds) + " s" +
              why + "; in " + would_be + " it would be " + short_number(speed * times) +
              " m/s, every " + short_number(seconds / times) + " s. Say which with --time-unit " +
              would_be + " or --time-unit " + is,
          {}};
}

}  // namespace

std::optional<Error> doubt_of_time_unit(const Recording& recording, Unit named) {
  constexpr double kThousand = 1000.0;
  constexpr double kAlike = 3.0;  // times as much or as little
  const Steps steps = steps_of(recording);
  if (steps.ratios.size() >= kFewest) {
    const double ratio = median(steps.ratios);
    const std::string why = ", but their velocities say otherwise";
    const bool slow = ratio * kThousand > 1.0 / kAlike && ratio * kThousand < kAlike;
    const bool fast = ratio / kThousand > 1.0 / kAlike && ratio / kThousand < kAlike;
    if (slow && smaller(named) != Unit::kUnstated) {
      return doubt(steps, named, smaller(named), kThousand, why);
    }
    if (fast && larger(named) != Unit::kUnstated) {
      return doubt(steps, named, larger(named), 1.0 / kThousand, why);
    }
    return std::nullopt;
  }
  // Who moves so slowly is not followed in milliseconds.
  constexpr double kSlow_mps = 0.05;
  constexpr double kUsual_mps = 0.2;
  constexpr double kSeldom_s = 2.0;
  if (named != Unit::kMillisecond || steps.speeds.size() < kFewest) return std::nullopt;
  const double speed = median(steps.speeds);
  if (speed >= kSlow_mps || speed * kThousand < kUsual_mps) return std::nullopt;
  if (median(steps.seconds) < kSeldom_s) return std::nullopt;
  return doubt(steps, named, Unit::kMicrosecond, kThousand, "");
}

std::optional<Error> doubt_of_heights(const std::vector<UnitTaken>& units, double highest_m) {
  constexpr double kHighest_m = 20'000.0;
  if (!(highest_m > kHighest_m)) return std::nullopt;
  const auto doubtful = std::find_if(units.begin(), units.end(), [](const UnitTaken& taken) {
    return taken.of == "heights" &&
           (taken.evidence == UnitEvidence::kUsual ||
            (taken.evidence == UnitEvidence::kSource && taken.unit == Unit::kMetre));
  });
  if (doubtful == units.end()) return std::nullopt;
  const std::string up_to = "heights go up to " + exact(highest_m);
  if (doubtful->evidence == UnitEvidence::kSource) {
    return Error{ErrorCode::kInvalidArgument,
                 up_to + " m (" + doubtful->reason +
                     "): are they in feet? Say it with --units height=ft, or height=m if they are "
                     "in metres",
                 {}};
  }
  return Error{ErrorCode::kInvalidArgument,
               up_to +
                   ", but no unit is named: are they metres, feet, or millimetres? Say it in the "
                   "header, or with --units height=ft, height=mm or height=m",
               {}};
}

std::optional<Error> doubt_of_feet(const Recording& recording, double highest_m) {
  if (!FeetDoubt::concerns(recording.units) || recording.frame != Frame::kWgs84) {
    return std::nullopt;
  }
  FeetDoubt feet;
  feet.take_height(highest_m);
  for (const RecordedBee& bee : recording.bees) {
    for (std::size_t i = 0; i < bee.velocities.size(); ++i) {
      feet.take_speed(bee.velocities[i]);
      if (i + 1 < bee.fixes.size()) {
        feet.take_step(bee.fixes[i], bee.velocities[i], bee.fixes[i + 1]);
      }
    }
  }
  return feet.doubt();
}

std::optional<Error> doubt_of_metres(const Recording& recording, double fastest_mps) {
  if (recording.frame != Frame::kMetres) return std::nullopt;
  const Steps steps = steps_of(recording);
  if (steps.speeds.size() < kFewest) return std::nullopt;
  const double speed = median(steps.speeds);
  if (!(speed > fastest_mps)) return std::nullopt;
  return too_fast_in_metres(speed);
}

Error too_fast_in_metres(double speed_mps) {
  return {ErrorCode::kInvalidArgument,
          "are x, y, z in metres? Nothing names their unit, and in metres they move at " +
              short_number(speed_mps) +
              " m/s; say it with --units position=cm, position=mm, or "
              "position=m if they do",
          {}};
}

}  // namespace beespace::io
