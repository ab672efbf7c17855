// Zstandard-compressed input, unpacked piece after piece: where libzstd was there when beespace was
// built.
#pragma once

#include "io/bytes/byte_source.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace beespace::io {

// By the first two bytes, whatever the file is called: no text in UTF-8 begins so.
bool is_zstd(std::string_view bytes);

// The same as Unpacking, which see, for one or more frames one after the other.
class ZstdUnpacking {
 public:
  explicit ZstdUnpacking(std::string source);
  ZstdUnpacking(const ZstdUnpacking&) = delete;
  ZstdUnpacking& operator=(const ZstdUnpacking&) = delete;
  ~ZstdUnpacking();

  // Errors: kTruncated, kCorrupt; kUnsupportedFormat without libzstd.
  Status unpack(std::string_view& packed, bool last, GrowingBytes& into);
  [[nodiscard]] std::uint64_t taken() const { return taken_; }
  [[nodiscard]] bool may_end() const { return between_frames_; }

 private:
  struct Stream;

  std::string source_;
  std::unique_ptr<Stream> stream_;
  std::uint64_t taken_ = 0;
  bool between_frames_ = false;
};

}  // namespace beespace::io
