#include "io/track_velocity.hpp"

#include "io/excerpt.hpp"
#include "io/header_words.hpp"

#include <algorithm>
#include <array>

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
  std::string text = geographic ? "velocities east, north" : "velocities along x, y";
  if (choice.dimensions == 3) text += !geographic ? ", z" : choice.down ? ", down" : ", up";
  text += " in m/s are read from columns";
  for (std::size_t i = 0; i < choice.dimensions; ++i) {
    text.append(i == 0 ? " " : ", ").append(std::to_string(choice.columns[i] + 1));
  }
  if (choice.dimensions == 2 && question.position.dimensions == 3) {
    text += "; how fast bees climb is not known";
  }
  notes.push_back(std::move(text));
}

}  // namespace

std::optional<VelocityChoice> choose_velocity(const VelocityQuestion& question,
                                              std::vector<std::string>& notes) {
  const bool geographic = question.frame == Frame::kWgs84;
  const auto& wished = question.wishes.velocity;
  if (wished[0] && wished[1]) {
    const VelocityChoice choice = chosen(*wished[0], *wished[1], wished[2]);
    note_choice(question, choice, geographic, notes);
    return choice;
  }
  Found found = {};
  bool any = false;
  for (std::size_t i = 0; i < question.words.size(); ++i) {
    const TrackWord& word = question.words[i];
    if (word.role != TrackRole::kVelocity) continue;
    any = true;
    auto& place = found[static_cast<std::size_t>(word.axis)];
    if (!word.foreign_unit.empty()) {
      notes.push_back(left_out("column " + excerpt(question.seen.names[i]) + " is in '" +
                               word.foreign_unit + "', not in m/s"));
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

}  // namespace beespace::io
