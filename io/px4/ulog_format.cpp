#include "io/px4/ulog_format.hpp"

#include "io/bytes/characters.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <utility>

namespace beespace::io {
namespace {

// Messages count their bytes in 16 bits.
constexpr std::size_t kMostBytes = 65'535;
constexpr int kDeepest = 16;
// Fields, with those of nested definitions, that are looked at for one layout: broken definitions
// may refer to each other without an end.
constexpr std::size_t kMostFields = 100'000;

struct Named {
  std::string_view name;
  UlogType type;
  std::size_t size;
};

constexpr std::array<Named, 12> kNumbers = {{
    {"int8_t", UlogType::kInt8, 1},
    {"uint8_t", UlogType::kUint8, 1},
    {"int16_t", UlogType::kInt16, 2},
    {"uint16_t", UlogType::kUint16, 2},
    {"int32_t", UlogType::kInt32, 4},
    {"uint32_t", UlogType::kUint32, 4},
    {"int64_t", UlogType::kInt64, 8},
    {"uint64_t", UlogType::kUint64, 8},
    {"float", UlogType::kFloat, 4},
    {"double", UlogType::kDouble, 8},
    {"bool", UlogType::kUint8, 1},
    {"char", UlogType::kUint8, 1},
}};

const Named* type_of(std::string_view name) {
  for (const Named& type : kNumbers) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

std::uint64_t bits_at(std::string_view message, std::size_t at, std::size_t bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(message[at + i])} << 8 * i;
  }
  return bits;
}

// "type[3]" -> "type", 3.
bool split_array(std::string_view& type, std::size_t& count) {
  const std::size_t open = type.find('[');
  if (open == std::string_view::npos) return true;
  if (type.back() != ']') return false;
  const char* const begin = type.data() + open + 1;
  const char* const end = type.data() + type.size() - 1;
  const auto read = std::from_chars(begin, end, count);
  type = type.substr(0, open);
  return read.ec == std::errc() && read.ptr == end && count > 0 && count <= kMostBytes;
}

}  // namespace

const UlogField* UlogLayout::number(std::string_view name) const {
  for (const UlogField& field : fields) {
    if (field.name == name && !field.array && field.type != UlogType::kNested) return &field;
  }
  return nullptr;
}

double ulog_number(std::string_view message, const UlogField& field) {
  const auto bits = [&](std::size_t bytes) { return bits_at(message, field.offset, bytes); };
  switch (field.type) {
    case UlogType::kInt8:
      return static_cast<std::int8_t>(bits(1));
    case UlogType::kUint8:
      return static_cast<double>(bits(1));
    case UlogType::kInt16:
      return static_cast<std::int16_t>(bits(2));
    case UlogType::kUint16:
      return static_cast<double>(bits(2));
    case UlogType::kInt32:
      return static_cast<std::int32_t>(bits(4));
    case UlogType::kUint32:
      return static_cast<double>(bits(4));
    case UlogType::kInt64:
      return static_cast<double>(static_cast<std::int64_t>(bits(8)));
    case UlogType::kUint64:
      return static_cast<double>(bits(8));
    case UlogType::kFloat:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits(4))));
    case UlogType::kDouble:
      return std::bit_cast<double>(bits(8));
    case UlogType::kNested:
      break;
  }
  return 0.0;
}

std::optional<std::uint64_t> ulog_unsigned(std::string_view message, const UlogField& field) {
  switch (field.type) {
    case UlogType::kUint64:
      return bits_at(message, field.offset, 8);
    case UlogType::kUint32:
      return bits_at(message, field.offset, 4);
    default:
      return std::nullopt;
  }
}

std::optional<std::vector<UlogDefinitions::Part>> UlogDefinitions::parts_of(
    std::string_view fields) {
  std::vector<Part> parts;
  while (!fields.empty()) {
    const std::size_t end = std::min(fields.find(';'), fields.size());
    const std::string_view one = without_padding(fields.substr(0, end));
    fields.remove_prefix(std::min(end + 1, fields.size()));
    if (one.empty()) continue;
    const std::size_t blank = one.rfind(' ');
    if (blank == std::string_view::npos) return std::nullopt;
    std::string_view type = without_padding(one.substr(0, blank));
    Part part;
    part.array = type.find('[') != std::string_view::npos;
    if (type.empty() || !split_array(type, part.count)) return std::nullopt;
    part.type = type;
    part.name = one.substr(blank + 1);
    parts.push_back(std::move(part));
  }
  return parts;
}

void UlogDefinitions::add(std::string_view definition) {
  const std::size_t colon = definition.find(':');
  if (colon == std::string_view::npos) return;
  auto parts = parts_of(definition.substr(colon + 1));
  if (parts) formats_.emplace(definition.substr(0, colon), *std::move(parts));
}

std::optional<UlogLayout> UlogDefinitions::layout(std::string_view name) const {
  std::size_t budget = kMostFields;
  return layout(std::string(name), 0, budget);
}

std::optional<UlogLayout> UlogDefinitions::layout(const std::string& name, int depth,
                                                  std::size_t& budget) const {
  const auto found = formats_.find(name);
  if (found == formats_.end() || depth > kDeepest) return std::nullopt;
  UlogLayout layout;
  for (const Part& part : found->second) {
    if (budget == 0) return std::nullopt;
    --budget;
    std::size_t size = 0;
    UlogField field{part.name, UlogType::kNested, layout.size, part.array};
    if (const Named* const type = type_of(part.type)) {
      field.type = type->type;
      size = type->size;
    } else {
      const auto nested = this->layout(part.type, depth + 1, budget);
      if (!nested) return std::nullopt;
      size = nested->size;
    }
    layout.size += size * part.count;
    if (layout.size > kMostBytes) return std::nullopt;
    if (!part.name.starts_with("_padding")) layout.least_size = layout.size;
    layout.fields.push_back(std::move(field));
  }
  return layout;
}

}  // namespace beespace::io
