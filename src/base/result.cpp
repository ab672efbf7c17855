#include <beespace/result.hpp>

namespace beespace {

std::string_view to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidThreshold:
      return "invalid_threshold";
    case ErrorCode::kInvalidArgument:
      return "invalid_argument";
    case ErrorCode::kNotFinite:
      return "not_finite";
    case ErrorCode::kOutsideDomain:
      return "outside_domain";
    case ErrorCode::kTooManyPoints:
      return "too_many_points";
    case ErrorCode::kTooManyResults:
      return "too_many_results";
    case ErrorCode::kInvalidLatitude:
      return "invalid_latitude";
    case ErrorCode::kInvalidLongitude:
      return "invalid_longitude";
    case ErrorCode::kInvalidHeight:
      return "invalid_height";
    case ErrorCode::kTimeOrder:
      return "time_order";
    case ErrorCode::kCannotOpen:
      return "cannot_open";
    case ErrorCode::kReadFailed:
      return "read_failed";
    case ErrorCode::kNoPoints:
      return "no_points";
    case ErrorCode::kMissingColumn:
      return "missing_column";
    case ErrorCode::kNotANumber:
      return "not_a_number";
    case ErrorCode::kColumnCount:
      return "column_count";
    case ErrorCode::kMalformedRecord:
      return "malformed_record";
    case ErrorCode::kUnknownFrame:
      return "unknown_frame";
    case ErrorCode::kUnsupportedFormat:
      return "unsupported_format";
    case ErrorCode::kTruncated:
      return "truncated";
    case ErrorCode::kCorrupt:
      return "corrupt";
    case ErrorCode::kWriteFailed:
      return "write_failed";
    case ErrorCode::kStopped:
      return "stopped";
  }
  return "unknown";
}

std::string to_string(const Error& error) {
  const ErrorLocation& location = error.location;
  std::string text = location.source;
  const auto append = [&text](std::uint64_t number) {
    if (!text.empty()) text += ':';
    text += std::to_string(number);
  };
  if (location.line) append(*location.line);
  if (location.column) append(*location.column);
  if (location.record && !location.line) {
    if (!text.empty()) text += ": ";
    const std::string number = std::to_string(*location.record);
    if (location.array.empty()) {
      text += "point " + number;
    } else if (location.array == "agents") {  // a number of the caller's, not an index
      text += "agent " + number;
    } else {
      text += location.array + '[' + number + ']';
    }
  } else if (!location.array.empty()) {
    if (!text.empty()) text += ": ";
    text += location.array;
  }
  if (!text.empty()) text += ": ";
  return text.append(error.message);
}

}  // namespace beespace
