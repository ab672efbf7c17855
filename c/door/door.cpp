#include "c/door/door.hpp"

#include "c/door/structs.hpp"

#include <algorithm>
#include <cstring>
#include <string_view>

namespace beespace::c {

// C++ may number its codes anew; C may not. The compiler names a code that is missing here.
beespace_code code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidThreshold:
      return BEESPACE_INVALID_THRESHOLD;
    case ErrorCode::kInvalidArgument:
      return BEESPACE_INVALID_ARGUMENT;
    case ErrorCode::kNotFinite:
      return BEESPACE_NOT_FINITE;
    case ErrorCode::kOutsideDomain:
      return BEESPACE_OUTSIDE_DOMAIN;
    case ErrorCode::kTooManyPoints:
      return BEESPACE_TOO_MANY_POINTS;
    case ErrorCode::kTooManyResults:
      return BEESPACE_TOO_MANY_RESULTS;
    case ErrorCode::kInvalidLatitude:
      return BEESPACE_INVALID_LATITUDE;
    case ErrorCode::kInvalidLongitude:
      return BEESPACE_INVALID_LONGITUDE;
    case ErrorCode::kInvalidHeight:
      return BEESPACE_INVALID_HEIGHT;
    case ErrorCode::kTimeOrder:
      return BEESPACE_TIME_ORDER;
    case ErrorCode::kCannotOpen:
      return BEESPACE_CANNOT_OPEN;
    case ErrorCode::kReadFailed:
      return BEESPACE_READ_FAILED;
    case ErrorCode::kNoPoints:
      return BEESPACE_NO_POINTS;
    case ErrorCode::kMissingColumn:
      return BEESPACE_MISSING_COLUMN;
    case ErrorCode::kNotANumber:
      return BEESPACE_NOT_A_NUMBER;
    case ErrorCode::kColumnCount:
      return BEESPACE_COLUMN_COUNT;
    case ErrorCode::kMalformedRecord:
      return BEESPACE_MALFORMED_RECORD;
    case ErrorCode::kUnknownFrame:
      return BEESPACE_UNKNOWN_FRAME;
    case ErrorCode::kUnsupportedFormat:
      return BEESPACE_UNSUPPORTED_FORMAT;
    case ErrorCode::kTruncated:
      return BEESPACE_TRUNCATED;
    case ErrorCode::kCorrupt:
      return BEESPACE_CORRUPT;
    case ErrorCode::kWriteFailed:
      return BEESPACE_WRITE_FAILED;
    case ErrorCode::kStopped:
      return BEESPACE_STOPPED;
  }
  return BEESPACE_INTERNAL;
}

namespace {

template <std::size_t Size>
void write_text(char (&into)[Size], std::string_view text) {
  const std::size_t length = std::min(text.size(), Size - 1);
  std::memcpy(into, text.data(), length);
  into[length] = '\0';
}

beespace_code fill(beespace_error* error, beespace_code code, std::string_view place,
                   std::int64_t record, std::string_view message) {
  // One that is smaller than the first version has no room for what it must hold.
  if (error == nullptr || size_of_struct(error) < sizeof(beespace_error)) return code;
  error->code = code;
  error->reserved = 0;
  error->record = record;
  write_text(error->place, place);
  write_text(error->message, message);
  return code;
}

}  // namespace

beespace_code refuse(beespace_error* error, const Error& cause) {
  const ErrorLocation& where = cause.location;
  return fill(error, code_of(cause.code), where.array,
              where.record ? static_cast<std::int64_t>(*where.record) : -1, cause.message);
}

beespace_code refuse_out_of_memory(beespace_error* error) {
  return fill(error, BEESPACE_OUT_OF_MEMORY, "", -1,
              "the system gives no more memory: ask for less at once, or limit the results");
}

beespace_code refuse_internal(beespace_error* error) {
  return fill(error, BEESPACE_INTERNAL, "", -1,
              "something that beespace does not expect went wrong: please report it");
}

Error invalid(const char* message, const char* place) {
  Error error{ErrorCode::kInvalidArgument, message, {}};
  error.location.array = place;
  return error;
}

}  // namespace beespace::c

extern "C" {

const char* beespace_code_name(beespace_code code) {
  if (code == BEESPACE_OK) return "ok";
  if (code == BEESPACE_OUT_OF_MEMORY) return "out_of_memory";
  if (code == BEESPACE_INTERNAL) return "internal";
  // Few enough to look through; the names are literals, so they end with a zero byte.
  for (int each = 0; each <= static_cast<int>(beespace::ErrorCode::kStopped); ++each) {
    const auto error = static_cast<beespace::ErrorCode>(each);
    if (beespace::c::code_of(error) == code) return beespace::to_string(error).data();
  }
  return "unknown";
}

}  // extern "C"
