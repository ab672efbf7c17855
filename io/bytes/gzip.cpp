#include "io/bytes/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

namespace beespace::io {
namespace {

constexpr int kGzipWindow = 15 + 16;  // the largest window; a gzip header and no other
constexpr std::size_t kLeastRoom = std::size_t{1} << 16;
constexpr std::size_t kLargestRatio = 1032;  // deflate cannot do better

class Inflater {
 public:
  Inflater() {
    if (inflateInit2(&stream_, kGzipWindow) != Z_OK) throw std::bad_alloc();
  }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }
  z_stream& stream() { return stream_; }

 private:
  z_stream stream_ = {};
};

uInt at_most(std::size_t size) {
  return static_cast<uInt>(std::min<std::size_t>(size, std::numeric_limits<uInt>::max()));
}

// The last four bytes hold the unpacked size (of the last member, modulo 2^32): a hint only.
std::size_t likely_size(std::string_view compressed) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4 && i < compressed.size(); ++i) {
    size = size * 256 + static_cast<unsigned char>(compressed[compressed.size() - 1 - i]);
  }
  return std::min(size, compressed.size() * kLargestRatio);
}

Error truncated(const std::string& source) {
  return {ErrorCode::kTruncated,
          "the gzip data ends too early; the file is incomplete, copy or download it again",
          {source}};
}

Error corrupt(const std::string& source, const char* why, std::size_t offset) {
  return {ErrorCode::kCorrupt,
          std::string("the gzip data is damaged near byte ") + std::to_string(offset) + " (" +
              (why != nullptr ? why : "bad content") + "); copy or download the file again",
          {source}};
}

bool only_zeros(std::string_view bytes) {
  return bytes.find_first_not_of('\0') == std::string_view::npos;
}

}  // namespace

bool is_gzip(std::string_view bytes) {
  return bytes.size() >= 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b';
}

Result<Bytes> gunzip(std::string_view compressed, const std::string& source, Progress* progress) {
  Inflater inflater;
  z_stream& stream = inflater.stream();
  GrowingBytes unpacked;
  unpacked.make_room(std::max(likely_size(compressed) + 1, kLeastRoom));
  std::size_t taken = 0;
  while (true) {
    unpacked.make_room(kLeastRoom);
    const uInt offered = at_most(compressed.size() - taken);
    const uInt room = at_most(unpacked.free_size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data() + taken));
    stream.avail_in = offered;
    stream.next_out = reinterpret_cast<Bytef*>(unpacked.free_begin());
    stream.avail_out = room;
    const int outcome = inflate(&stream, Z_NO_FLUSH);
    taken += offered - stream.avail_in;
    unpacked.add(room - stream.avail_out);
    if (progress != nullptr) progress->done = taken;
    if (outcome == Z_MEM_ERROR) throw std::bad_alloc();
    if (outcome == Z_STREAM_END) {
      const std::string_view rest = compressed.substr(taken);
      if (only_zeros(rest)) return unpacked.release();  // tapes and disks pad with zeros
      if (!is_gzip(rest) && rest != "\x1f") return corrupt(source, "other data follows", taken);
      if (inflateReset(&stream) != Z_OK) throw std::bad_alloc();
    } else if (outcome != Z_OK && outcome != Z_BUF_ERROR) {
      return corrupt(source, stream.msg, taken);
    } else if (taken == compressed.size() && stream.avail_out != 0) {
      return truncated(source);
    }
  }
}

Result<Bytes> unpacked(Bytes bytes, const std::string& source) {
  if (!is_gzip(bytes.view)) return bytes;
  auto inside = gunzip(bytes.view, source, nullptr);
  if (inside && is_gzip(inside->view)) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this is compressed twice; unpack it once first: gzip -dc",
                 {source}};
  }
  return inside;
}

}  // namespace beespace::io
