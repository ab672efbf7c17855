// Hands and memory for what a test calls in the library's rooms.
#pragma once

#include "base/memory.hpp"
#include "base/resources.hpp"

#include <beespace/crew.hpp>

namespace beespace::test {

struct OwnResources {
  explicit OwnResources(unsigned threads = 1) : crew(threads) {}
  OwnResources(const OwnResources&) = delete;
  OwnResources& operator=(const OwnResources&) = delete;

  ThreadCrew crew;
  core::Memory memory;
  core::Resources with{crew, memory};
};

}  // namespace beespace::test
