// A vector of answers that is about to be written throughout.
#pragma once

#include "base/memory.hpp"

#include <cstddef>
#include <vector>

namespace beespace::core {

// Like resize, but forgets what was there if it must grow, and asks for huge pages then.
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
