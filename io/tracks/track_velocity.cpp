#include "io/tracks/track_velocity.hpp"

#include "io/bytes/characters.hpp"
#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/record_problems.hpp"

#include <beespace/geodesy.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beespace::io {
namespace {

// Whether x points east and y north.
bool is_east_north(const VelocityQuestion& question) {
  const auto says = [&question](std::size_t column, std::string_view stem) {
    if (column >= question.header.table().names.size()) return false;
    const auto words = split_words(question.header.table().names[column]);
    return std::any_of(words.begin(), words.end(), [stem](const std::string& word) {
      return word.substr(0, stem.size()) == stem || word == "enu";
    });
  };
  return says(question.position.axes[0], "east") && says(question.position.axes[1], "north");
}

std::string left_out(const std::string& why) {
  return "velocities are not read: " + why +
         "; --columns with vx, vy, vz or ve, vn, vu says which columns hold them";
}

VelocityChoice chosen(std::size_t first, std::size_t second, std::optional<std::size_t> third) {
  VelocityChoice choice;
  choice.columns = {first, second, third.value_or(0)};
  choice.dimensions = third ? 3 : 2;
  return choice;
}

void note_choice(const VelocityQuestion& question, const VelocityChoice& choice, bool geographic,
                 std::vector<std::string>& notes) {
  std::string text = choice.over_ground ? "speed and direction over ground"
                     : geographic       ? "velocities east, north"
                                        : "velocities along x, y";
  if (choice.dimensions == 3) {
    text += choice.over_ground ? ", climb rate"
            : !geographic      ? ", z"
            : choice.down      ? ", down"
                               : ", up";
  }
  text += " are read from columns";
  for (std::size_t i = 0; i < choice.dimensions; ++i) {
    text.append(i == 0 ? " " : ", ").append(std::to_string(choice.columns[i] + 1));
  }
  if (choice.dimensions == 2 && question.position.dimensions == 3) {
    text += "; how fast bees climb is not known";
  }
  notes.push_back(std::move(text));
}

// By the header's words along axes; nothing where there are none, or not those that fit.
std::optional<VelocityChoice> choose_along_axes(const VelocityQuestion& question,
                                                std::vector<std::string>& notes) {
  const bool geographic = question.frame == Frame::kWgs84;
  const Header& header = question.header;
  const auto says_velocity = [&header](std::size_t column) {
    const Role role = header.meaning(column).role;
    return role >= Role::kVelocityX && role <= Role::kVelocityDown;
  };
  bool any = false;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (!says_velocity(i)) continue;
    any = true;
    const ColumnMeaning& meaning = header.meaning(i);
    if (!meaning.foreign_unit.empty()) {
      notes.push_back(left_out("column " + excerpt(header.table().names[i]) + " is in '" +
                               meaning.foreign_unit + "', which is no unit of a speed"));
      return std::nullopt;
    }
    if (header.columns(meaning.role).front() != i) {
      notes.push_back(left_out("several columns hold the same part of it"));
      return std::nullopt;
    }
  }
  if (!any) return std::nullopt;
  const bool compass = header.has(Role::kVelocityEast) && header.has(Role::kVelocityNorth);
  const bool east_north = geographic || (compass && is_east_north(question));
  const Role along = east_north ? Role::kVelocityEast : Role::kVelocityX;
  const auto first = header.only(along);
  const auto second = header.only(part_of(along, 1));
  if (!first || !second) {
    notes.push_back(left_out(east_north ? "beside such positions they must be named east and north"
                                        : "beside such positions they must be named vx and vy"));
    return std::nullopt;
  }
  const auto third = header.only(part_of(along, 2));
  const auto down = header.only(Role::kVelocityDown);
  const bool downwards = east_north && !third && down;
  VelocityChoice choice = chosen(*first, *second, downwards ? down : third);
  choice.down = downwards;
  note_choice(question, choice, east_north, notes);
  return choice;
}

std::optional<VelocityChoice> choose_over_ground(const VelocityQuestion& question,
                                                 std::vector<std::string>& notes) {
  if (question.frame != Frame::kWgs84 && !is_east_north(question)) return std::nullopt;
  const Header& header = question.header;
  const auto speed = header.only(Role::kGroundSpeed);
  const auto track = header.only(Role::kTrack);
  if (!speed || !track) return std::nullopt;
  VelocityChoice choice = chosen(*speed, *track, header.only(Role::kClimb));
  choice.over_ground = true;
  note_choice(question, choice, true, notes);
  return choice;
}

