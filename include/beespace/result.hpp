/// @file
/// @brief Errors as values: what went wrong, where, and what to do about it.
///
/// beespace throws nothing but std::bad_alloc. A function that can fail returns a Result<T>: a T,
/// or an Error. Values own their data; nothing is shared or global.
#pragma once

#include <beespace/export.hpp>

#include <cassert>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace beespace {

/// @brief The kinds of errors.
enum class ErrorCode : std::uint8_t {
  // The options.
  kInvalidThreshold,  ///< A threshold that is not finite, not above zero (a radius: below zero),
                      ///< or outside the domain.
  kInvalidArgument,   ///< Any other option that makes no sense.
  // The points.
  kNotFinite,       ///< A NaN or an infinity among the coordinates.
  kOutsideDomain,   ///< A value outside the coordinate domain (see Point), or the motion domain
                    ///< (see mover.hpp).
  kTooManyPoints,   ///< More points, agents or tracks than #kMaxPoints or SwarmOptions::max_agents,
                    ///< or no id is left.
  kTooManyResults,  ///< More pairs, neighbours or conflicts than `max_results` of the options.
  kInvalidLatitude,   ///< A latitude beyond +-90 degrees.
  kInvalidLongitude,  ///< A longitude beyond +-360 degrees.
  kInvalidHeight,     ///< A height beyond #kLowestHeight_m or #kGreatestHeight_m.
  kTimeOrder,         ///< A time that does not come after the one before it.
  // Reading.
  kCannotOpen,         ///< The file is missing, a directory, or not readable.
  kReadFailed,         ///< The system failed in the middle of reading.
  kNoPoints,           ///< Empty, or a header and nothing else.
  kMissingColumn,      ///< A column that was asked for, or is needed, is not there.
  kNotANumber,         ///< A field that should hold a number holds something else.
  kColumnCount,        ///< A record with another number of columns than the ones before it.
  kMalformedRecord,    ///< An unclosed quote, or a line too long to be a record.
  kUnknownFrame,       ///< Degrees or metres? The data does not say.
  kUnsupportedFormat,  ///< Not a format, type or shape that beespace reads.
  kTruncated,          ///< The file ends too early.
  kCorrupt,            ///< Damaged data (a bad checksum, for example).
  // Writing.
  kWriteFailed,  ///< A full disk, a missing folder, no permission.
  // Ending early.
  kStopped,  ///< A stop was requested (see RunOptions::stop) before the answer was complete.
};

/// @brief Names a code as JSON output does: "invalid_threshold", "not_a_number", ...
/// @param code The code.
/// @return Its name; "unknown" for a value that is no code. Valid until the program ends.
BEESPACE_API std::string_view to_string(ErrorCode code);

/// @brief Where an error lies; what does not apply stays empty.
struct ErrorLocation {
  std::string source = {};                   ///< The file, or "<stdin>".
  std::optional<std::uint64_t> line = {};    ///< The 1-based line of the file.
  std::optional<std::uint64_t> column = {};  ///< The 1-based column (field) of the record.
  std::optional<std::uint64_t> record = {};  ///< The 0-based row of data, or index into
                                             ///< `array`; of "agents" an AgentId.
  /// @brief The array of a call that the error is about, by the name of its parameter or option:
  /// "points", "others", "places", "radii", "movers", "preferred", "limits", "intruders",
  /// "unknown", "obstacles", "tracks", "pieces"; or "agents", those of a Swarm. Empty where the
  /// error is about a file, or about no array.
  std::string array = {};
};

/// @brief What went wrong, where, and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::kInvalidArgument;  ///< The kind of error.
  std::string message = {};                      ///< One sentence: what is wrong and what to do.
  ErrorLocation location = {};                   ///< Where it lies.
};

/// @brief Describes an error as compilers do: "bees.csv:3:2: 'abc' is not a number ...".
/// @param error The error.
/// @return The text.
BEESPACE_API std::string to_string(const Error& error);

template <class T>
class Result;

