#include "io/bytes/gzip_stream.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>

namespace beespace::io {

struct GzipStream::Deflate {
  z_stream stream{};
  std::array<char, 1u << 16u> room;
};

GzipStream::GzipStream() : deflate_(std::make_unique<Deflate>()) {
  constexpr int kGzipHeader = 16;
  constexpr int kLevel = 3;  // digits hardly compress; higher levels only take longer
  constexpr int kMemoryLevel = 8;
  const int status = deflateInit2(&deflate_->stream, kLevel, Z_DEFLATED, MAX_WBITS + kGzipHeader,
                                  kMemoryLevel, Z_DEFAULT_STRATEGY);
  if (status != Z_OK) throw std::bad_alloc();  // the only way it can fail with these arguments
}

GzipStream::~GzipStream() {
  deflateEnd(&deflate_->stream);
}

void GzipStream::write(std::string_view bytes, const Sink& sink) {
  constexpr std::size_t kMost = std::size_t{1} << 30;  // zlib counts in 32 bits
  while (!bytes.empty()) {
    deflate_some(bytes.substr(0, kMost), Z_NO_FLUSH, sink);
    bytes.remove_prefix(std::min(kMost, bytes.size()));
  }
}

void GzipStream::finish(const Sink& sink) {
  deflate_some({}, Z_FINISH, sink);
}

void GzipStream::deflate_some(std::string_view bytes, int flush, const Sink& sink) {
  z_stream& stream = deflate_->stream;
  auto& room = deflate_->room;
  // zlib does not write to its input, but its type does not say so.
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  do {
    stream.next_out = reinterpret_cast<Bytef*>(room.data());
    stream.avail_out = static_cast<uInt>(room.size());
    deflate(&stream, flush);
    sink(std::string_view(room.data(), room.size() - stream.avail_out));
  } while (stream.avail_out == 0);
}

}  // namespace beespace::io
