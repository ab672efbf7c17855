// Clears the caller's container when a search fails, so that an answer of an earlier call is not
// taken for one of this call.
#pragma once

#include "base/stopping.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/result.hpp>

#include <utility>
#include <vector>

namespace beespace::core {

template <class Entry>
void empty(std::vector<Entry>& answer) {
  answer.clear();
}
inline void empty(NearestRows& answer) {
  answer.length = 0;
  answer.entries.clear();
}
inline void empty(IdRows& answer) {
  answer.offsets.clear();
  answer.ids.clear();
}

// Returns what ask() does, a Status; or the error of a call that was stopped.
template <class Answer, class Ask>
Status answered(Answer& answer, Ask&& ask) {
  try {
    Status status = unless_stopped(std::forward<Ask>(ask));
    if (!status) empty(answer);
    return status;
  } catch (...) {
    empty(answer);
    throw;
  }
}

}  // namespace beespace::core
