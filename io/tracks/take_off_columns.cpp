#include "io/tracks/take_off_columns.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/position_columns.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <vector>

namespace beespace::io {
namespace {

// Above the ground beneath, which is another one elsewhere.
bool is_above_ground(const std::string& name) {
  const std::vector<std::string> words = split_words(name);
  const auto any_is = [&words](std::string_view any_of) {
    return std::any_of(words.begin(), words.end(),
                       [any_of](const std::string& word) { return is_one_of(any_of, word); });
  };
  return any_is("agl hagl ground terrain terr altaboveground altitudeaboveterr");
}

bool is_above_take_off(const std::string& name) {
  return counts_from_takeoff(name) && !is_above_ground(name);
}

std::optional<StandingForm> standing_form(const std::string& name) {
  const std::string plain = plain_name(name);
  if (is_one_of("landed_state landedstate", plain)) return StandingForm::kLandedState;
  if (is_one_of("armed is_armed isarmed", plain)) return StandingForm::kArmed;
  if (is_one_of("landed is_landed on_ground is_on_ground", plain)) return StandingForm::kLanded;
  if (is_one_of("in_air is_in_air is_flying in_flight", plain)) return StandingForm::kInAir;
  return std::nullopt;
}

// Whether it says that it stands; nothing where it says neither.
std::optional<bool> says_standing(StandingForm form, std::string_view text) {
  const std::string word = lower_case(text);
  double number = 0.0;
  const bool is_number = parse_number(text, number) == NumberKind::kNumber;
  switch (form) {
    case StandingForm::kLandedState:
      if (is_number ? number == 1.0 : word.ends_with("on_ground") || word == "landed") return true;
      if (is_number ? number >= 2.0
                    : word.ends_with("in_air") || word.ends_with("takeoff") ||
                          word.ends_with("landing")) {
        return false;
      }
      return std::nullopt;
    case StandingForm::kArmed:
      if (says_no(text) || word == "disarmed") return true;
      break;  // who is armed may stand
    case StandingForm::kLanded:
      if (says_yes(text)) return true;
      if (says_no(text)) return false;
      break;
    case StandingForm::kInAir:
      if (says_no(text)) return true;
      if (says_yes(text)) return false;
      break;
  }
  return std::nullopt;
}

}  // namespace

TakeOffColumns find_take_off_columns(const TableLayout& table) {
  TakeOffColumns columns;
  const ColumnChoice& choice = table.choice;
  if (choice.dimensions != 3) return columns;
  columns.is_taken_height = choice.datum == HeightDatum::kHome &&
                            choice.axes[2] < table.names.size() &&
                            is_above_take_off(table.names[choice.axes[2]]);
  if (columns.is_taken_height) return columns;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (i == choice.axes[0] || i == choice.axes[1] || i == choice.axes[2]) continue;
    const std::string& name = table.names[i];
    if (!columns.above && is_above_take_off(name)) {
      columns.above = i;
      const Unit named = read_column_name(track_columns(), name).unit;
      columns.above_unit = named == Unit::kUnstated ? choice.units[2] : named;
    }
    const auto form = standing_form(name);
    // What says more comes first.
    if (form && (!columns.standing || *form < columns.form)) {
      columns.standing = i;
      columns.form = *form;
    }
  }
  return columns;
}

TakeOffSaid take_off_said(const TakeOffColumns& columns, std::string_view above,
                          std::string_view standing, double height_m) {
  if (columns.is_taken_height) return {0.0, height_m > kFliesAboveTakeOff_m};
  TakeOffSaid said;
  if (columns.above) {
    double value = 0.0;
    if (parse_number(above, value) != NumberKind::kNumber) return said;
    const double above_m = in_metric(value, columns.above_unit);
    return {height_m - above_m, above_m > kFliesAboveTakeOff_m};
  }
  if (!columns.standing) return said;
  const auto stands = says_standing(columns.form, standing);
  if (stands.value_or(false)) said.ground_m = height_m;
  said.flies = columns.form == StandingForm::kArmed ? says_yes(standing) : stands == false;
  return said;
}

bool names_autopilot(const TableLayout& table) {
  return std::any_of(table.names.begin(), table.names.end(), [](const std::string& name) {
    const auto form = standing_form(name);
    return is_above_take_off(name) || form == StandingForm::kArmed ||
           form == StandingForm::kLandedState;
  });
}

std::string heights_beside(const TakeOffColumns& columns, const TableLayout& table) {
  if (!columns.above) return {};
  const ColumnChoice& choice = table.choice;
  return "--columns lon=" + std::to_string(choice.axes[0] + 1) +
         ",lat=" + std::to_string(choice.axes[1] + 1) +
         ",height=" + std::to_string(*columns.above + 1) + " --crs wgs84";
}

}  // namespace beespace::io
