#include "io/units/unit_overrides.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace beespace::io {
namespace {

struct Slot {
  UnitRole role;
  std::string_view name;
  Unit UnitOverrides::*unit;
};

constexpr std::array<Slot, 4> kSlots = {
    {{UnitRole::kPosition, "position", &UnitOverrides::position},
     {UnitRole::kHeight, "height", &UnitOverrides::height},
     {UnitRole::kSpeed, "speed", &UnitOverrides::speed},
     {UnitRole::kClimb, "climb", &UnitOverrides::climb}}};

Error invalid(std::string message) {
  return {ErrorCode::kInvalidArgument, "--units: " + std::move(message), {}};
}

Error not_understood(std::string_view item) {
  return invalid(excerpt(item) +
                 " is not understood; write role=unit, where the role is position, height, speed "
                 "or climb, as in height=ft,speed=kt,climb=ft/min; or metric, or aviation");
}

std::optional<UnitConvention> convention_of(std::string_view word) {
  if (word == "metric") return UnitConvention::kMetric;
  if (word == "aviation") return UnitConvention::kAviation;
  return std::nullopt;
}

const Slot& slot_of(UnitRole role) {
  return kSlots[static_cast<std::size_t>(role)];
}

}  // namespace

std::string_view role_name(UnitRole role) {
  return slot_of(role).name;
}

Quantity quantity_of(UnitRole role) {
  const bool length = role == UnitRole::kPosition || role == UnitRole::kHeight;
  return length ? Quantity::kLength : Quantity::kSpeed;
}

bool UnitOverrides::any() const {
  for (const Slot& slot : kSlots) {
    if (this->*slot.unit != Unit::kUnstated) return true;
  }
  return false;
}

Unit UnitOverrides::of(UnitRole role) const {
  return this->*slot_of(role).unit;
}

Result<UnitOverrides> read_unit_overrides(std::string_view text) {
  UnitOverrides overrides;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view item = text.substr(0, comma);
    const std::size_t equals = item.find('=');
    if (const auto convention = convention_of(without_padding(item))) {
      if (overrides.convention != UnitConvention::kNone) {
        return invalid("metric and aviation are given, or one of them twice; keep one");
      }
      overrides.convention = *convention;
      if (comma == std::string_view::npos) break;
      text.remove_prefix(comma + 1);
      if (text.empty()) return invalid("a comma at the end; remove it");
      continue;
    }
    if (equals == std::string_view::npos) return not_understood(item);
    const std::string_view role = without_padding(item.substr(0, equals));
    const std::string_view word = without_padding(item.substr(equals + 1));
    const Slot* slot = nullptr;
    for (const Slot& known : kSlots) {
      if (role == known.name) slot = &known;
    }
    if (slot == nullptr || word.empty()) return not_understood(item);
    Unit& unit = overrides.*slot->unit;
    if (unit != Unit::kUnstated) return invalid(std::string(role) + " is given twice; keep one");
    const Quantity quantity = quantity_of(slot->role);
    const auto found = unit_of_text(word, quantity);
    if (!found) {
      return invalid(excerpt(word) + " is no unit of a " + std::string(role) + "; it is one of " +
                     list_units(quantity));
    }
    unit = *found;
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
    if (text.empty()) return invalid("a comma at the end; remove it");
  }
  return overrides;
}

}  // namespace beespace::io
