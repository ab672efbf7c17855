// Bytes on their way out, gzip-compressed if wished.
//
// The compressed bytes hold no time and no name, so that they depend on the content only.
#pragma once

#include "io/atomic_output.hpp"

#include <memory>
#include <string_view>

namespace beespace::cli {

class GzipWriter {
 public:
  // With `compressed` false everything passes through as it is.
  GzipWriter(io::AtomicOutput& output, bool compressed);
  ~GzipWriter();
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void write(std::string_view bytes);
  // Writes what is still inside; nothing may be written afterwards.
  void finish();

 private:
  struct Deflate;
  void deflate_some(std::string_view bytes, int flush);

  io::AtomicOutput& output_;
  std::unique_ptr<Deflate> deflate_;
};

}  // namespace beespace::cli
