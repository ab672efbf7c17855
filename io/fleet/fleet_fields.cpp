#include "io/fleet/fleet_fields.hpp"

#include "io/fleet/fleet_message.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace beespace::io {

FleetFields::FleetFields(JsonElement object, std::string_view what) : what_(what) {
  is_object_ = object.get(members_);
  if (!is_object_) {
    fail(ErrorCode::kMalformedRecord, "there is " + std::string(json_kind(object)) + " where " +
                                          std::string(what) +
                                          " should be, an object in { }; correct it");
    return;
  }
  check_twice();
}

// No two readers would take an object alike that has a member twice.
void FleetFields::check_twice() {
  std::array<std::string_view, kMostMembers> met;
  std::size_t count = 0;
  for (const auto member : members_) {
    if (count == met.size()) {
      is_object_ = false;
      return fail(ErrorCode::kMalformedRecord,
                  std::string(what_) + " has more members than any message; correct it");
    }
    const auto end = met.begin() + static_cast<std::ptrdiff_t>(count);
    if (std::find(met.begin(), end, member.key) != end) {
      return fail(ErrorCode::kMalformedRecord,
                  excerpt(member.key) + " is there twice in " + std::string(what_) + "; keep one");
    }
    met[count++] = member.key;
  }
}

std::string FleetFields::name(std::string_view key) const {
  std::string out(1, '\'');
  out.append(key).append("' of ").append(what_);
  return out;
}

void FleetFields::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

std::optional<JsonElement> FleetFields::find(std::string_view key) {
  if (asked_count_ < asked_.size()) asked_[asked_count_++] = key;
  JsonElement found;
  if (!is_object_ || !members_.get(key, found) || found.is_null()) return std::nullopt;
  return found;
}

std::optional<JsonElement> FleetFields::need(std::string_view key) {
  const auto found = find(key);
  if (!found) {
    fail(ErrorCode::kMissingColumn,
         std::string(what_) + " has no '" + std::string(key) + "'; add it");
  }
  return found;
}

double FleetFields::amount(JsonElement element, std::string_view key) {
  double value = 0.0;
  if (!element.get(value)) {
    fail(ErrorCode::kNotANumber, name(key) + " is " + std::string(json_kind(element)) +
                                     " where a number should be; correct it");
    return 0.0;
  }
  if (std::abs(value) <= kMostAmount) return value;
  fail(ErrorCode::kOutsideDomain,
       name(key) + " is beyond all that flies; give a size of at most 1e12");
  return 0.0;
}

double FleetFields::number(std::string_view key) {
  const auto found = need(key);
  return found ? amount(*found, key) : 0.0;
}

double FleetFields::from_zero(std::string_view key) {
  const double value = number(key);
  if (value >= 0.0) return value;
  fail(ErrorCode::kInvalidArgument, name(key) + " is below zero; give zero or more");
  return 0.0;
}

double FleetFields::from_zero_or(std::string_view key, double otherwise) {
  JsonElement found;
  const bool given = is_object_ && members_.get(key, found) && !found.is_null();
  if (given) return from_zero(key);
  find(key);
  return otherwise;
}

bool FleetFields::numbers(JsonElement element, std::string_view key, std::span<double> values) {
  JsonArray items;
  if (!element.get(items) || items.size() != values.size()) {
    fail(ErrorCode::kColumnCount,
         name(key) + " is no array of " + std::to_string(values.size()) + " numbers; correct it");
    return false;
  }
  std::size_t place = 0;
  for (const JsonElement item : items) values[place++] = amount(item, key);
  return true;
}

Point FleetFields::point(std::string_view key) {
  std::array<double, 3> values = {};
  const auto found = need(key);
  if (found) numbers(*found, key, values);
  return {values[0], values[1], values[2]};
}

