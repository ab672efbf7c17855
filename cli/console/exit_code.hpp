// What the command says to the shell that started it.
#pragma once

#include <beespace/result.hpp>

namespace beespace::cli {

enum class ExitCode : int {
  kFine = 0,
  kRiskFound = 1,  // with --fail-on-risk only; of verify always
  kUsage = 2,      // the command line makes no sense
  kBadInput = 3,   // the data makes no sense
  kSystem = 4,     // could not open, read or write; out of memory
  kHungUp = 129,
  kInterrupted = 130,
  kTerminated = 143,
  kPipeClosed = 141,  // as a tool that SIGPIPE ends
};

constexpr ExitCode exit_code_for(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidThreshold:
    case ErrorCode::kInvalidArgument:
      return ExitCode::kUsage;
    case ErrorCode::kCannotOpen:
    case ErrorCode::kReadFailed:
    case ErrorCode::kWriteFailed:
      return ExitCode::kSystem;
    default:
      return ExitCode::kBadInput;
  }
}

}  // namespace beespace::cli
