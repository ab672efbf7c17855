// Threads and memory for internal functions that tests call.
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
