#include "io/tracks/track_accuracy.hpp"

#include "io/bytes/characters.hpp"
#include "io/table/column_names.hpp"
#include "io/units/units.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kOff = "accuracy error hacc";
// What may stand beside these words. Beside "vertical" or "speed" they speak of something else.
constexpr std::string_view kBesideOff =
    "horizontal hor h 3d location position gps eobs estimate est numerical";

// Nothing where the name says anything else, too.
std::optional<Unit> unit_of_accuracy(const std::string& name) {
  Unit unit = Unit::kMetre;
  bool off = false;
  bool beside = false;
  for (const std::string& word : split_words(name)) {
    if (is_one_of(kOff, word)) {
      off = true;
      beside = beside || word != "error";
    } else if (is_one_of(kBesideOff, word)) {
      beside = true;
    } else if (const auto said = unit_of_word(word, Quantity::kLength)) {
      unit = *said;
    } else {
      return std::nullopt;
    }
  }
  return off && beside ? std::optional(unit) : std::nullopt;
}

}  // namespace

void settle_accuracy(const Header& header, TrackLayout& layout) {
  if (layout.of_aircraft || layout.frame != Frame::kWgs84 || !layout.time) return;
  for (std::size_t i = 0; i < header.size() && !layout.accuracy; ++i) {
    if (header.meaning(i).role != Role::kNone) continue;
    const auto unit = unit_of_accuracy(header.table().names[i]);
    if (unit) layout.accuracy = AccuracyColumn{i, *unit};
  }
}

}  // namespace beespace::io
