// Several workers on one thread, the last one first: a pool without concurrency, in which no answer
// may depend on the order in which workers finish.
#pragma once

#include <beespace/crew.hpp>

namespace beespace::test {

class BackwardCrew final : public Crew {
 public:
  explicit BackwardCrew(unsigned size) : size_(size) {}

  [[nodiscard]] unsigned size() const override { return size_; }
  void run(Task task) override {
    for (unsigned worker = size_; worker > 0; --worker) task(worker - 1);
  }

 private:
  unsigned size_;
};

}  // namespace beespace::test
