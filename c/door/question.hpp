// What all questions have in common: they check their arguments, run, and leave a result that is
// complete or empty.
#pragma once

#include "c/door/door.hpp"
#include "c/door/engine.hpp"
#include "c/door/points.hpp"
#include "c/door/result.hpp"
#include "c/door/watched_call.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <utility>

namespace beespace::c {

// The flags that each search with a threshold obeys.
inline constexpr std::uint32_t kWithin = BEESPACE_INCLUSIVE | BEESPACE_VERTICAL;

// The engine of a call: the caller's, or one for this call alone.
class CallEngine {
 public:
  explicit CallEngine(beespace_engine* given) {
    if (given == nullptr) own_.emplace();
    used_ = given == nullptr ? &*own_ : given;
  }
  CallEngine(const CallEngine&) = delete;
  CallEngine& operator=(const CallEngine&) = delete;
  ~CallEngine() = default;
  beespace_engine& operator*() { return *used_; }

 private:
  std::optional<beespace_engine> own_;
  beespace_engine* used_ = nullptr;
};

// Calls work(), which returns a Status and writes into the result.
template <class Work>
beespace_code answer_into(beespace_result* result, beespace_error* error, Work&& work) {
  const beespace_code code = enter(error, [&]() -> Status {
    if (result == nullptr) return invalid("the pointer to the result is NULL", "result");
    result->clear();
    return work();
  });
  if (code != BEESPACE_OK && result != nullptr) result->clear();
  return code;
}

// Asks ask(sets, engine, run options, result), which returns a Status.
template <class Ask>
beespace_code answer(beespace_engine* engine, const beespace_points* points,
                     const beespace_points* others, const beespace_run* run,
                     beespace_result* result, beespace_error* error, Ask&& ask) {
  return answer_into(result, error, [&]() -> Status {
    const Result<PointSets> sets = sets_of(points, others);
    if (!sets) return sets.error();
    CallEngine used(engine);
    return call_watched(run, [&](const RunOptions& options) -> Status {
      return ask(*sets, *used, options, *result);
    });
  });
}

}  // namespace beespace::c
