#include "io/tracks/track_marks.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/problems/unplaced.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/track_aircraft.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

// By its own word, as its failsafe begins at less: as of logs.
constexpr double kMostOff_m = 10.0;

bool says_neither(std::string_view text) {
  return !is_unknown(without_padding(text)) && !says_yes(text) && !says_no(text);
}

// As Ornitela calls them: "SENSORS", "SEN_ALL_20Hz".
bool is_of_sensors(std::string_view datatype) {
  return without_padding(datatype).starts_with("SEN");
}

// As Movebank calls what it has of a tag beside its places, and by the numbers of these kinds.
bool is_beside_places(std::string_view sensor) {
  constexpr std::array kKinds = {std::string_view("acceleration"),
                                 std::string_view("accessory-measurements"),
                                 std::string_view("accessory measurements"),
                                 std::string_view("barometer"),
                                 std::string_view("magnetometer"),
                                 std::string_view("gyroscope"),
                                 std::string_view("orientation"),
                                 std::string_view("2365683"),
                                 std::string_view("7842954")};
  const std::string kind = lower_case(without_padding(sensor));
  return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

bool is_only_of_sensors(const TextInSlot& text_in) {
  const std::string sensor = text_in(TrackSlot::kSensor);
  if (is_of_sensors(sensor)) return true;
  return is_beside_places(sensor) && is_unknown(without_padding(text_in(TrackSlot::kPosition))) &&
         is_unknown(without_padding(text_in(TrackSlot::kPosition + 1)));
}

// As the owner of the data has marked it.
bool is_outlier(const TrackLayout& layout, const TextInSlot& text_in) {
  if (layout.visible && says_no(text_in(TrackSlot::kVisible))) return true;
  if (layout.marked_valid && says_yes(text_in(TrackSlot::kValid))) return false;
  for (std::size_t i = 0; i < layout.marked.size(); ++i) {
    if (says_yes(text_in(TrackSlot::kMarked + i))) return true;
  }
  return false;
}

}  // namespace

const LeftOutReason* reason_by_marks(const TrackLayout& layout, const TextInSlot& text_in) {
  if (is_outlier(layout, text_in)) return &kOutlier;
  if (layout.sensor && is_only_of_sensors(text_in)) return &kSensorsOnly;
  if (layout.quality && says_no_fix(*layout.quality, text_in(TrackSlot::kQuality))) return &kNoFix;
  if (layout.place_known && says_no(text_in(TrackSlot::kPlaceKnown))) return &kDoubtedPlace;
  if (layout.height_known && says_no(text_in(TrackSlot::kHeightKnown))) return &kDoubtedHeight;
  if (layout.lost && says_yes(text_in(TrackSlot::kLost))) return &kGuessedPlace;
  for (std::size_t i = 0; i < layout.off_m.size(); ++i) {
    double off_m = 0.0;
    if (!layout.off_m[i]) continue;
    const std::string text = text_in(TrackSlot::kOff + i);
    if (parse_number(without_padding(text), off_m) == NumberKind::kNumber && off_m > kMostOff_m) {
      return &kGuessedPlace;
    }
  }
  if (layout.not_seen && says_yes(text_in(TrackSlot::kNotSeen))) return &kUnknownPlace;
  return nullptr;
}

std::optional<Error> unclear_mark(const TrackLayout& layout, const TextInSlot& text_in) {
  const auto problem = [&](std::size_t column, std::size_t slot, std::string_view what,
                           std::string_view remedy) {
    return at_column(ErrorCode::kMalformedRecord,
                     column_text(layout.table, column) + " says " + std::string(what) + ", but " +
                         excerpt(without_padding(text_in(slot))) +
                         " is not known: " + std::string(remedy) + std::string(kOrLeaveOut),
                     column);
  };
  if (layout.quality && is_unclear(*layout.quality, text_in(TrackSlot::kQuality))) {
    return problem(layout.quality->column, TrackSlot::kQuality, "whether there was a fix",
                   "write 'fix' or 'no fix' there, or give the column another name if all its "
                   "records are places");
  }
  constexpr std::string_view kOfOutliers = "whether a place is an outlier";
  constexpr std::string_view kYesOrNo = "write true or false there";
  if (layout.visible && says_neither(text_in(TrackSlot::kVisible))) {
    return problem(*layout.visible, TrackSlot::kVisible, kOfOutliers, kYesOrNo);
  }
  for (std::size_t i = 0; i < layout.marked.size(); ++i) {
    if (!says_neither(text_in(TrackSlot::kMarked + i))) continue;
    return problem(layout.marked[i], TrackSlot::kMarked + i, kOfOutliers, kYesOrNo);
  }
  return std::nullopt;
}

}  // namespace beespace::io
