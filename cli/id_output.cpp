#include "cli/answer_output.hpp"
#include "cli/block_writer.hpp"
#include "cli/number_text.hpp"

#include <array>
#include <charconv>
#include <cstddef>

namespace beespace::cli {
namespace {

void write_numbers(const std::vector<PointId>& numbers, io::AtomicOutput& output) {
  constexpr std::size_t kLongestLine = 11;
  std::array<char, std::size_t{1} << 15> block;
  char* at = block.data();
  char* const end = block.data() + block.size();
  for (const PointId number : numbers) {
    if (static_cast<std::size_t>(end - at) < kLongestLine) {
      output.write({block.data(), static_cast<std::size_t>(at - block.data())});
      at = block.data();
    }
    at = std::to_chars(at, end, number).ptr;
    *at++ = '\n';
  }
  output.write({block.data(), static_cast<std::size_t>(at - block.data())});
}

}  // namespace

void write_ids(const Detection& detection, const ShownIds& ids, bool nearest,
               io::AtomicOutput& output) {
  if (ids.are_point_numbers() && !nearest) return write_numbers(detection.at_risk, output);
  BlockWriter out(output);
  for (const PointId point : detection.at_risk) {
    ids.append(out.text, point);
    if (nearest) {
      out.text += '\t';
      ids.append(out.text, detection.nearest[point].id);
      out.text += '\t';
      append_exact(out.text, detection.nearest[point].distance_m);
    }
    out.text += '\n';
    out.pass_on();
  }
}

}  // namespace beespace::cli
