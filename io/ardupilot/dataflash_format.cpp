#include "io/ardupilot/dataflash_format.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kNameAt = 2;
constexpr std::size_t kLettersAt = 6;
constexpr std::size_t kLabelsAt = 22;
constexpr std::size_t kDefinitionSize = 86;

enum class Kind : unsigned char { kSigned, kUnsigned, kFloat, kDouble, kText, kArray };

struct Letter {
  char type;
  Kind kind;
  std::size_t size;
  double per_one;  // as many of the number as written are one of its unit
};

constexpr std::array<Letter, 20> kLetters = {{
    {'a', Kind::kArray, 64, 1},     {'b', Kind::kSigned, 1, 1},     {'B', Kind::kUnsigned, 1, 1},
    {'h', Kind::kSigned, 2, 1},     {'H', Kind::kUnsigned, 2, 1},   {'i', Kind::kSigned, 4, 1},
    {'I', Kind::kUnsigned, 4, 1},   {'f', Kind::kFloat, 4, 1},      {'d', Kind::kDouble, 8, 1},
    {'n', Kind::kText, 4, 1},       {'N', Kind::kText, 16, 1},      {'Z', Kind::kText, 64, 1},
    {'c', Kind::kSigned, 2, 100},   {'C', Kind::kUnsigned, 2, 100}, {'e', Kind::kSigned, 4, 100},
    {'E', Kind::kUnsigned, 4, 100}, {'L', Kind::kSigned, 4, 1e7},   {'M', Kind::kUnsigned, 1, 1},
    {'q', Kind::kSigned, 8, 1},     {'Q', Kind::kUnsigned, 8, 1},
}};
constexpr std::size_t kHalfFloat = 2;  // 'g', which nothing here is read from

const Letter* letter_of(char type) {
  const auto found = std::find_if(kLetters.begin(), kLetters.end(),
                                  [type](const Letter& letter) { return letter.type == type; });
  return found != kLetters.end() ? &*found : nullptr;
}

std::optional<std::size_t> size_of(char type) {
  if (type == 'g') return kHalfFloat;
  const Letter* const letter = letter_of(type);
  return letter != nullptr ? std::optional(letter->size) : std::nullopt;
}

// Up to the first zero byte.
std::string_view text_at(std::string_view bytes, std::size_t at, std::size_t size) {
  const std::string_view text = bytes.substr(at, size);
  return text.substr(0, std::min(text.find('\0'), text.size()));
}

std::uint64_t bits_of(std::string_view bytes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
  }
  return bits;
}

double signed_of(std::uint64_t bits, std::size_t size) {
  const std::size_t unused = 64 - 8 * size;
  return static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

const DataflashField* DataflashLayout::field(std::string_view label) const {
  const auto found = std::find_if(fields.begin(), fields.end(),
                                  [label](const auto& one) { return one.label == label; });
  return found != fields.end() ? &*found : nullptr;
}

std::optional<DataflashLayout> dataflash_layout(std::string_view definition) {
  if (definition.size() < kDefinitionSize) return std::nullopt;
  DataflashLayout layout;
  layout.size = static_cast<unsigned char>(definition[1]);
  if (layout.size <= kDataflashFront) return std::nullopt;
  layout.name = text_at(definition, kNameAt, kLettersAt - kNameAt);
  const std::string_view letters = text_at(definition, kLettersAt, kLabelsAt - kLettersAt);
  std::string_view labels = text_at(definition, kLabelsAt, kDefinitionSize - kLabelsAt);
  std::size_t offset = 0;
  for (const char type : letters) {
    const auto size = size_of(type);
    if (!size) {
      layout.fields.clear();
      return layout;
    }
    const std::size_t comma = std::min(labels.find(','), labels.size());
    layout.fields.push_back({std::string(labels.substr(0, comma)), type, offset});
    labels.remove_prefix(std::min(comma + 1, labels.size()));
    offset += *size;
  }
  if (offset + kDataflashFront != layout.size) layout.fields.clear();
  return layout;
}

std::optional<double> dataflash_number(std::string_view message, const DataflashField& field) {
  const Letter* const letter = letter_of(field.type);
  if (letter == nullptr || field.offset + letter->size > message.size()) return std::nullopt;
  if (letter->kind == Kind::kText || letter->kind == Kind::kArray) return std::nullopt;
  const std::uint64_t bits = bits_of(message.substr(field.offset, letter->size));
  switch (letter->kind) {
    case Kind::kSigned:
      return signed_of(bits, letter->size) / letter->per_one;
    case Kind::kFloat:
      return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    case Kind::kDouble:
      return std::bit_cast<double>(bits);
    default:
      return static_cast<double>(bits) / letter->per_one;
  }
}

std::string_view dataflash_text(std::string_view message, const DataflashField& field) {
  const Letter* const letter = letter_of(field.type);
  if (letter == nullptr || letter->kind != Kind::kText) return {};
  return field.offset <= message.size() ? text_at(message, field.offset, letter->size)
                                        : std::string_view();
}

}  // namespace beespace::io
