#include "io/tracks/track_velocity.hpp"

#include "io/frames/track_domain.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/header_words.hpp"

#include <beespace/geodesy.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beespace::io {
namespace {

constexpr std::size_t kAxes = 7;

using Found = std::array<std::optional<std::size_t>, kAxes>;  // by VelocityAxis

std::optional<std::size_t> at(const Found& found, VelocityAxis axis) {
  return found[static_cast<std::size_t>(axis)];
}

// Whether x points east and y north.
bool is_east_north(const VelocityQuestion& question) {
  const auto says = [&question](std::size_t column, std::string_view stem) {
    if (column >= question.seen.names.size()) return false;
    const auto words = split_words(question.seen.names[column]);
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
  Found found = {};
  bool any = false;
  for (std::size_t i = 0; i < question.words.size(); ++i) {
    const TrackWord& word = question.words[i];
    if (word.role != TrackRole::kVelocity) continue;
    any = true;
    auto& place = found[static_cast<std::size_t>(word.axis)];
    if (!word.foreign_unit.empty()) {
      notes.push_back(left_out("column " + excerpt(question.seen.names[i]) + " is in '" +
                               word.foreign_unit + "', which is no unit of a speed"));
      return std::nullopt;
    }
    if (place) {
      notes.push_back(left_out("several columns hold the same part of it"));
      return std::nullopt;
    }
    place = i;
  }
  if (!any) return std::nullopt;
  const bool compass = at(found, VelocityAxis::kEast) && at(found, VelocityAxis::kNorth);
  const bool east_north = geographic || (compass && is_east_north(question));
  const auto first = at(found, east_north ? VelocityAxis::kEast : VelocityAxis::kX);
  const auto second = at(found, east_north ? VelocityAxis::kNorth : VelocityAxis::kY);
  if (!first || !second) {
    notes.push_back(left_out(east_north ? "beside such positions they must be named east and north"
                                        : "beside such positions they must be named vx and vy"));
    return std::nullopt;
  }
  auto third = at(found, east_north ? VelocityAxis::kUp : VelocityAxis::kZ);
  const auto down = at(found, VelocityAxis::kDown);
  const bool downwards = east_north && !third && down;
  VelocityChoice choice = chosen(*first, *second, downwards ? down : third);
  choice.down = downwards;
  note_choice(question, choice, east_north, notes);
  return choice;
}

// The only column of that role; nothing where there is none, or several.
std::optional<std::size_t> only(const VelocityQuestion& question, TrackRole role) {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < question.words.size(); ++i) {
    if (question.words[i].role != role) continue;
    if (found) return std::nullopt;
    found = i;
  }
  return found;
}

std::optional<VelocityChoice> choose_over_ground(const VelocityQuestion& question,
                                                 std::vector<std::string>& notes) {
  if (question.frame != Frame::kWgs84) return std::nullopt;
  const auto speed = only(question, TrackRole::kGroundSpeed);
  const auto track = only(question, TrackRole::kTrack);
  if (!speed || !track) return std::nullopt;
  VelocityChoice choice = chosen(*speed, *track, only(question, TrackRole::kClimb));
  choice.over_ground = true;
  note_choice(question, choice, true, notes);
  return choice;
}

std::optional<VelocityChoice> choose_columns_of(const VelocityQuestion& question,
                                                std::vector<std::string>& notes) {
  const auto& wished = question.wishes.velocity;
  if (wished[0] && wished[1]) {
    const VelocityChoice choice = chosen(*wished[0], *wished[1], wished[2]);
    note_choice(question, choice, question.frame == Frame::kWgs84, notes);
    return choice;
  }
  auto choice = choose_along_axes(question, notes);
  return choice ? choice : choose_over_ground(question, notes);
}

// Which units they have, and that they are all known.
std::optional<Error> settle_units(const VelocityQuestion& question, VelocityChoice& choice,
                                  std::vector<UnitTaken>& taken) {
  const std::vector<std::string>& names = question.seen.names;
  std::vector<ColumnUnit> units;
  std::vector<UnitTaken> found;
  for (std::size_t i = 0; i < choice.dimensions; ++i) {
    if (choice.over_ground && i == 1) continue;
    const std::size_t column = choice.columns[i];
    const Unit unit =
        column < names.size() ? read_track_word(names[column]).speed_unit : Unit::kUnstated;
    const bool climb = i == 2;
    auto one = question.units.choose(climb ? UnitRole::kClimb : UnitRole::kSpeed,
                                     climb ? "climb rates" : "speeds", column, unit);
    if (!one) return one.error();
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
  auto choice = choose_columns_of(question, notes);
  if (!choice) return choice;
  if (auto error = settle_units(question, *choice, taken)) return *std::move(error);
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
