// Differences as text from which they can be had again: every double in hexadecimal.
#pragma once

#include <beespace/point.hpp>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace beespace::differential {

inline std::string hex(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%a", value);
  return text;
}

inline std::string described(const Point& p) {
  char text[128];
  std::snprintf(text, sizeof text, "{%a, %a, %a}", p.x, p.y, p.z);
  return text;
}

inline std::string described(const std::vector<Point>& points) {
  std::string text;
  for (const Point& p : points) text.append("    ").append(described(p)).append(",\n");
  return text;
}

inline std::string described(const std::vector<std::uint64_t>& answer) {
  std::string text;
  for (const std::uint64_t word : answer) {
    char one[24];
    std::snprintf(one, sizeof one, " %llx", static_cast<unsigned long long>(word));
    text += one;
  }
  return text.empty() ? " nothing" : text;
}

}  // namespace beespace::differential
