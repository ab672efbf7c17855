// What `beespace fleet` cannot do, and what it has to be told.
#pragma once

#include <beespace/result.hpp>

#include <string>
#include <utility>

namespace beespace::cli {

inline Error cannot_compare(std::string what) {
  return {ErrorCode::kUnsupportedFormat, std::move(what), {}};
}

// With what is to be typed.
inline Error to_be_said(std::string what) {
  return {ErrorCode::kInvalidArgument, std::move(what), {}};
}

}  // namespace beespace::cli
