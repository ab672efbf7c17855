// Many short texts in one piece, each with a zero byte at its end: names as C and NumPy read them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::c_io {

class Texts {
 public:
  // A zero byte in a text would end it: it becomes a blank.
  void add(std::string_view text) {
    for (const char c : text) bytes_.push_back(c == '\0' ? ' ' : c);
    bytes_.push_back('\0');
    offsets_.push_back(static_cast<std::int64_t>(bytes_.size()));
  }

  [[nodiscard]] std::size_t size() const { return offsets_.size() - 1; }
  [[nodiscard]] const char* bytes() const { return bytes_.c_str(); }
  [[nodiscard]] const std::int64_t* offsets() const { return offsets_.data(); }
  [[nodiscard]] const char* find(std::int64_t index) const {
    if (index < 0 || static_cast<std::size_t>(index) >= size()) return nullptr;
    return bytes_.data() + offsets_[static_cast<std::size_t>(index)];
  }

 private:
  std::string bytes_;
  std::vector<std::int64_t> offsets_ = {0};
};

}  // namespace beespace::c_io
