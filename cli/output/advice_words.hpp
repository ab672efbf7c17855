// What kinds of advice are called, wherever the command writes them.
#pragma once

#include <beespace/advise.hpp>

namespace beespace::cli {

constexpr const char* name_of(AdviceKind kind) {
  switch (kind) {
    case AdviceKind::kAsPreferred:
      return "as-preferred";
    case AdviceKind::kDeflected:
      return "deflected";
    case AdviceKind::kBraking:
      return "braking";
    case AdviceKind::kWaiting:
      return "waiting";
    case AdviceKind::kNone:
      return "none";
  }
  return "unknown";
}

constexpr const char* name_of(RefusedKind kind) {
  switch (kind) {
    case RefusedKind::kState:
      return "state";
    case RefusedKind::kPreferred:
      return "preferred";
    case RefusedKind::kIntruder:
      return "intruder";
    case RefusedKind::kUnknown:
      return "unknown";
  }
  return "unknown";
}

constexpr const char* name_of(AdviseMethod method) {
  switch (method) {
    case AdviseMethod::kCertified:
      return "certified";
    case AdviseMethod::kOrca:
      return "orca";
    case AdviseMethod::kMvp:
      return "mvp";
  }
  return "unknown";
}

}  // namespace beespace::cli
