#include "io/tracks/track_animals.hpp"

#include "io/problems/unplaced.hpp"
#include "io/table/column_names.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

namespace {

// Collars by other makers: "CollarID", "Collar ID"; "Fix Status", as Lotek says of each place.
bool names_collars(const Header& header) {
  for (const std::string& name : header.table().names) {
    const auto words = split_words(name);
    if (std::find(words.begin(), words.end(), "collar") != words.end() ||
        std::find(words.begin(), words.end(), "collarid") != words.end() ||
        words == std::vector<std::string>{"fix", "status"}) {
      return true;
    }
  }
  return false;
}

// How the animal is called whose collar the id is of: "AnimalID" beside "CollarID", "Device Name"
// beside "Device ID".
std::optional<std::size_t> names_of_animals(const Header& header, std::size_t id) {
  const auto is_of_animal = [&header](std::size_t column) {
    const auto words = split_words(header.table().names[column]);
    return !words.empty() && (words.front().starts_with("animal") || words.back() == "name");
  };
  if (is_of_animal(id)) return std::nullopt;
  for (const std::size_t other : header.columns(Role::kId)) {
    if (other != id && is_of_animal(other)) return other;
  }
  return std::nullopt;
}

// Packages of R for animals: "x_", "y_", "t_" of amt; "individual_local_identifier" of move2.
bool is_of_packages_for_animals(const Header& header) {
  const std::vector<std::string>& names = header.table().names;
  const auto has = [&names](std::string_view wanted) {
    return std::find(names.begin(), names.end(), wanted) != names.end();
  };
  if (has("x_") && has("y_") && has("t_")) return true;
  return std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return plain_name(name) == "individual_local_identifier";
  });
}

// In the words of --columns.
HeightColumns height_columns(const Header& header, const TrackLayout& layout) {
  const ColumnChoice& choice = layout.table.choice;
  const bool degrees = layout.frame == Frame::kWgs84;
  const auto number = [&choice](std::size_t axis) { return std::to_string(choice.axes[axis] + 1); };
  HeightColumns columns;
  columns.flat.append(degrees ? "lon=" : "x=").append(number(0));
  columns.flat.append(degrees ? ",lat=" : ",y=").append(number(1));
  const bool said = header.override_of(Role::kHeight) || header.override_of(Role::kZ);
  if (choice.dimensions == 3 && !said) {
    columns.heights = columns.flat + (degrees ? ",height=" : ",z=") + number(2);
  }
  return columns;
}

}  // namespace

void settle_animals(const Header& header, TrackLayout& layout) {
  if (layout.of_aircraft || !layout.time) return;
  const TableSource* const source = header.source();
  const bool of_animals = source != nullptr && source->of_animals;
  // Who tells how fast it is is no animal in a picture: it should know where it is.
  layout.places_may_be_unknown = of_animals || !layout.velocity;
  layout.of_animals = of_animals || names_collars(header) || is_of_packages_for_animals(header);
  layout.y_is_down =
      (of_animals && source->name == "TRex") || layout.table.choice.units.front() == Unit::kPixel;
  const auto& id_column = layout.table.choice.id;
  if (layout.of_animals && id_column && !header.override_of(Role::kId)) {
    layout.label = names_of_animals(header, *id_column);
  }
  if (!of_animals) return;
  layout.no_height = &kUnknownHeight;
  layout.height_columns = height_columns(header, layout);
  layout.without_id = &kNoAnimal;
  layout.infinite_is_unknown = source->infinite_is_unknown;
  for (std::size_t i = 0; i < header.size(); ++i) {
    const auto words = split_words(header.table().names[i]);
    if (words == std::vector<std::string>{"visible"}) layout.visible = i;
    if (words == std::vector<std::string>{"sensor", "type"}) layout.sensor = i;
    if (words == std::vector<std::string>{"sensor", "type", "id"} && !layout.sensor) {
      layout.sensor = i;
    }
    // "Argos" or "FastGPS"
    const bool of_seals = source->name == "Wildlife Computers";
    if (of_seals && words == std::vector<std::string>{"type"}) layout.sensor = i;
    const bool of_telonics = source->name == "Telonics" && layout.time->column != i;
    if (of_telonics && words == std::vector<std::string>{"acquisition", "time"}) {
      layout.time->due = i;
    }
    if (source->name == "Ornitela" && words == std::vector<std::string>{"datatype"}) {
      layout.sensor = i;
    }
    if (words.size() == 3 && words[1] == "marked" && words[2] == "outlier" &&
        layout.marked.size() < TrackSlot::kMostMarked) {
      layout.marked.push_back(i);
    }
    if (words == std::vector<std::string>{"manually", "marked", "valid"}) layout.marked_valid = i;
    const bool is_tag = words == std::vector<std::string>{"tag", "local", "identifier"};
    if (is_tag && id_column && id_column != i && !header.override_of(Role::kId)) layout.tag = i;
    if (layout.infinite_is_unknown && words == std::vector<std::string>{"missing"}) {
      layout.not_seen = i;
    }
  }
}

}  // namespace beespace::io
