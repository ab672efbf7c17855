#include "io/fleet/fleet_message.hpp"

#include "io/bytes/number_text.hpp"

#include <array>
#include <limits>

namespace beespace::io {
namespace {

struct NamedReply {
  CommandReply reply;
  std::string_view name;
};

constexpr std::array<NamedReply, 7> kReplies = {{{CommandReply::kTaken, "taken"},
                                                 {CommandReply::kOlder, "older"},
                                                 {CommandReply::kTooLate, "too_late"},
                                                 {CommandReply::kTooEarly, "too_early"},
                                                 {CommandReply::kNoAncestor, "no_ancestor"},
                                                 {CommandReply::kNoBranch, "no_branch"},
                                                 {CommandReply::kInvalid, "invalid"}}};

std::optional<std::uint32_t> parse_part(std::string_view text) {
  if (text.size() > 1 && text.front() == '0') return std::nullopt;
  const auto number = parse_whole(text);
  if (!number || *number > std::numeric_limits<std::uint32_t>::max()) return std::nullopt;
  return static_cast<std::uint32_t>(*number);
}

}  // namespace

std::string branch_text(BranchNumber number) {
  return std::to_string(epoch_of(number)) + "." +
         std::to_string(static_cast<std::uint32_t>(number));
}

std::optional<BranchNumber> parse_branch(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return std::nullopt;
  const auto epoch = parse_part(text.substr(0, point));
  const auto count = parse_part(text.substr(point + 1));
  if (!epoch || !count || branch_number(*epoch, *count) == 0) return std::nullopt;
  return branch_number(*epoch, *count);
}

std::string_view name_of(CommandReply reply) {
  for (const NamedReply& named : kReplies) {
    if (named.reply == reply) return named.name;
  }
  return "invalid";
}

std::optional<CommandReply> parse_reply(std::string_view text) {
  for (const NamedReply& named : kReplies) {
    if (named.name == text) return named.reply;
  }
  return std::nullopt;
}

}  // namespace beespace::io
