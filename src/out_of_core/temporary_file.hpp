// A file without a name, which is gone when the program ends, however it ends.
#pragma once

#include <beespace/result.hpp>

#include <sys/uio.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace beespace::out_of_core {

class TemporaryFile {
 public:
  // Errors: kWriteFailed, also where the folder has less room than so many bytes.
  static Result<TemporaryFile> make(const std::string& folder, std::uint64_t needed_bytes);

  TemporaryFile(TemporaryFile&& other) noexcept;
  TemporaryFile& operator=(TemporaryFile&& other) noexcept;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  // Writes behind all that was written; returns where. Any number of threads at a time.
  Result<std::uint64_t> append(std::span<const std::byte> bytes);

  // Fills the parts, one after the other, from there on; changes the list. Any number of threads.
  [[nodiscard]] Status read(std::uint64_t offset, std::span<iovec> parts) const;

 private:
  explicit TemporaryFile(int descriptor, std::string folder)
      : descriptor_(descriptor), folder_(std::move(folder)) {}

  int descriptor_;
  std::string folder_;
  std::atomic<std::uint64_t> size_ = 0;
};

}  // namespace beespace::out_of_core
