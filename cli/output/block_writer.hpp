// Text in large blocks: a string that is appended to freely and handed on when it is long.
#pragma once

#include "io/bytes/atomic_output.hpp"

#include <cstddef>
#include <string>

namespace beespace::cli {

class BlockWriter {
 public:
  explicit BlockWriter(io::AtomicOutput& output) : output_(output) { text.reserve(2 * kBlock); }
  ~BlockWriter() { output_.write(text); }
  BlockWriter(const BlockWriter&) = delete;
  BlockWriter& operator=(const BlockWriter&) = delete;

  // After every piece of some hundred bytes.
  void pass_on() {
    if (text.size() < kBlock) return;
    output_.write(text);
    text.clear();
  }

  std::string text;

 private:
  static constexpr std::size_t kBlock = std::size_t{1} << 16;
  io::AtomicOutput& output_;
};

}  // namespace beespace::cli
