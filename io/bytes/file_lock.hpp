// A file of which one process at a time may keep account: that of a planner, or of an agent.
#pragma once

#include "io/bytes/descriptor.hpp"

#include <beespace/result.hpp>

#include <string>
#include <utility>

namespace beespace::io {

// Held until it goes, or its process ends, however that ends.
class FileLock {
 public:
  // Holds nothing.
  FileLock() = default;

  // For the file `path`, which need not be there. What is locked is a file of its own beside it,
  // PATH.lock, which stays: the file itself is replaced as often as it is written. Errors:
  // kCannotOpen, that another `holder` works with it; of the disk.
  static Result<FileLock> take(const std::string& path, const char* holder);

 private:
  explicit FileLock(Descriptor file) : file_(std::move(file)) {}

  Descriptor file_;
};

}  // namespace beespace::io
