#include "tests/closed_loop/looks.hpp"

#include <cstdlib>
#include <utility>

namespace beespace::closed_loop {
namespace {

std::optional<std::size_t> value_of(const std::string& line, const std::string& name) {
  const std::string key = "\"" + name + "\": ";
  const std::size_t at = line.find(key);
  if (at == std::string::npos) return std::nullopt;
  return at + key.size();
}

}  // namespace

std::optional<double> number_in(const std::string& line, const std::string& name) {
  const auto at = value_of(line, name);
  if (!at) return std::nullopt;
  const char* begin = line.c_str() + *at;
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  if (end == begin) return std::nullopt;
  return value;
}

std::optional<std::string> text_in(const std::string& line, const std::string& name) {
  const auto at = value_of(line, name);
  if (!at || line[*at] != '"') return std::nullopt;
  const std::size_t end = line.find('"', *at + 1);
  return line.substr(*at + 1, end - *at - 1);
}

std::optional<Look> Looks::take(const std::string& line) {
  const auto event = text_in(line, "event");
  if (event == "advice") {
    BeeAdvice advised;
    const auto x = number_in(line, "vx");
    const auto y = number_in(line, "vy");
    const auto z = number_in(line, "vz");
    if (x && y && z) advised.velocity = Vector{*x, *y, *z};
    advised.certified = line.find("\"certified\": true") != std::string::npos;
    advised.because = text_in(line, "because").value_or("");
    open_.bees[text_in(line, "id").value_or("")] = advised;
    return std::nullopt;
  }
  if (event != "advised") return std::nullopt;
  Look look = std::exchange(open_, Look{});
  look.time_s = number_in(line, "time_s").value_or(0);
  look.effective_s = number_in(line, "effective_s").value_or(0);
  look.closing = line;
  return look;
}

}  // namespace beespace::closed_loop
