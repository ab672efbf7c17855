#include "io/recording/show_ground.hpp"

#include <beespace/conflict.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kStandsBelow_m = 0.1;

std::string counted_drones(std::uint64_t count, const char* one, const char* many) {
  return std::to_string(count) + (count == 1 ? " drone" : " drones") + (count == 1 ? one : many);
}

// The lowest place at which any begins or ends.
double ground_of_tables(const Recording& recording) {
  double ground_m = recording.show->ground_m.value_or(std::numeric_limits<double>::infinity());
  for (const RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) continue;
    ground_m = std::min({ground_m, bee.fixes.front().position.z, bee.fixes.back().position.z});
  }
  return ground_m > kHighestShowGround_m ? 0.0 : ground_m;
}

// The fixes that are kept: from the last one before it takes off to the first one after landing.
struct Flight {
  std::size_t first = 0;
  std::size_t last = 0;
};

Flight flight_of(const std::vector<Fix>& fixes, double ground_m) {
  const auto is_low = [&](const Fix& fix) { return fix.position.z - ground_m <= kStandsBelow_m; };
  Flight flight{0, fixes.size() - 1};
  while (flight.first < flight.last && is_low(fixes.front()) &&
         fixes[flight.first + 1].position == fixes.front().position) {
    ++flight.first;
  }
  while (flight.first < flight.last && is_low(fixes.back()) &&
         fixes[flight.last - 1].position == fixes.back().position) {
    --flight.last;
  }
  return flight;
}

// When any is in the air, by what is kept of the fixes or by a path; nothing where none is.
std::optional<TimeSpan> time_in_the_air(const Recording& recording,
                                        const std::vector<Flight>& flights) {
  std::optional<TimeSpan> time;
  const auto add = [&time](double begins_s, double ends_s) {
    const TimeSpan so_far = time.value_or(TimeSpan{begins_s, ends_s});
    time = TimeSpan{std::min(so_far.begins_s, begins_s), std::max(so_far.ends_s, ends_s)};
  };
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const RecordedBee& bee = recording.bees[i];
    if (bee.path && !bee.path->pieces.empty()) {
      add(bee.path->begins_s, bee.path->pieces.back().ends_s);
    } else if (flights[i].first < flights[i].last) {
      add(bee.fixes[flights[i].first].time_s, bee.fixes[flights[i].last].time_s);
    }
  }
  return time;
}

// Whether its table is as long as others fly, but for a few rows: one that is cut off says nothing
// of what follows.
bool lasts_as_long(const RecordedBee& bee, const TimeSpan& flown) {
  constexpr double kFewRows = 5.0;
  const double first_s = bee.fixes.front().time_s;
  const double last_s = bee.fixes.back().time_s;
  const double few_s = kFewRows * (last_s - first_s) / static_cast<double>(bee.fixes.size() - 1);
  return first_s <= flown.begins_s + few_s && last_s >= flown.ends_s - few_s;
}

template <class Value>
void keep(std::vector<Value>& values, const Flight& flight) {
  if (values.empty()) return;
  values.resize(flight.last + 1);
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(flight.first));
}

// Whether any is ever above the ground, by its fixes or a path.
bool any_takes_off(const Recording& recording, double ground_m) {
  return std::any_of(
      recording.bees.begin(), recording.bees.end(), [ground_m](const RecordedBee& bee) {
        return bee.path ||
               std::any_of(bee.fixes.begin(), bee.fixes.end(), [ground_m](const Fix& fix) {
                 return fix.position.z - ground_m > kStandsBelow_m;
               });
      });
}

bool any_moves(const Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(), [](const RecordedBee& bee) {
    return std::any_of(bee.fixes.begin(), bee.fixes.end(), [&bee](const Fix& fix) {
      return !(fix.position == bee.fixes.front().position);
    });
  });
}

}  // namespace

std::string standing_note(std::uint64_t drones) {
  return counted_drones(drones, " stands", " stand") +
         " on the ground before take-off or after landing: compared with those that fly then, and "
         "not with others that stand; --grounded compares these, too";
}

std::string grounded_note(std::uint64_t drones) {
  return counted_drones(drones, " never leaves", " never leave") + " the ground and " +
         (drones == 1 ? "stands" : "stand") +
         " there for those that fly; --grounded also compares drones that stand with each other";
}

void leave_ground_time_out(Recording& recording) {
  if (!recording.show || recording.flat) return;
  const double ground_m = ground_of_tables(recording);
  if (!any_takes_off(recording, ground_m)) {
    if (any_moves(recording)) {
      recording.notes.emplace_back(
          "heights never change: no drone takes off, and all are compared all the time; where y "
          "points up, as in Unity, Maya or Cinema 4D, exchange y and z with --columns");
    }
    return;
  }
  std::vector<Flight> flights;
  for (const RecordedBee& bee : recording.bees) {
    flights.push_back(bee.fixes.empty() ? Flight{} : flight_of(bee.fixes, ground_m));
  }
  const auto flown = time_in_the_air(recording, flights);
  if (!flown) return;
  std::uint64_t stood = 0;
  std::uint64_t grounded = 0;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    RecordedBee& bee = recording.bees[i];
    const Flight& flight = flights[i];
    if (bee.fixes.size() < 2 || (flight.first == 0 && flight.last + 1 == bee.fixes.size())) {
      continue;
    }
    if (flight.first == flight.last) {
      if (!lasts_as_long(bee, *flown)) continue;
      ++grounded;
      bee.stands = bee.fixes.front().position;
      bee.fixes.clear();
      bee.velocities.clear();
      bee.stated_heights.clear();
      continue;
    }
    ++stood;
    keep(bee.fixes, flight);
    keep(bee.velocities, flight);
    keep(bee.stated_heights, flight);
  }
  if (stood > 0) recording.notes.push_back(standing_note(stood));
  if (grounded > 0) recording.notes.push_back(grounded_note(grounded));
}

}  // namespace beespace::io
