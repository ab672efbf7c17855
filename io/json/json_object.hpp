// One JSON object, written member by member.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {

class JsonObject {
 public:
  void add_text(std::string_view name, std::string_view value);
  // null where it is not finite.
  void add_number(std::string_view name, double value);
  void add_count(std::string_view name, std::uint64_t value);
  void add_flag(std::string_view name, bool value);
  // What is JSON already.
  void add_json(std::string_view name, std::string_view value);

  [[nodiscard]] std::string text() const { return text_ + '}'; }

 private:
  void begin(std::string_view name);

  std::string text_ = "{";
};

// Like a member of that type, by itself.
std::string json_number(double value);

}  // namespace beespace::io
