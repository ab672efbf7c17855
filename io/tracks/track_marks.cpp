// What columns say of a whole record: that its place is none, or wrong.
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/column_overrides.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/track_aircraft.hpp"
#include "io/tracks/track_record.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

bool says_neither(std::string_view text) {
  return !is_unknown(without_padding(text)) && !says_yes(text) && !says_no(text);
}

}  // namespace

// As the owner of the data has marked it.
bool TrackRecordReader::is_outlier() const {
  if (layout_.visible && says_no(fields_[TrackSlot::kVisible].text)) return true;
  if (layout_.marked_valid && says_yes(fields_[TrackSlot::kValid].text)) return false;
  for (std::size_t i = 0; i < layout_.marked.size(); ++i) {
    if (says_yes(fields_[TrackSlot::kMarked + i].text)) return true;
  }
  return false;
}

// In words that are not known: no guess is made.
std::optional<Error> TrackRecordReader::unclear_word() const {
  const auto problem = [this](std::size_t column, std::size_t slot, std::string_view what,
                              std::string_view remedy) {
    return at_column(ErrorCode::kMalformedRecord,
                     column_text(layout_.table, column) + " says " + std::string(what) + ", but " +
                         excerpt(without_padding(fields_[slot].text)) +
                         " is not known: " + std::string(remedy) + std::string(kOrLeaveOut),
                     column);
  };
  if (layout_.quality && is_unclear(*layout_.quality, fields_[TrackSlot::kQuality].text)) {
    return problem(layout_.quality->column, TrackSlot::kQuality, "whether there was a fix",
                   "write 'fix' or 'no fix' there, or give the column another name if all its "
                   "records are places");
  }
  constexpr std::string_view kOfOutliers = "whether a place is an outlier";
  constexpr std::string_view kYesOrNo = "write true or false there";
  if (layout_.visible && says_neither(fields_[TrackSlot::kVisible].text)) {
    return problem(*layout_.visible, TrackSlot::kVisible, kOfOutliers, kYesOrNo);
  }
  for (std::size_t i = 0; i < layout_.marked.size(); ++i) {
    if (!says_neither(fields_[TrackSlot::kMarked + i].text)) continue;
    return problem(layout_.marked[i], TrackSlot::kMarked + i, kOfOutliers, kYesOrNo);
  }
  return std::nullopt;
}

}  // namespace beespace::io
