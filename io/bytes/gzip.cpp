#include "io/bytes/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <utility>

namespace beespace::io {
namespace {

constexpr int kGzipWindow = 15 + 16;  // the largest window; a gzip header and no other
constexpr std::size_t kLeastRoom = std::size_t{1} << 16;
constexpr std::size_t kLargestRatio = 1032;  // deflate cannot do better

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

Error corrupt(const std::string& source, const char* why, std::uint64_t offset) {
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

bool is_packed(std::string_view bytes) {
  return is_gzip(bytes) || is_zstd(bytes);
}

class Unpacking::Inflater {
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

Unpacking::Unpacking(std::string source)
    : source_(std::move(source)), inflater_(std::make_unique<Inflater>()) {
}
Unpacking::Unpacking(Unpacking&&) noexcept = default;
Unpacking& Unpacking::operator=(Unpacking&&) noexcept = default;
Unpacking::~Unpacking() = default;

Result<bool> Unpacking::begin_member(std::string_view& packed, bool last) {
  if (!between_members_) return true;
  if (packed.empty()) return false;
  // Tapes and disks pad with zeros.
  if (in_padding_ || packed.front() == '\0') {
    if (!only_zeros(packed)) return corrupt(source_, "other data follows", taken_);
    in_padding_ = true;
    taken_ += packed.size();
    packed = {};
    return false;
  }
  if (packed.size() == 1 && !last) return false;
  if (!is_gzip(packed) && packed != "\x1f") {
    return corrupt(source_, "other data follows", taken_);
  }
  if (inflateReset(&inflater_->stream()) != Z_OK) throw std::bad_alloc();
  between_members_ = false;
  return true;
}

Status Unpacking::unpack(std::string_view& packed, bool last, GrowingBytes& into) {
  if (!std::exchange(begun_, true) && is_zstd(packed)) {
    zstd_ = std::make_unique<ZstdUnpacking>(source_);
  }
  if (zstd_) return zstd_->unpack(packed, last, into);
  z_stream& stream = inflater_->stream();
  while (into.free_size() > 0) {
    const auto goes_on = begin_member(packed, last);
    if (!goes_on) return goes_on.error();
    if (!*goes_on) return std::monostate{};
    const uInt offered = at_most(packed.size());
    const uInt room = at_most(into.free_size());
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = offered;
    stream.next_out = reinterpret_cast<Bytef*>(into.free_begin());
    stream.avail_out = room;
    const int outcome = inflate(&stream, Z_NO_FLUSH);
    packed.remove_prefix(offered - stream.avail_in);
    taken_ += offered - stream.avail_in;
    into.add(room - stream.avail_out);
    if (outcome == Z_MEM_ERROR) throw std::bad_alloc();
    if (outcome == Z_STREAM_END) {
      between_members_ = true;
    } else if (outcome != Z_OK && outcome != Z_BUF_ERROR) {
      return corrupt(source_, stream.msg, taken_);
    } else if (packed.empty() && stream.avail_out != 0) {
      if (last) return truncated(source_);
      return std::monostate{};
    }
  }
  return std::monostate{};
}

Result<Bytes> gunzip(std::string_view compressed, const std::string& source, Progress* progress) {
  Unpacking unpacking(source);
  GrowingBytes unpacked;
  const std::size_t likely = is_gzip(compressed) ? likely_size(compressed) : 3 * compressed.size();
  unpacked.make_room(std::max(likely + 1, kLeastRoom));
  while (!compressed.empty() || !unpacking.may_end()) {
    unpacked.make_room(kLeastRoom);
    if (auto status = unpacking.unpack(compressed, true, unpacked); !status) return status.error();
    if (progress != nullptr) progress->done = unpacking.taken();
  }
  return unpacked.release();
}

Error compressed_twice(const std::string& source) {
  return {ErrorCode::kUnsupportedFormat,
          "this is compressed twice; unpack it once first: gzip -dc, or zstd -dc",
          {source}};
}

Result<Bytes> unpacked(Bytes bytes, const std::string& source) {
  if (!is_packed(bytes.view)) return bytes;
  auto inside = gunzip(bytes.view, source, nullptr);
  if (inside && is_packed(inside->view)) return compressed_twice(source);
  return inside;
}

}  // namespace beespace::io
