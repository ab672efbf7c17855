#include "io/bytes/zip_archive.hpp"

#include "io/problems/excerpt.hpp"

#include <zip.h>

#include <algorithm>
#include <new>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kStep = std::size_t{1} << 18;

class ZipError {
 public:
  ZipError() { zip_error_init(&error_); }
  ZipError(const ZipError&) = delete;
  ZipError& operator=(const ZipError&) = delete;
  ~ZipError() { zip_error_fini(&error_); }
  zip_error_t* get() { return &error_; }
  [[nodiscard]] int code() const { return zip_error_code_zip(&error_); }
  [[nodiscard]] std::string text() { return zip_error_strerror(&error_); }

 private:
  zip_error_t error_ = {};
};

struct MemberCloser {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

// What went wrong with libzip's code for it.
Error zip_problem(int code, const std::string& text, std::string place) {
  switch (code) {
    case ZIP_ER_MEMORY:
      throw std::bad_alloc();
    case ZIP_ER_NOZIP:
    case ZIP_ER_EOF:
      return {ErrorCode::kTruncated,
              "the zip archive ends too early; the file is incomplete, copy or download it again",
              {std::move(place)}};
    case ZIP_ER_NOPASSWD:
    case ZIP_ER_WRONGPASSWD:
    case ZIP_ER_ENCRNOTSUPP:
      return {ErrorCode::kUnsupportedFormat,
              "this part of the zip archive is encrypted; unpack it and pack it again without a "
              "password",
              {std::move(place)}};
    case ZIP_ER_COMPNOTSUPP:
      return {ErrorCode::kUnsupportedFormat,
              "this part of the zip archive is packed in a way that is not read; pack it again "
              "with zip (deflate)",
              {std::move(place)}};
    default:
      return {ErrorCode::kCorrupt,
              "the zip archive is damaged (" + text + "); copy or download the file again",
              {std::move(place)}};
  }
}

Error too_large(std::size_t limit, std::string place) {
  return {ErrorCode::kUnsupportedFormat,
          "this unpacks to more than " + std::to_string(limit) +
              " bytes; if that is right, unpack it first",
          {std::move(place)}};
}

}  // namespace

bool is_zip(std::string_view bytes) {
  // The second one begins an archive without files.
  const std::string_view first = bytes.substr(0, 4);
  return first == "PK\x03\x04" || first == "PK\x05\x06";
}

void ZipArchive::Closer::operator()(zip* archive) const {
  zip_discard(archive);
}

ZipArchive::ZipArchive(Bytes bytes, std::string source, const ZipLimits& limits, zip* archive)
    : bytes_(std::move(bytes)), source_(std::move(source)), limits_(limits), archive_(archive) {
}

Result<ZipArchive> ZipArchive::open(Bytes bytes, std::string source, const ZipLimits& limits) {
  ZipError error;
  zip_source_t* const memory =
      zip_source_buffer_create(bytes.view.data(), bytes.view.size(), 0, error.get());
  if (memory == nullptr) throw std::bad_alloc();
  zip_t* const opened = zip_open_from_source(memory, ZIP_RDONLY, error.get());
  if (opened == nullptr) {
    zip_source_free(memory);
    return zip_problem(error.code(), error.text(), std::move(source));
  }
  ZipArchive archive(std::move(bytes), std::move(source), limits, opened);
  const zip_int64_t count = zip_get_num_entries(opened, 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* const name = zip_get_name(opened, static_cast<zip_uint64_t>(i), 0);
    if (name == nullptr) continue;
    std::string member = name;
    if (!member.empty() && member.back() != '/') archive.names_.push_back(std::move(member));
  }
  return archive;
}

bool ZipArchive::contains(const std::string& member) const {
  return zip_name_locate(archive_.get(), member.c_str(), 0) >= 0;
}

std::string ZipArchive::place_of(const std::string& member) const {
  return source_ + "!" + member;
}

Result<Bytes> ZipArchive::read(const std::string& member) {
  const std::string place = place_of(member);
  const zip_int64_t index = zip_name_locate(archive_.get(), member.c_str(), 0);
  if (index < 0) {
    return Error{ErrorCode::kCannotOpen,
                 "there is no file " + excerpt(member) + " in this archive; it is incomplete",
                 {source_}};
  }
  const std::unique_ptr<zip_file_t, MemberCloser> file(
      zip_fopen_index(archive_.get(), static_cast<zip_uint64_t>(index), 0));
  if (file == nullptr) {
    zip_error_t* const error = zip_get_error(archive_.get());
    return zip_problem(zip_error_code_zip(error), zip_error_strerror(error), place);
  }
  GrowingBytes content;
  while (true) {
    content.make_room(kStep);
    const zip_int64_t count = zip_fread(file.get(), content.free_begin(), content.free_size());
    if (count < 0) {
      zip_error_t* const error = zip_file_get_error(file.get());
      return zip_problem(zip_error_code_zip(error), zip_error_strerror(error), place);
    }
    if (count == 0) return content.release();
    content.add(static_cast<std::size_t>(count));
    unpacked_ += static_cast<std::size_t>(count);
    if (content.size() > limits_.one_file) return too_large(limits_.one_file, place);
    if (unpacked_ > limits_.together) return too_large(limits_.together, source_);
  }
}

}  // namespace beespace::io
