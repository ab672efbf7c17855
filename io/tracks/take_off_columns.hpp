// Columns of the tables of autopilots that tell from which height a drone took off: how high it is
// above that place, beside the height that is taken, or whether it is armed, or has landed.
#pragma once

#include "io/recording/take_offs.hpp"
#include "io/table/table_layout.hpp"
#include "io/units/units.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// What a column says of whether it stands.
enum class StandingForm : std::uint8_t {
  kLandedState,  // MAV_LANDED_STATE of MAVLink, as a number or by its name
  kArmed,        // who is not armed stands
  kLanded,       // yes or no
  kInAir,        // likewise
};

struct TakeOffColumns {
  std::optional<std::size_t> above = {};  // how high above the place of take-off
  std::optional<std::size_t> standing = {};
  Unit above_unit = Unit::kMetre;
  StandingForm form = StandingForm::kArmed;
  bool is_taken_height = false;  // the height that is taken counts from there itself

  [[nodiscard]] bool any() const { return above || standing || is_taken_height; }
};

TakeOffColumns find_take_off_columns(const TableLayout& table);

// What a record says, whose height is that, in metres. The texts are those of the columns.
TakeOffSaid take_off_said(const TakeOffColumns& columns, std::string_view above,
                          std::string_view standing, double height_m);

// Whether columns say what autopilots alone do: armed, landed_state, heights above the place of
// take-off. Those above the ground beneath are not meant.
bool names_autopilot(const TableLayout& table);

// "--columns lon=4,lat=3,height=6 --crs wgs84": what takes the heights above the place of take-off
// that are in another column; nothing where there is none.
std::string heights_beside(const TakeOffColumns& columns, const TableLayout& table);

}  // namespace beespace::io
