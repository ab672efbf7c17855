// Errors as values: what went wrong, where, and what to do about it.
//
// beespace throws nothing but std::bad_alloc. A function that can fail returns Result<T>: a T, or
// an Error. Values own their data; nothing is shared or global.
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

enum class ErrorCode : std::uint8_t {
  // What the caller asked for.
  kInvalidThreshold,  // not finite, not above zero, or outside the coordinate domain
  kInvalidArgument,   // any other option that makes no sense
  // The points.
  kNotFinite,         // a NaN or an infinity among the coordinates
  kOutsideDomain,     // a coordinate outside the coordinate domain (see point.hpp)
  kTooManyPoints,     // more than kMaxPoints
  kTooManyResults,    // more pairs or neighbours than SearchOptions::max_results
  kInvalidLatitude,   // beyond +-90 degrees
  kInvalidLongitude,  // beyond +-360 degrees
  kInvalidHeight,     // no bee flies there
  kTimeOrder,         // a time that does not come after the one before it
  // Reading.
  kCannotOpen,         // missing, a directory, or not readable
  kReadFailed,         // the system failed us in the middle
  kNoPoints,           // empty, or a header and nothing else
  kMissingColumn,      // a column that was asked for, or is needed, is not there
  kNotANumber,         // a field that should hold a number holds something else
  kColumnCount,        // a record with another number of columns than the ones before it
  kMalformedRecord,    // an unclosed quote, a line too long to be a record
  kUnknownFrame,       // degrees or metres? the data does not say
  kUnsupportedFormat,  // not a format, type or shape that beespace reads
  kTruncated,          // the file ends too early
  kCorrupt,            // damaged data (a bad checksum, for example)
  // Writing.
  kWriteFailed,  // full disk, missing folder, no permission
};

// The name of a code, as it appears in JSON output: "invalid_threshold", "not_a_number", ...
BEESPACE_API std::string_view to_string(ErrorCode code);

// Where an error lies; what does not apply stays empty.
struct Place {
  std::string source = {};                   // the file, or "<stdin>"
  std::optional<std::uint64_t> line = {};    // 1-based line of the file
  std::optional<std::uint64_t> column = {};  // 1-based column (field) of the record
  std::optional<std::uint64_t> record = {};  // 0-based point or data row
};

struct Error {
  ErrorCode code = ErrorCode::kInvalidArgument;
  std::string message = {};  // one sentence: what is wrong and what to do
  Place place = {};
};

// "bees.csv:3:2: 'abc' is not a number ...", the way compilers say it.
BEESPACE_API std::string to_string(const Error& error);

// Either a value or an Error. Ask has_value() first: value() of an error, and error() of a value,
// are undefined behaviour (caught by an assertion in debug builds).
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}      // NOLINT
  Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}  // NOLINT

  [[nodiscard]] bool has_value() const { return content_.index() == 0; }
  explicit operator bool() const { return has_value(); }

  [[nodiscard]] T& value() & { return *checked(std::get_if<0>(&content_)); }
  [[nodiscard]] const T& value() const& { return *checked(std::get_if<0>(&content_)); }
  // By value, so that `for (auto id : *find_at_risk(points))` has something to stand on.
  [[nodiscard]] T value() && { return std::move(*checked(std::get_if<0>(&content_))); }
  [[nodiscard]] Error& error() & { return *checked(std::get_if<1>(&content_)); }
  [[nodiscard]] const Error& error() const& { return *checked(std::get_if<1>(&content_)); }
  [[nodiscard]] Error error() && { return std::move(*checked(std::get_if<1>(&content_))); }

  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

 private:
  template <class Pointer>
  static Pointer checked(Pointer pointer) {
    assert(pointer != nullptr && "the Result holds the other alternative");
    return pointer;
  }

  std::variant<T, Error> content_;
};

// For functions that return nothing but may fail: success, or an Error.
using Status = Result<std::monostate>;

}  // namespace beespace
