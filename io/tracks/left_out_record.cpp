// Why a record of a table becomes no fix without being a mistake.
#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/unplaced.hpp"
#include "io/tracks/short_number.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_marks.hpp"
#include "io/tracks/track_record.hpp"
#include "io/units/units.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {

TextInSlot TrackRecordReader::text_in_slot() const {
  return [this](std::size_t slot) { return std::string(fields_[slot].text); };
}

// Of what aircraft say of themselves: what is not known is no mistake.
const LeftOutReason* TrackRecordReader::reason_to_leave_out() const {
  if (const LeftOutReason* const reason = reason_by_marks(layout_, text_in_slot())) return reason;
  if (!layout_.of_aircraft && !layout_.places_may_be_unknown) return nullptr;
  const auto unknown = [this](std::size_t slot) {
    const std::string_view text = without_padding(fields_[slot].text);
    return is_unknown(text) || (layout_.infinite_is_unknown && (text == "inf" || text == "-inf"));
  };
  if (layout_.on_ground && says_yes(fields_[TrackSlot::kOnGround].text) && !flies()) {
    return &kOnGround;
  }
  const bool no_first = unknown(TrackSlot::kPosition);
  const bool no_second = unknown(TrackSlot::kPosition + 1);
  if (layout_.of_aircraft && (no_first || no_second)) return &kNoPosition;
  if (!layout_.of_aircraft && no_first && no_second) return &kUnknownPlace;
  if (!layout_.of_aircraft && (no_first || no_second)) return &kHalfPlace;
  // Of others a bad time is a mistake.
  if (!layout_.of_aircraft) {
    const bool has_height = layout_.table.choice.dimensions == 3;
    if (!has_height || !unknown(TrackSlot::kPosition + 2)) return nullptr;
    return layout_.no_height != nullptr ? layout_.no_height : &kHalfPlace;
  }
  if (layout_.time && unknown(TrackSlot::kTime)) return &kNoTime;
  if (layout_.age && is_old()) return &kOldPlace;
  const bool height = layout_.table.choice.dimensions == 3;
  if (layout_.ground_at_zero && says_no(fields_[TrackSlot::kPosition + 2].text)) {
    if (flies()) return &kNoPressureHeight;
    if (!layout_.keeps_grounded) return &kOnGround;
  }
  if (height && unknown(TrackSlot::kPosition + 2)) return layout_.no_height;
  return height && layout_.other_height && heights_contradict() ? &kHeightsContradict : nullptr;
}

// Or of an age that is not known.
bool TrackRecordReader::is_old() const {
  double age_s = 0.0;
  return read_number(without_padding(fields_[TrackSlot::kAge].text), age_s) !=
             NumberKind::kNumber ||
         age_s > kOldPlace_s;
}

// Of an aircraft that tells both; what is no number is judged where it is read. A height of 0 that
// is not taken is what decoders write for none.
bool TrackRecordReader::heights_contradict() const {
  double taken = 0.0;
  double other = 0.0;
  const auto reads = [this](std::size_t slot, double& value) {
    return read_number(without_padding(fields_[slot].text), value) == NumberKind::kNumber;
  };
  return reads(TrackSlot::kPosition + 2, taken) && reads(TrackSlot::kOtherHeight, other) &&
         other != 0.0 &&
         std::abs(in_metric(taken, layout_.table.choice.units[2]) -
                  in_metric(other, layout_.other_height_unit)) > kMostHeightsDiffer_m;
}

// Of an aircraft that says that it is on the ground: whether it is higher, faster or climbs more
// than any aircraft there.
bool TrackRecordReader::flies() const {
  const auto beyond = [this](std::size_t slot, Unit unit, double most) {
    double value = 0.0;
    return read_number(without_padding(fields_[slot].text), value) == NumberKind::kNumber &&
           std::abs(in_metric(value, unit)) > most;
  };
  const ColumnChoice& choice = layout_.table.choice;
  if (choice.dimensions == 3 &&
      beyond(TrackSlot::kPosition + 2, choice.units[2], kHighestGround_m)) {
    return true;
  }
  if (!layout_.velocity || !layout_.velocity->over_ground) return false;
  const VelocityChoice& velocity = *layout_.velocity;
  return beyond(TrackSlot::kVelocity, velocity.units[0], kFastestOnGround_mps) ||
         (velocity.dimensions == 3 &&
          beyond(TrackSlot::kVelocity + 2, velocity.units[2], kMostClimbOnGround_mps));
}

}  // namespace beespace::io
