// The files in a zip archive, unpacked in memory one at a time. Their checksums are compared.
//
// What unpacks to more than its limits is refused: a zip of some kilobytes can hold files of any
// size.
#pragma once

#include "io/bytes/byte_source.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct zip;

namespace beespace::io {

// By the first bytes, whatever the file is called.
bool is_zip(std::string_view bytes);

// In bytes.
struct ZipLimits {
  std::size_t one_file = std::size_t{256} << 20;
  std::size_t together = std::size_t{1} << 30;
};

class ZipArchive {
 public:
  // Errors: kTruncated when its directory is not there, kCorrupt; with `source` as the place.
  static Result<ZipArchive> open(Bytes bytes, std::string source, const ZipLimits& limits = {});

  // Of the files, not the folders, in the order of the archive.
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool contains(const std::string& member) const;
  // "show.skyc!show.json"
  [[nodiscard]] std::string place_of(const std::string& member) const;

  // One file of names(). Errors: kCannotOpen when there is no such file,
  // kTruncated, kCorrupt, kUnsupportedFormat when it is encrypted, packed in an unknown way, or too
  // large; with the member as the place.
  Result<Bytes> read(const std::string& member);

 private:
  struct Closer {
    void operator()(zip* archive) const;
  };

  ZipArchive(Bytes bytes, std::string source, const ZipLimits& limits, zip* archive);

  Bytes bytes_;  // libzip reads from them
  std::string source_;
  ZipLimits limits_;
  std::unique_ptr<zip, Closer> archive_;
  std::vector<std::string> names_;
  std::size_t unpacked_ = 0;
};

}  // namespace beespace::io
