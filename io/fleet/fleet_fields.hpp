// The members of an object of a message: what is missing, of another kind, there twice or not known
// is an error that says so. The first thing that is wrong is kept: ask for all, then for the error.
//
// Members that are not known are refused: a radius that is misspelt must not count as none.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/command.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace beespace::io {

class FleetFields {
 public:
  // Beyond these nothing is a position, a speed or a time of a fleet.
  static constexpr double kMostAmount = 1e12;
  static constexpr Tick kMostTick = Tick{1} << 53;
  static constexpr std::size_t kMostMembers = 24;

  // `what` is in sentences about it: "a report".
  FleetFields(JsonElement object, std::string_view what);

  // A member; nothing where there is none, or it is null.
  std::optional<JsonElement> find(std::string_view key);
  std::optional<JsonElement> need(std::string_view key);

  // Members that must be there; zero or nothing where there is an error.
  double number(std::string_view key);
  double from_zero(std::string_view key);
  Point point(std::string_view key);
  Tick tick(std::string_view key);
  std::uint32_t whole(std::string_view key);
  bool flag(std::string_view key);
  std::string_view text(std::string_view key);
  BranchNumber branch(std::string_view key);
  // Those that need not be there.
  double from_zero_or(std::string_view key, double otherwise);
  std::optional<Velocity> velocity_if(std::string_view key);
  std::optional<Tick> tick_if(std::string_view key);
  BranchNumber branch_or_none(std::string_view key);

  // An array of at most so many; nothing where there is an error.
  std::optional<JsonArray> array(std::string_view key, std::size_t most);

  // Whether all of an array of numbers could be read.
  bool numbers(JsonElement element, std::string_view key, std::span<double> values);

  void fail(Error error);
  void fail(ErrorCode code, std::string message) { fail(Error{code, std::move(message), {}}); }
  // "'tick' of a report".
  [[nodiscard]] std::string name(std::string_view key) const;

  // What was wrong, or is not known; nothing where all is well. After all has been asked for.
  std::optional<Error> error();

 private:
  void check_twice();
  double amount(JsonElement element, std::string_view key);

  JsonMap members_;
  std::string_view what_;
  std::array<std::string_view, kMostMembers> asked_ = {};
  std::size_t asked_count_ = 0;
  bool is_object_ = false;
  std::optional<Error> error_;
};

}  // namespace beespace::io
