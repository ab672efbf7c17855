#include "io/bytes/durable_file.hpp"

#include "io/bytes/descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace beespace::io {
namespace {

Error problem(ErrorCode code, const char* what, const std::string& path) {
  return {code, std::string(what) + ": " + std::strerror(errno), {.source = path}};
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

// The new name of a file is on the disk when its folder is.
bool sync_folder_of(const std::string& path) {
  const std::size_t end = path.rfind('/');
  const std::string folder = end == std::string::npos ? "." : path.substr(0, end + 1);
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  return opened.is_open() && ::fsync(opened.number()) == 0;
}

}  // namespace

std::string file_behind(const std::string& path) {
  // As many as systems follow. A link may lead to a file that is not there yet.
  constexpr int kMostLinks = 40;
  std::filesystem::path found = path;
  std::error_code problem;
  for (int links = 0; links < kMostLinks && std::filesystem::is_symlink(found, problem); ++links) {
    const std::filesystem::path target = std::filesystem::read_symlink(found, problem);
    if (problem) break;
    found = found.parent_path() / target;
  }
  return found.string();
}

Status write_durably(const std::string& path, std::string_view text) {
  const std::string target = file_behind(path);
  const std::string beside = target + ".new";
  constexpr mode_t kMode = 0644;
  {
    const Descriptor file(::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode));
    if (!file.is_open() || !write_all(file.number(), text) || ::fsync(file.number()) != 0) {
      Error error = problem(ErrorCode::kWriteFailed, "cannot write this file durably", path);
      if (file.is_open()) ::unlink(beside.c_str());
      return error;
    }
  }
  if (std::rename(beside.c_str(), target.c_str()) == 0 && sync_folder_of(target)) {
    return std::monostate{};
  }
  return problem(ErrorCode::kWriteFailed, "cannot write this file durably", path);
}

Result<std::optional<std::string>> read_small_file(const std::string& path, std::size_t most) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open() && errno == ENOENT) return std::optional<std::string>();
  if (!file.is_open()) return problem(ErrorCode::kReadFailed, "cannot open this file", path);
  std::string text;
  std::array<char, 4096> block;
  for (;;) {
    const ssize_t count = ::read(file.number(), block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return problem(ErrorCode::kReadFailed, "cannot read this file", path);
    if (count == 0) return std::optional<std::string>(std::move(text));
    text.append(block.data(), static_cast<std::size_t>(count));
    if (text.size() > most) {
      return Error{ErrorCode::kMalformedRecord,
                   "this file is too large to be what was stored; name another one",
                   {.source = path}};
    }
  }
}

}  // namespace beespace::io
