/// @file
/// @brief Errors as values: what went wrong, where, and what to do about it.
///
/// beespace throws nothing but std::bad_alloc. A function that can fail returns a Result<T>: a T,
/// or an Error. Values own their data; nothing is shared or global.
#pragma once

#include <beespace/export.hpp>

#include <cassert>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace beespace {

/// @brief The kinds of errors.
enum class ErrorCode : std::uint8_t {
  // The options.
  kInvalidThreshold,  ///< A threshold that is not finite, not above zero, or outside the domain.
  kInvalidArgument,   ///< Any other option that makes no sense.
  // The points.
  kNotFinite,         ///< A NaN or an infinity among the coordinates.
  kOutsideDomain,     ///< A coordinate outside the coordinate domain (see Point).
  kTooManyPoints,     ///< More than #kMaxPoints.
  kTooManyResults,    ///< More pairs or neighbours than SearchOptions::max_results.
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
};

/// @brief Names a code as JSON output does: "invalid_threshold", "not_a_number", ...
/// @param code The code.
/// @return Its name; "unknown" for a value that is no code. Valid until the program ends.
BEESPACE_API std::string_view to_string(ErrorCode code);

/// @brief Where an error lies; what does not apply stays empty.
struct Place {
  std::string source = {};                   ///< The file, or "<stdin>".
  std::optional<std::uint64_t> line = {};    ///< The 1-based line of the file.
  std::optional<std::uint64_t> column = {};  ///< The 1-based column (field) of the record.
  std::optional<std::uint64_t> record = {};  ///< The 0-based point or data row.
};

/// @brief What went wrong, where, and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::kInvalidArgument;  ///< The kind of error.
  std::string message = {};                      ///< One sentence: what is wrong and what to do.
  Place place = {};                              ///< Where it lies.
};

/// @brief Describes an error as compilers do: "bees.csv:3:2: 'abc' is not a number ...".
/// @param error The error.
/// @return The text.
BEESPACE_API std::string to_string(const Error& error);

/// @brief Either a value or an Error.
///
/// Precondition of value(), operator* and operator->: has_value(). Precondition of error(): not
/// has_value(). A violation is undefined behaviour, caught by an assertion in debug builds: nothing
/// is thrown.
///
/// Thread safety: as that of T.
template <class T>
class [[nodiscard]] Result {
 public:
  /// @brief Holds a value.
  /// @param value The value; moved in.
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}  // NOLINT
  /// @brief Holds an error.
  /// @param error The error; moved in.
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  /// @brief Says whether this holds a value.
  /// @return False when it holds an error.
  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  /// @brief Says whether this holds a value.
  explicit operator bool() const { return has_value(); }

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
  /// @brief Gives the error. Precondition: not has_value().
  /// @return The error, in the memory of this.
  [[nodiscard]] Error& error() & { return *checked(std::get_if<1>(&content_)); }
  /// @brief Gives the error. Precondition: not has_value().
  /// @return The error, in the memory of this.
  [[nodiscard]] const Error& error() const& { return *checked(std::get_if<1>(&content_)); }
  /// @brief Moves the error out. Precondition: not has_value().
  /// @return The error.
  [[nodiscard]] Error error() && { return std::move(*checked(std::get_if<1>(&content_))); }

  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  T& operator*() & { return value(); }
  /// @brief Gives the value. Precondition: has_value().
  /// @return The value, in the memory of this.
  const T& operator*() const& { return value(); }
  /// @brief Moves the value out. Precondition: has_value().
  /// @return The value.
  T operator*() && { return std::move(*this).value(); }
  /// @brief Gives a member of the value. Precondition: has_value().
  /// @return A pointer to the value, in the memory of this.
  T* operator->() { return &value(); }
  /// @brief Gives a member of the value. Precondition: has_value().
  /// @return A pointer to the value, in the memory of this.
  const T* operator->() const { return &value(); }

 private:
  template <class Pointer>
  static Pointer checked(Pointer pointer) {
    assert(pointer != nullptr && "the Result holds the other alternative");
    return pointer;
  }

  std::variant<T, Error> content_;
};

/// @brief The result of a function that returns nothing but may fail: success, or an Error.
using Status = Result<std::monostate>;

}  // namespace beespace
