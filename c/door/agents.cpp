#include "c/door/agents.hpp"

#include <cctype>
#include <cstddef>
#include <string>

namespace beespace::c {

Error with_agent_number(Error error, AgentId agent) {
  const std::int64_t number = agent_number_of(agent);
  error.location.record = static_cast<std::uint64_t>(number);
  const std::string there = "agent " + std::to_string(agent);
  const std::string here = "agent " + std::to_string(number);
  for (std::size_t at = error.message.find(there); at != std::string::npos;
       at = error.message.find(there, at + here.size())) {
    const std::size_t end = at + there.size();
    const bool goes_on = end < error.message.size() &&
                         std::isdigit(static_cast<unsigned char>(error.message[end])) != 0;
    if (!goes_on) error.message.replace(at, there.size(), here);
  }
  return error;
}

}  // namespace beespace::c
