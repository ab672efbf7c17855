// Bytes that go out gzip-compressed, piece after piece.
//
// The compressed bytes hold no time and no name, so that they depend on the content only.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

namespace beespace::io {

class GzipStream {
 public:
  using Sink = std::function<void(std::string_view)>;

  GzipStream();
  ~GzipStream();
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;

  // What is ready goes to the sink.
  void write(std::string_view bytes, const Sink& sink);
  // The rest of it; nothing may be written afterwards.
  void finish(const Sink& sink);

 private:
  struct Deflate;
  void deflate_some(std::string_view bytes, int flush, const Sink& sink);

  std::unique_ptr<Deflate> deflate_;
};

}  // namespace beespace::io
