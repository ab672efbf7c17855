// How far a read has come.
#pragma once

#include <atomic>
#include <cstdint>

namespace beespace::io {

// How far a long read has come; written by the reader, read by what shows it.
struct Progress {
  std::atomic<std::uint64_t> done{0};   // bytes
  std::atomic<std::uint64_t> total{0};  // bytes; 0 while unknown
};

}  // namespace beespace::io
