#include "io/bytes/byte_stream.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;

}  // namespace

Result<ByteStream> ByteStream::open(const std::string& path) {
  auto file = InputFile::open(path);
  if (!file) return std::move(file).error();
  ByteStream stream(*std::move(file));
  stream.buffer_.resize(kBufferBytes);
  // Two bytes tell whether they are compressed; a pipe may give them one at a time.
  while (stream.waiting_.size() < 2 && !stream.ended_) {
    if (auto status = stream.fill(); !status) return std::move(status).error();
  }
  if (is_packed(stream.waiting_)) {
    stream.unpacking_.emplace(source_name(path));
    stream.packed_by_ = is_zstd(stream.waiting_) ? "zstd" : "gzip";
  }
  return stream;
}

Status ByteStream::fill() {
  if (!waiting_.empty()) std::memmove(buffer_.data(), waiting_.data(), waiting_.size());
  const auto count = file_.read(buffer_.data() + waiting_.size(), buffer_.size() - waiting_.size());
  if (!count) return count.error();
  waiting_ = {buffer_.data(), waiting_.size() + *count};
  taken_ += *count;
  ended_ = *count == 0;
  return ended_ ? file_.check_unchanged() : Status(std::monostate{});
}

Status ByteStream::read(GrowingBytes& into) {
  while (into.free_size() > 0) {
    if (unpacking_) {
      if (auto status = unpacking_->unpack(waiting_, ended_, into); !status) return status;
      if (into.free_size() == 0 || ended_) break;
      if (auto status = fill(); !status) return status;
      continue;
    }
    if (!waiting_.empty()) {
      const std::size_t count = std::min(waiting_.size(), into.free_size());
      std::copy_n(waiting_.data(), count, into.free_begin());
      into.add(count);
      waiting_.remove_prefix(count);
      continue;
    }
    if (ended_) break;
    const auto count = file_.read(into.free_begin(), into.free_size());
    if (!count) return count.error();
    into.add(*count);
    taken_ += *count;
    ended_ = *count == 0;
    if (ended_) return file_.check_unchanged();
  }
  return std::monostate{};
}

}  // namespace beespace::io
