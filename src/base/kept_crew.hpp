// The threads of an object that works again and again.
#pragma once

#include "base/crew_size.hpp"

#include <beespace/crew.hpp>

#include <cstddef>
#include <optional>

namespace beespace::core {

// The caller's crew, which must outlive this; or, without one, threads of its own, which are kept
// as long as calls ask for as many.
class KeptCrew {
 public:
  explicit KeptCrew(Crew* lent) : lent_(lent) {}

  // For a call that asks for so many threads (0: one per processor) and works on so many points. A
  // lent crew works as a whole.
  Crew& of(unsigned threads, std::size_t points) {
    if (lent_ != nullptr) return *lent_;
    const unsigned size = cpu::crew_size(threads, points);
    if (size == 1) return alone_;
    if (!own_ || asked_for_ != size) {
      own_.emplace(size);
      asked_for_ = size;
    }
    return *own_;
  }

 private:
  Crew* lent_;
  Crew alone_;
  std::optional<ThreadCrew> own_;
  unsigned asked_for_ = 0;  // the system may have given fewer
};

}  // namespace beespace::core
