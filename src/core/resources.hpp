// What a search works with: hands and memory. Both are lent by whoever calls.
#pragma once

#include "core/memory.hpp"

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

// What each worker found, one behind the other.
template <class T>
Vector<T> joined(Vector<Vector<T>>&& parts) {
  for (std::size_t part = 1; part < parts.size(); ++part) {
    parts[0].insert(parts[0].end(), parts[part].begin(), parts[part].end());
  }
  return std::move(parts[0]);
}

}  // namespace beespace::core
