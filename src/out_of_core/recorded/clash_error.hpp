// Two fixes of one agent at one time, as an error.
#pragma once

#include "exact/validate.hpp"
#include "out_of_core/recorded/stored_fixes.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::out_of_core {

inline Error clash_error(const LargeTimeClash& clash) {
  Error error{ErrorCode::kTimeOrder,
              "the agent has two fixes at " + core::shown(clash.time_s) +
                  " s, the first as record " + std::to_string(clash.first_row) +
                  "; leave one of them out",
              {}};
  error.location.array = "times";
  error.location.record = clash.second_row;
  return error;
}

}  // namespace beespace::out_of_core