namespace detail {

template <class T>
inline constexpr bool kIsResult = false;
template <class T>
inline constexpr bool kIsResult<Result<T>> = true;

// Calls with the value; with nothing, where the value says nothing and the callable takes nothing.
template <class Callable, class Value>
constexpr decltype(auto) call_with(Callable&& callable, Value&& value) {
  if constexpr (std::is_same_v<std::remove_cvref_t<Value>, std::monostate> &&
                std::is_invocable_v<Callable>) {
    return std::invoke(std::forward<Callable>(callable));
  } else {
    return std::invoke(std::forward<Callable>(callable), std::forward<Value>(value));
  }
}

}  // namespace detail

/// @brief Either a value or an Error, with the names of std::expected (C++23).
///
/// Precondition of value(), operator* and operator->: has_value(). Precondition of error(): not
/// has_value(). A violation is undefined behaviour, caught by an assertion in debug builds. Unlike
/// that of std::expected, value() never throws.
///
/// What a temporary Result holds is moved out of it, so that it does not dangle; operator-> of a
/// temporary does not compile.
///
/// Thread safety: as that of T.
template <class T>
class [[nodiscard]] Result {
 public:
  /// @brief The type of the value.
  using value_type = T;
  /// @brief The type of the error.
  using error_type = Error;

  /// @brief Holds a value.
  /// @param value The value; moved in.
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT
  /// @brief Holds an error.
  /// @param error The error; moved in.
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  /// @brief Says whether this holds a value.
  /// @return False when it holds an error.
  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  /// @brief Says whether this holds a value. (Of a Result<bool> that is not the value.)
  [[nodiscard]] explicit operator bool() const { return has_value(); }

  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  [[nodiscard]] T& value() & { return *checked(std::get_if<0>(&content_)); }
  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  [[nodiscard]] const T& value() const& { return *checked(std::get_if<0>(&content_)); }
  /// @brief Moves the value out. Precondition: has_value().
  /// @return The value, not a reference, so that in `for (auto id : *find_at_risk(points,
  /// options))`
  ///   it lives as long as the loop.
  [[nodiscard]] T value() && { return std::move(*checked(std::get_if<0>(&content_))); }
  const T& value() const&& = delete;

  /// @brief Gives the error. Precondition: not has_value().
  /// @return The error, in the memory of this.
  [[nodiscard]] Error& error() & { return *checked(std::get_if<1>(&content_)); }
  /// @brief Gives the error. Precondition: not has_value().
  /// @return The error, in the memory of this.
  [[nodiscard]] const Error& error() const& { return *checked(std::get_if<1>(&content_)); }
  /// @brief Moves the error out. Precondition: not has_value().
  /// @return The error.
  [[nodiscard]] Error error() && { return std::move(*checked(std::get_if<1>(&content_))); }
  const Error& error() const&& = delete;

  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  [[nodiscard]] T& operator*() & { return value(); }
  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  [[nodiscard]] const T& operator*() const& { return value(); }
  /// @brief Moves the value out. Precondition: has_value().
  /// @return The value.
  [[nodiscard]] T operator*() && { return std::move(*this).value(); }
  const T& operator*() const&& = delete;

  /// @brief Gives a member of the value. Precondition: has_value().
  /// @return A pointer to the value, in the memory of this.
  [[nodiscard]] T* operator->() & { return &value(); }
  /// @brief Gives a member of the value. Precondition: has_value().
  /// @return A pointer to the value, in the memory of this.
  [[nodiscard]] const T* operator->() const& { return &value(); }
  // A member of a temporary would dangle in `for (auto id : find(...)->ids)`.
  T* operator->() && = delete;
  const T* operator->() const&& = delete;

  /// @brief Gives the value, or another one where there is none.
  /// @param fallback Converted to T where this holds an error.
  /// @return A copy of the value, or the fallback.
  template <class Fallback = T>
  [[nodiscard]] T value_or(Fallback&& fallback) const& {
    return has_value() ? value() : static_cast<T>(std::forward<Fallback>(fallback));
  }
  /// @brief Moves the value out, or gives another one where there is none.
  /// @param fallback Converted to T where this holds an error.
  /// @return The value, or the fallback.
  template <class Fallback = T>
  [[nodiscard]] T value_or(Fallback&& fallback) && {
    return has_value() ? std::move(*this).value()
                       : static_cast<T>(std::forward<Fallback>(fallback));
  }

