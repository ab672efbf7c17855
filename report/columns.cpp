#include "report/columns.hpp"

#include "report/base64.hpp"

#include <zlib.h>

#include <bit>
#include <cstddef>
#include <new>
#include <string_view>
#include <type_traits>

namespace beespace::report {
namespace {

// The lowest byte of each number, then the second of each, and so on: like stands beside like.
template <class Number>
std::string in_planes(std::span<const Number> numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (std::size_t k = 0; k < sizeof(Number); ++k) {
      bytes[k * numbers.size() + i] = static_cast<char>((numbers[i] >> (8 * k)) & 0xFFu);
    }
  }
  return bytes;
}

// Each number less the one before it, small ones of either sign as small numbers.
template <class Number>
std::vector<Number> in_differences(std::span<const Number> numbers, Differences differences) {
  constexpr unsigned kSign = 8 * sizeof(Number) - 1;
  std::vector<Number> told(numbers.size());
  Number before = 0;
  Number step_before = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto step = static_cast<Number>(numbers[i] - before);
    const auto second = static_cast<Number>(step - step_before);
    const Number difference = differences == Differences::kFirst ? step : second;
    before = numbers[i];
    step_before = step;
    const bool negative = ((difference >> kSign) & 1u) != 0;
    const auto doubled = static_cast<Number>(difference << 1u);
    told[i] = negative ? static_cast<Number>(~doubled) : doubled;
  }
  return told;
}

template <class Number>
std::string bytes_of(std::span<const Number> numbers, Differences differences) {
  if (differences == Differences::kNone) return in_planes(numbers);
  const std::vector<Number> told = in_differences(numbers, differences);
  return in_planes(std::span<const Number>(told));
}

std::string compressed(std::string_view bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string out(size, '\0');
  const int done = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                             reinterpret_cast<const Bytef*>(bytes.data()),
                             static_cast<uLong>(bytes.size()), Z_DEFAULT_COMPRESSION);
  if (done != Z_OK) throw std::bad_alloc();  // nothing else can go wrong here
  out.resize(size);
  return out;
}

}  // namespace

void Columns::add(io::JsonWriter& json, std::string_view name,
                  std::span<const std::uint8_t> numbers) {
  keep(json, name, {"u8", numbers.size()}, in_planes(numbers));
}

void Columns::add(io::JsonWriter& json, std::string_view name,
                  std::span<const std::uint16_t> numbers, Differences differences,
                  const Meaning& meaning) {
  keep(json, name, {"u16", numbers.size(), differences, meaning}, bytes_of(numbers, differences));
}

void Columns::add(io::JsonWriter& json, std::string_view name,
                  std::span<const std::uint32_t> numbers, Differences differences,
                  const Meaning& meaning) {
  keep(json, name, {"u32", numbers.size(), differences, meaning}, bytes_of(numbers, differences));
}

void Columns::add(io::JsonWriter& json, std::string_view name, std::span<const double> numbers) {
  std::vector<std::uint64_t> bits;
  bits.reserve(numbers.size());
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  keep(json, name, {"f64", bits.size()}, in_planes(std::span<const std::uint64_t>(bits)));
}

void Columns::add(io::JsonWriter& json, std::string_view name, std::span<const std::string> texts) {
  std::string list;
  io::JsonWriter(list, io::JsonLayout::kTight).value(texts);
  keep(json, name, {"json", texts.size()}, list);
}

void Columns::keep(io::JsonWriter& json, std::string_view name, const Kept& column,
                   std::string_view bytes) {
  json.begin_object(name).member("at", elements_.size()).member("type", column.type);
  json.member("count", column.count);
  if (column.differences == Differences::kFirst) json.member("code", "delta");
  if (column.differences == Differences::kSecond) json.member("code", "delta2");
  if (column.meaning.scale != 1.0) json.member("scale", column.meaning.scale);
  if (column.meaning.offset != 0.0) json.member("offset", column.meaning.offset);
  json.end();
  elements_.push_back(base64(compressed(bytes)));
}

}  // namespace beespace::report
