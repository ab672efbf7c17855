// Resizes a vector of answers whose elements will all be written.
#pragma once

#include "base/memory.hpp"
#include "base/stopping.hpp"

#include <beespace/crew.hpp>

#include <cstddef>
#include <vector>

namespace beespace::core {

// Like resize, but drops the old contents if it must grow, and requests huge pages then. The system
// takes seconds to find some gigabytes: it is a task of the crew, which can be given up.
template <class T, class Allocator>
void resize_for(std::vector<T, Allocator>& vector, std::size_t size, Crew& crew) {
  if (vector.capacity() < size) {
    vector.clear();
    vector.reserve(size);
    advise_huge_pages(vector.data(), vector.capacity() * sizeof(T));
  }
  constexpr std::size_t kAtOnce = std::size_t{1} << 22;  // bytes, within a millisecond
  if (size <= vector.size() || (size - vector.size()) * sizeof(T) <= kAtOnce) {
    return vector.resize(size);
  }
  crew.run([&](unsigned worker) {
    if (worker != 0) return;
    const std::size_t before = vector.size();
    in_stretches(size - before, [&](std::size_t, std::size_t end) { vector.resize(before + end); });
  });
}

}  // namespace beespace::core
