#include "io/text_check.hpp"

#include <array>
#include <cstddef>
#include <string>

namespace beespace::io {
namespace {

constexpr std::size_t kLookedAt = 4096;

struct Signature {
  std::string_view bytes;
  std::string_view what;
};

// Longer ones before those they begin with.
constexpr std::array<Signature, 20> kSignatures = {{
    {std::string_view("\xFF\xFE\0\0", 4), "UTF-32 text; save it as UTF-8"},
    {std::string_view("\0\0\xFE\xFF", 4), "UTF-32 text; save it as UTF-8"},
    {"\xFF\xFE", "UTF-16 text; save it as UTF-8"},
    {"\xFE\xFF", "UTF-16 text; save it as UTF-8"},
    {"PK\x03\x04", "a zip archive (a spreadsheet or a drone show?); unpack or export it as CSV"},
    {"\x28\xB5\x2F\xFD", "zstd-compressed data; unpack it first"},
    {"BZh", "bzip2-compressed data; unpack it first"},
    {"\xFD"
     "7zXZ",
     "xz-compressed data; unpack it first"},
    {"\x93NUMPY", "a .npy array, not text"},
    {"%PDF", "a PDF document; export the table as CSV"},
    {"\x89PNG", "a picture"},
    {"\xFF\xD8\xFF", "a picture"},
    {"\x89HDF", "an HDF5 file; export the table as CSV"},
    {"SQLite format 3", "an SQLite database; export the table as CSV"},
    {"\x7F"
     "ELF",
     "a program"},
    {"PAR1", "a Parquet file; export the table as CSV"},
    {"<?xml", "XML; export the table as CSV"},
    {"<kml", "KML, which is not read; export the table as CSV"},
    {"{", "JSON, which is not read; export the positions as CSV"},
    {"[", "JSON, which is not read; export the positions as CSV"},
}};

Error unsupported(const std::string& found) {
  return {ErrorCode::kUnsupportedFormat, "this is " + found, {}};
}

std::string hex(unsigned char byte) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  return {'0', 'x', kDigits[byte / 16u], kDigits[byte % 16u]};
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view bytes) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  return bytes.substr(0, kMark.size()) == kMark ? bytes.substr(kMark.size()) : bytes;
}

std::optional<Error> text_problem(std::string_view bytes, std::string_view or_raw) {
  const std::string_view text = without_byte_order_mark(bytes);
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  const std::string_view front = text.substr(start == std::string_view::npos ? 0 : start);
  for (const Signature& signature : kSignatures) {
    if (front.substr(0, signature.bytes.size()) == signature.bytes) {
      return unsupported(std::string(signature.what));
    }
  }
  for (std::size_t i = 0; i < bytes.size() && i < kLookedAt; ++i) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte == 0) {
      return unsupported("no text: byte " + std::to_string(i) +
                         " is NUL; save it as text in UTF-8" + std::string(or_raw));
    }
    const bool control = byte < 0x20 && (byte < '\t' || byte > '\r');
    if (control || byte == 0x7F) {
      return unsupported("no text: byte " + std::to_string(i) + " is " + hex(byte) +
                         "; save it as text in UTF-8" + std::string(or_raw));
    }
  }
  return std::nullopt;
}

}  // namespace beespace::io
