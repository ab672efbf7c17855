// Which number an agent has for the Guide, and how messages call it. A number is never used again.
#pragma once

#include <beespace/agent_id.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace beespace::cli {

class AgentNames {
 public:
  [[nodiscard]] std::optional<AgentId> find(std::string_view name) const {
    const auto found = numbers_.find(name);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  // The next number that is free; add() takes it.
  [[nodiscard]] AgentId next() const { return next_; }
  AgentId add(std::string_view name) {
    const AgentId number = next_++;
    numbers_.emplace(name, number);
    names_.emplace(number, name);
    return number;
  }
  void remove(AgentId number) {
    const auto found = names_.find(number);
    if (found == names_.end()) return;
    numbers_.erase(found->second);
    names_.erase(found);
  }
  // Of a number that was added.
  [[nodiscard]] const std::string& name(AgentId number) const { return names_.at(number); }
  [[nodiscard]] std::size_t size() const { return names_.size(); }

 private:
  std::map<std::string, AgentId, std::less<>> numbers_;
  std::unordered_map<AgentId, std::string> names_;
  AgentId next_ = 1;
};

}  // namespace beespace::cli