  /// @brief Goes on with a function that may fail, too.
  /// @param next Called with the value, if there is one; returns a Result of any type. Of a Status
  /// it
  ///   may also take no argument.
  /// @return What `next` returns, or the error of this.
  template <class Next>
  auto and_then(Next&& next) & {
    return go_on(*this, std::forward<Next>(next));
  }
  /// @copydoc and_then
  template <class Next>
  auto and_then(Next&& next) const& {
    return go_on(*this, std::forward<Next>(next));
  }
  /// @copydoc and_then
  template <class Next>
  auto and_then(Next&& next) && {
    return go_on(std::move(*this), std::forward<Next>(next));
  }

  /// @brief Goes on with a function that cannot fail.
  /// @param next Called with the value, if there is one; returns any value, or nothing. Of a Status
  ///   it may also take no argument.
  /// @return A Result of what `next` returns (a Status, where that is nothing), or the error of
  /// this.
  template <class Next>
  auto transform(Next&& next) & {
    return change(*this, std::forward<Next>(next));
  }
  /// @copydoc transform
  template <class Next>
  auto transform(Next&& next) const& {
    return change(*this, std::forward<Next>(next));
  }
  /// @copydoc transform
  template <class Next>
  auto transform(Next&& next) && {
    return change(std::move(*this), std::forward<Next>(next));
  }

  /// @brief Changes the error, for example to add where it lies.
  /// @param change Called with the error, if there is one; returns an Error.
  /// @return The value of this, or what `change` returns.
  template <class Change>
  Result transform_error(Change&& change) const& {
    if (has_value()) return *this;
    return Result(Error(std::invoke(std::forward<Change>(change), error())));
  }
  /// @copydoc transform_error
  template <class Change>
  Result transform_error(Change&& change) && {
    if (has_value()) return std::move(*this);
    return Result(Error(std::invoke(std::forward<Change>(change), std::move(*this).error())));
  }

  /// @brief Tries something else after an error.
  /// @param other Called with the error, if there is one; returns a Result of the same type.
  /// @return The value of this, or what `other` returns.
  template <class Other>
  Result or_else(Other&& other) const& {
    if (has_value()) return *this;
    return std::invoke(std::forward<Other>(other), error());
  }
  /// @copydoc or_else
  template <class Other>
  Result or_else(Other&& other) && {
    if (has_value()) return std::move(*this);
    return std::invoke(std::forward<Other>(other), std::move(*this).error());
  }

 private:
  template <class Pointer>
  static Pointer checked(Pointer pointer) {
    assert(pointer != nullptr && "the Result holds the other alternative");
    return pointer;
  }

  template <class Self, class Next>
  static auto go_on(Self&& self, Next&& next) {
    using Other = std::remove_cvref_t<decltype(detail::call_with(
        std::forward<Next>(next), std::forward<Self>(self).value()))>;
    static_assert(detail::kIsResult<Other>, "the function of and_then must return a Result");
    if (!self.has_value()) return Other(std::forward<Self>(self).error());
    return Other(detail::call_with(std::forward<Next>(next), std::forward<Self>(self).value()));
  }

  template <class Self, class Next>
  static auto change(Self&& self, Next&& next) {
    using Returned =
        decltype(detail::call_with(std::forward<Next>(next), std::forward<Self>(self).value()));
    if constexpr (std::is_void_v<Returned>) {
      if (!self.has_value()) return Result<std::monostate>(std::forward<Self>(self).error());
      detail::call_with(std::forward<Next>(next), std::forward<Self>(self).value());
      return Result<std::monostate>(std::monostate{});
    } else {
      using Other = Result<std::remove_cvref_t<Returned>>;
      if (!self.has_value()) return Other(std::forward<Self>(self).error());
      return Other(detail::call_with(std::forward<Next>(next), std::forward<Self>(self).value()));
    }
  }

  std::variant<T, Error> content_;
};

/// @brief The result of a function that returns nothing but may fail: success, or an Error.
///
/// A Result with all that belongs to it; a function makes a success by `return std::monostate{};`.
using Status = Result<std::monostate>;

}  // namespace beespace
