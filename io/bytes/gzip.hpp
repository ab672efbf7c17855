// Compressed input, unpacked in memory: all at once, or piece after piece. Of gzip one or more
// members one after the other, as written by gzip, pigz, bgzip or `cat a.gz b.gz`; of zstd likewise
// (zstd.hpp).
#pragma once

#include "io/bytes/byte_source.hpp"
#include "io/bytes/zstd.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace beespace::io {

// By the first two bytes, whatever the file is called.
bool is_gzip(std::string_view bytes);
// Whether it is compressed by gzip or zstd.
bool is_packed(std::string_view bytes);

// Unpacks what comes in pieces.
class Unpacking {
 public:
  explicit Unpacking(std::string source);
  Unpacking(Unpacking&&) noexcept;
  Unpacking& operator=(Unpacking&&) noexcept;
  Unpacking(const Unpacking&) = delete;
  Unpacking& operator=(const Unpacking&) = delete;
  ~Unpacking();

  // Takes bytes off the front of `packed` and fills the free room of `into`, until that is full or
  // no more can be taken. What is left of `packed` must come again, with what follows it; `last`:
  // nothing does. Errors: as gunzip().
  Status unpack(std::string_view& packed, bool last, GrowingBytes& into);

  // How many packed bytes were taken.
  [[nodiscard]] std::uint64_t taken() const { return zstd_ ? zstd_->taken() : taken_; }
  // Whether a member has ended, so that the data may end here.
  [[nodiscard]] bool may_end() const { return zstd_ ? zstd_->may_end() : between_members_; }

 private:
  class Inflater;

  // Whether a member goes on; false where none follows, or more must be known.
  Result<bool> begin_member(std::string_view& packed, bool last);

  std::string source_;
  std::unique_ptr<Inflater> inflater_;
  std::unique_ptr<ZstdUnpacking> zstd_;  // instead, as the first bytes say
  bool begun_ = false;
  std::uint64_t taken_ = 0;
  bool between_members_ = false;
  bool in_padding_ = false;
};

// Errors: kTruncated when the end is missing, kCorrupt when the content is damaged; those of zstd.
Result<Bytes> gunzip(std::string_view compressed, const std::string& source, Progress* progress);

// kUnsupportedFormat: what is unpacked is compressed again.
Error compressed_twice(const std::string& source);

// The bytes themselves, or where they are compressed what is in them. Errors: those of gunzip(),
// and kUnsupportedFormat for what is compressed twice; with `source` as place.
Result<Bytes> unpacked(Bytes bytes, const std::string& source);

}  // namespace beespace::io
