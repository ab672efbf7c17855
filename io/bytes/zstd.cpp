#include "io/bytes/zstd.hpp"

#include <new>
#include <utility>

#if defined(BEESPACE_HAS_ZSTD)
#include <zstd.h>
#endif

namespace beespace::io {

bool is_zstd(std::string_view bytes) {
  return bytes.size() >= 2 && bytes[0] == '\x28' && bytes[1] == '\xB5';
}

#if defined(BEESPACE_HAS_ZSTD)

struct ZstdUnpacking::Stream {
  ZSTD_DStream* stream = ZSTD_createDStream();

  Stream() {
    if (stream == nullptr) throw std::bad_alloc();
  }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;
  ~Stream() { ZSTD_freeDStream(stream); }
};

ZstdUnpacking::ZstdUnpacking(std::string source)
    : source_(std::move(source)), stream_(std::make_unique<Stream>()) {
}

Status ZstdUnpacking::unpack(std::string_view& packed, bool last, GrowingBytes& into) {
  while (into.free_size() > 0 && !(packed.empty() && between_frames_)) {
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    ZSTD_outBuffer out{into.free_begin(), into.free_size(), 0};
    const std::size_t left = ZSTD_decompressStream(stream_->stream, &out, &in);
    if (ZSTD_isError(left) != 0) {
      return Error{ErrorCode::kCorrupt,
                   "the zstd data is damaged near byte " + std::to_string(taken_) + " (" +
                       ZSTD_getErrorName(left) + "); copy or download the file again",
                   {source_}};
    }
    packed.remove_prefix(in.pos);
    taken_ += in.pos;
    into.add(out.pos);
    between_frames_ = left == 0;
    // Nothing more comes out of what is there.
    if (!between_frames_ && packed.empty() && into.free_size() > 0) {
      if (!last) return std::monostate{};
      return Error{
          ErrorCode::kTruncated,
          "the zstd data ends too early; the file is incomplete, copy or download it again",
          {source_}};
    }
  }
  return std::monostate{};
}

#else

struct ZstdUnpacking::Stream {};

ZstdUnpacking::ZstdUnpacking(std::string source) : source_(std::move(source)) {
}

Status ZstdUnpacking::unpack(std::string_view& /*packed*/, bool /*last*/, GrowingBytes& /*into*/) {
  return Error{
      ErrorCode::kUnsupportedFormat,
      "this is zstd-compressed, which this beespace was built without; pipe it in: zstdcat "
      "FILE | beespace ..., or build it where libzstd-dev is installed",
      {source_}};
}

#endif

ZstdUnpacking::~ZstdUnpacking() = default;

}  // namespace beespace::io
