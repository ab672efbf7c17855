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
  // Room for so many bytes is taken at once, where the file system can. Errors: kWriteFailed, also
  // where the folder has less room.
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
  void take_room(std::uint64_t end);

  int descriptor_;
  std::string folder_;
  std::atomic<std::uint64_t> size_ = 0;
  std::atomic<std::uint64_t> room_ = 0;  // bytes that the disk has for it
};

}  // namespace beespace::out_of_core
