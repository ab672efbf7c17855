// Resizes a vector of answers whose elements will all be written.
#pragma once

#include "base/memory.hpp"

#include <cstddef>
#include <vector>

namespace beespace::core {

// Like resize, but drops the old contents if it must grow, and requests huge pages then.
template <class T>
void resize_for(std::vector<T>& vector, std::size_t size) {
  if (vector.capacity() < size) {
    vector.clear();
    vector.reserve(size);
    advise_huge_pages(vector.data(), vector.capacity() * sizeof(T));
  }
  vector.resize(size);
}

}  // namespace beespace::core