std::optional<Velocity> FleetFields::velocity_if(std::string_view key) {
  std::array<double, 3> values = {};
  const auto found = find(key);
  if (!found || !numbers(*found, key, values)) return std::nullopt;
  return Velocity{values[0], values[1], values[2]};
}

std::optional<Tick> FleetFields::tick_if(std::string_view key) {
  const auto found = find(key);
  if (!found) return std::nullopt;
  std::int64_t tick = 0;
  if (found->get(tick) && tick >= -kMostTick && tick <= kMostTick) return tick;
  fail(ErrorCode::kNotANumber, name(key) + " is no tick; give a whole number from -2^53 to 2^53");
  return std::nullopt;
}

Tick FleetFields::tick(std::string_view key) {
  const auto tick = tick_if(key);
  if (!tick) {
    fail(ErrorCode::kMissingColumn,
         std::string(what_) + " has no '" + std::string(key) + "'; add it");
  }
  return tick.value_or(0);
}

std::uint32_t FleetFields::whole(std::string_view key) {
  const auto found = need(key);
  std::uint64_t value = 0;
  if (!found) return 0;
  if (found->get(value) && value <= std::numeric_limits<std::uint32_t>::max()) {
    return static_cast<std::uint32_t>(value);
  }
  fail(ErrorCode::kNotANumber, name(key) + " is no whole number from 0 to 4294967295; correct it");
  return 0;
}

bool FleetFields::flag(std::string_view key) {
  const auto found = need(key);
  bool value = false;
  if (found && !found->get(value)) {
    fail(ErrorCode::kNotANumber, name(key) + " is neither true nor false; correct it");
  }
  return value;
}

std::string_view FleetFields::text(std::string_view key) {
  const auto found = need(key);
  std::string_view value;
  if (found && !found->get(value)) {
    fail(ErrorCode::kMalformedRecord, name(key) + " is " + std::string(json_kind(*found)) +
                                          " where a text should be; correct it");
  }
  return value;
}

BranchNumber FleetFields::branch(std::string_view key) {
  const BranchNumber number = branch_or_none(key);
  if (number == 0) {
    fail(ErrorCode::kMissingColumn,
         std::string(what_) + " has no '" + std::string(key) + "'; add it");
  }
  return number;
}

BranchNumber FleetFields::branch_or_none(std::string_view key) {
  const auto found = find(key);
  if (!found) return 0;
  std::string_view text;
  if (found->get(text)) {
    if (const auto number = parse_branch(text)) return *number;
  }
  fail(ErrorCode::kMalformedRecord,
       name(key) + R"( is no number of a branch; give one such as "3.17": epoch and count)");
  return 0;
}

std::optional<JsonArray> FleetFields::array(std::string_view key, std::size_t most) {
  const auto found = need(key);
  if (!found) return std::nullopt;
  JsonArray items;
  if (!found->get(items)) {
    fail(ErrorCode::kMalformedRecord, name(key) + " is " + std::string(json_kind(*found)) +
                                          " where an array should be; correct it");
    return std::nullopt;
  }
  if (items.size() <= most) return items;
  fail(ErrorCode::kColumnCount, name(key) + " has " + std::to_string(items.size()) +
                                    " entries, and may have " + std::to_string(most) +
                                    " at most; correct it");
  return std::nullopt;
}

std::optional<Error> FleetFields::error() {
  if (error_ || !is_object_) return error_;
  const auto end = asked_.begin() + static_cast<std::ptrdiff_t>(asked_count_);
  for (const auto member : members_) {
    if (std::find(asked_.begin(), end, member.key) != end) continue;
    std::string list;
    for (auto key = asked_.begin(); key != end; ++key) {
      list.append(list.empty() ? "" : ", ").append(*key);
    }
    fail(ErrorCode::kUnsupportedFormat, std::string(what_) + " has a member " +
                                            excerpt(member.key) +
                                            " that is not known; it may have " + list);
    break;
  }
  return error_;
}

}  // namespace beespace::io
