// Numbers as text, whatever the locale: exact ones for machines, grouped ones for people.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// The shortest text that reads back as the same double.
void append_exact(std::string& out, double value);
void append_exact(std::string& out, std::uint64_t value);
std::string exact(double value);

// "1,234,567".
std::string grouped(std::uint64_t value);

// "1 bee", "1,234 bees".
std::string counted(std::uint64_t count, std::string_view one, std::string_view several);

// A fixed number of decimals, the integer part grouped: "12,345.68".
std::string grouped(double value, int decimals);

// A length from millimetres to kilometres, with its unit: "57.294 m". 0 is "0 m".
std::string length(double metres);

// The same of what is shown beside a limit: with more decimals where fewer would round a value that
// is below the limit up to it.
std::string grouped_below(double limit, double value, int decimals);
std::string length_below(double limit_m, double metres);
// How many decimals tell values around a limit: 1.15 around 5, 137 around 500; none without one.
int decimals_around(double limit);

// "0.4 ms", "12.3 ms", "1.25 s".
std::string duration(double seconds);

// How long something lasted, for people: "12.5 s", "3 min 20 s", "3 h 20 min".
std::string time_span(double seconds);

// "29.6 %".
std::string percentage(double share);

// "39.2 kB", "50.1 MB": powers of a thousand.
std::string byte_count(std::uint64_t bytes);

// The whole text as a number, "inf" and "nan" included; nothing when it is something else.
// A "+" may come before it, as in the input files.
std::optional<double> parse_number(std::string_view text);

// Decimal digits and nothing else, of a number below 2^64.
std::optional<std::uint64_t> parse_whole(std::string_view text);

}  // namespace beespace::io
