// Memory on many threads at once; in a program that the thread sanitizer can look at.
#include "base/memory.hpp"

#include "base/buffer.hpp"
#include "base/resources.hpp"

#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace beespace::core {
namespace {

TEST(Memory, ServesManyThreads) {
  Memory memory;
  ThreadCrew crew(4);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::size_t> wrong(crew.size(), 0);
    crew.run([&](unsigned worker) {
      for (std::size_t bytes = 1; bytes < 300'000; bytes = bytes * 3 + worker) {
        Buffer<std::uint32_t> numbers(memory, bytes);
        std::fill_n(numbers.data(), bytes, worker);
        Vector<std::uint32_t> more(bytes, worker, &memory);
        for (std::size_t i = 0; i < bytes; ++i) {
          wrong[worker] += numbers[i] != worker || more[i] != worker ? 1U : 0U;
        }
      }
    });
    EXPECT_EQ(wrong, std::vector<std::size_t>(crew.size(), 0));
  }
}

}  // namespace
}  // namespace beespace::core
