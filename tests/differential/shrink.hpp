// The smallest part of a scene that still shows a difference.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace beespace::differential {

// Leaves out stretches of things, then single ones, as long as `fails` of what is left.
template <class Thing, class Fails>
std::vector<Thing> shrunk(std::vector<Thing> things, Fails&& fails) {
  std::size_t looks = 0;
  constexpr std::size_t kMostLooks = 4000;
  for (std::size_t length = things.size() / 2; length > 0;) {
    bool shorter = false;
    for (std::size_t begin = 0; begin < things.size();) {
      if (++looks > kMostLooks) return things;
      const auto from = things.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto to =
          things.begin() + static_cast<std::ptrdiff_t>(std::min(begin + length, things.size()));
      std::vector<Thing> rest(things.begin(), from);
      rest.insert(rest.end(), to, things.end());
      if (fails(rest)) {
        things = std::move(rest);
        shorter = true;
      } else {
        begin += length;
      }
    }
    if (!shorter || length > 1) length /= 2;
    if (shorter && length == 0) length = 1;
  }
  return things;
}

}  // namespace beespace::differential
