// The definitions of a PX4 log: what the messages of a topic hold, and where in them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace beespace::io {

enum class UlogType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat,
  kDouble,
  kNested,  // another definition
};

struct UlogField {
  std::string name;
  UlogType type = UlogType::kUint8;
  std::size_t offset = 0;  // in the message, behind the number of its topic
  bool array = false;
};

// A topic's message: all fields follow each other without gaps.
struct UlogLayout {
  std::vector<UlogField> fields;
  std::size_t size = 0;
  std::size_t least_size = 0;  // without the padding at the end, which is not logged

  // A number, not an array; null where there is none.
  [[nodiscard]] const UlogField* number(std::string_view name) const;
};

// Of a field of this layout's messages; `message` is at least as long as the layout says.
double ulog_number(std::string_view message, const UlogField& field);
// The same of times, which a double may not hold; nothing of other types than whole numbers.
std::optional<std::uint64_t> ulog_unsigned(std::string_view message, const UlogField& field);

class UlogDefinitions {
 public:
  // "name:type field;type[3] field;": what an F message holds. One that cannot be read is none.
  void add(std::string_view definition);

  // Nothing where that name, or what it refers to, is not defined or cannot be.
  [[nodiscard]] std::optional<UlogLayout> layout(std::string_view name) const;

 private:
  struct Part {
    std::string type;
    std::string name;
    std::size_t count = 1;
    bool array = false;
  };
  static std::optional<std::vector<Part>> parts_of(std::string_view fields);
  [[nodiscard]] std::optional<UlogLayout> layout(const std::string& name, int depth,
                                                 std::size_t& budget) const;

  std::unordered_map<std::string, std::vector<Part>> formats_;
};

}  // namespace beespace::io