// A velocity along axes that is said to be in a column of directions.
std::optional<Error> direction_as_speed(const Header& header) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto column = header.override_of(part_of(Role::kVelocityX, i));
    if (!column || *column >= header.size()) continue;
    const std::vector<std::string> words = split_words(header.table().names[*column]);
    const bool direction = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return is_one_of("track heading course direction bearing azimuth cog", word);
    });
    if (!direction) continue;
    return at_column(ErrorCode::kInvalidArgument,
                     column_text(header.table(), *column) +
                         " holds a direction, which is no speed along an axis; a speed, its "
                         "direction and a climb rate are read by their names in the header, as "
                         "'groundspeed [kt]', 'track' and 'vertical_rate [ft/min]'",
                     *column);
  }
  return std::nullopt;
}

std::optional<VelocityChoice> choose_columns_of(const VelocityQuestion& question,
                                                std::vector<std::string>& notes) {
  const auto east = question.header.override_of(Role::kVelocityX);
  const auto north = question.header.override_of(Role::kVelocityY);
  if (east && north) {
    const VelocityChoice choice =
        chosen(*east, *north, question.header.override_of(Role::kVelocityZ));
    note_choice(question, choice, question.frame == Frame::kWgs84, notes);
    return choice;
  }
  auto choice = choose_along_axes(question, notes);
  return choice ? choice : choose_over_ground(question, notes);
}

// Which units they have, and that they are all known.
std::optional<Error> settle_units(const VelocityQuestion& question, VelocityChoice& choice,
                                  std::vector<UnitTaken>& taken) {
  const std::vector<std::string>& names = question.header.table().names;
  std::vector<ColumnUnit> units;
  std::vector<UnitTaken> found;
  for (std::size_t i = 0; i < choice.dimensions; ++i) {
    if (choice.over_ground && i == 1) continue;
    const std::size_t column = choice.columns[i];
    Unit unit = if_unit_of(question.header.stated(column).unit, Quantity::kSpeed);
    if (unit == Unit::kUnstated && column < names.size()) {
      std::vector<std::string> words = split_words(names[column]);
      unit = take_unit(words, Quantity::kSpeed).value_or(Unit::kUnstated);
    }
    // Crazyflie: millimetres a second beside millimetres.
    const bool of_crazyflie =
        column < names.size() && plain_name(names[column]).starts_with("stateestimatez_v");
    if (of_crazyflie && unit == Unit::kUnstated) unit = Unit::kMillimetrePerSecond;
    const bool climb = i == 2;
    auto one = question.units.choose(climb ? UnitRole::kClimb : UnitRole::kSpeed,
                                     climb ? "climb rates" : "speeds", column, unit);
    if (!one) return one.error();
    // Beside pixels they may be pixels per second.
    if (question.position.units[0] == Unit::kPixel && one->evidence == UnitEvidence::kUsual) {
      return at_column(ErrorCode::kInvalidArgument,
                       column_text(question.header.table(), column) +
                           " holds the velocity, but in which unit? Positions are in pixels; say "
                           "it in the header, as in " +
                           excerpt("vx [mm/s]") + ", or with --units speed=mm/s",
                       column);
    }
    choice.units[i] = one->unit;
    units.push_back({column, one->unit, one->evidence});
    const bool same =
        !found.empty() && found.back().of == one->of && found.back().unit == one->unit;
    if (!same) found.push_back(*std::move(one));
  }
  taken.insert(taken.end(), found.begin(), found.end());
  return names.empty() ? std::nullopt : half_stated(names, units);
}

}  // namespace

Result<std::optional<VelocityChoice>> choose_velocity(const VelocityQuestion& question,
                                                      std::vector<std::string>& notes,
                                                      std::vector<UnitTaken>& taken) {
  if (auto error = direction_as_speed(question.header)) return *std::move(error);
  const std::size_t said = notes.size();
  auto choice = choose_columns_of(question, notes);
  if (!choice) return choice;
  if (auto error = settle_units(question, *choice, taken)) {
    if (question.needed) return *std::move(error);
    notes.resize(said);
    notes.push_back(
        "velocities are not read, and not needed here: in which unit they are is not "
        "said (--units)");
    return std::optional<VelocityChoice>();
  }
  return choice;
}

Velocity in_metric(const std::array<double, 3>& stated, const VelocityChoice& choice) {
  std::array<double, 3> values = stated;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (choice.over_ground && i == 1) continue;
    if (choice.units[i] != Unit::kMetrePerSecond) {
      values[i] = without_dust(in_metric(values[i], choice.units[i]));
    }
  }
  const double up = choice.down ? -values[2] : values[2];
  if (!choice.over_ground) return {values[0], values[1], up};
  constexpr double kMostTurns_deg = 1e12;  // of local_velocity()
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(values[0]) || !(std::abs(values[1]) <= kMostTurns_deg)) {
    return {kUnknown, kUnknown, up};
  }
  const LocalVelocity velocity = local_velocity(values[0], values[1], 0.0);
  return {without_dust(velocity.east_mps), without_dust(velocity.north_mps), up};
}

}  // namespace beespace::io
