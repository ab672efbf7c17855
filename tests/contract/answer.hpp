// Answers of all kinds in one form, so that any two can be compared, digested and shown.
#pragma once

#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>

#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::test {

using Answer = std::vector<std::uint64_t>;

inline Answer flat(const std::vector<std::uint32_t>& ids_or_counts) {
  return {ids_or_counts.begin(), ids_or_counts.end()};
}

inline Answer flat(const std::vector<Pair>& pairs) {
  Answer answer;
  answer.reserve(pairs.size());
  for (const Pair& pair : pairs) answer.push_back(std::uint64_t{pair.first} << 32 | pair.second);
  return answer;
}

inline Answer flat(const IdRows& rows) {
  Answer answer(rows.offsets);
  if (answer.empty()) answer.push_back(0);
  answer.insert(answer.end(), rows.ids.begin(), rows.ids.end());
  return answer;
}

inline Answer flat(const std::vector<Nearest>& nearest) {
  Answer answer;
  answer.reserve(2 * nearest.size());
  for (const Nearest& one : nearest) {
    answer.push_back(one.id);
    answer.push_back(std::bit_cast<std::uint64_t>(one.distance_m));
  }
  return answer;
}

inline Answer flat(const std::optional<ClosestPair>& pair) {
  if (!pair) return {};
  return {pair->first, pair->second, std::bit_cast<std::uint64_t>(pair->distance_m)};
}

// The error's code and place, but not its sentence.
inline Answer flat(const Error& error) {
  Answer answer = {~std::uint64_t{0}, static_cast<std::uint64_t>(error.code),
                   error.location.record.value_or(~std::uint64_t{0})};
  answer.insert(answer.end(), error.location.array.begin(), error.location.array.end());
  return answer;
}

template <class T>
Answer flat(const Result<T>& result) {
  return result ? flat(*result) : flat(result.error());
}

template <class Content>
Answer flat_if(const Status& status, const Content& content) {
  return status ? flat(content) : flat(status.error());
}

// FNV-1a over words, with its high bits folded back so that all bits of a word reach all others.
inline std::uint64_t digest(const Answer& answer, std::uint64_t hash = 0xcbf2'9ce4'8422'2325U) {
  const auto take = [&](std::uint64_t word) {
    hash = (hash ^ word) * 0x0000'0100'0000'01b3U;
    hash ^= hash >> 32;
  };
  take(answer.size());
  for (const std::uint64_t word : answer) take(word);
  return hash;
}

}  // namespace beespace::test
