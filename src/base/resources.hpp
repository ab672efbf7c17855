// What a search works with: threads and memory. The caller lends both.
#pragma once

#include "base/memory.hpp"

#include <beespace/crew.hpp>

#include <vector>

namespace beespace::core {

struct Resources {
  Crew& crew;
  Memory& memory;
};

// A vector in working memory.
template <class T>
using Vector = std::pmr::vector<T>;

// A list for each worker, in the worker's own memory.
template <class T>
class PerWorker {
 public:
  explicit PerWorker(const Resources& with) : parts_(&with.memory) {
    parts_.reserve(with.crew.size());
    for (unsigned worker = 0; worker < with.crew.size(); ++worker) {
      parts_.push_back({Vector<T>(&with.memory.of(worker))});
    }
  }

  Vector<T>& operator[](std::size_t worker) { return parts_[worker].list; }
  const Vector<T>& operator[](std::size_t worker) const { return parts_[worker].list; }
  [[nodiscard]] std::size_t size() const { return parts_.size(); }

  // All lists, one behind the other.
  Vector<T> joined() && {
    Vector<T> all = std::move(parts_[0].list);
    for (std::size_t part = 1; part < parts_.size(); ++part) {
      all.insert(all.end(), parts_[part].list.begin(), parts_[part].list.end());
    }
    return all;
  }

 private:
  // Not a vector in a vector: that would take its memory from the outer one's.
  struct Part {
    Vector<T> list;
  };

  Vector<Part> parts_;
};

}  // namespace beespace::core
