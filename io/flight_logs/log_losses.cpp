#include "io/flight_logs/log_losses.hpp"

namespace beespace::io {
namespace {

std::string counted_of_log(std::uint64_t count, std::string_view what) {
  return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

}  // namespace

void tell_losses(const LogLosses& losses, std::string_view id, RecordingAssembly& assembly) {
  const std::string& name = assembly.source_name();
  if (losses.damaged_places > 0) {
    assembly.note("in " + name + " " + counted_of_log(losses.damaged_bytes, "byte") + " in " +
                  counted_of_log(losses.damaged_places, "place") +
                  " are no message of a log, or a damaged one, and are passed over; the first "
                  "at byte " +
                  std::to_string(losses.first_damage));
    assembly.miss(losses.damaged_places, id);
  }
  if (losses.cut_at) {
    assembly.note("the log " + name + " ends within a message, at byte " +
                  std::to_string(*losses.cut_at) +
                  "; that one, and what may have come behind it, is left out");
    assembly.miss(1, id);
  }
}

std::string words_of(const LogLosses& losses) {
  if (losses.damaged_places > 0) {
    return "; it is damaged from byte " + std::to_string(losses.first_damage) + " on";
  }
  if (losses.cut_at) {
    return "; it ends within a message, at byte " + std::to_string(*losses.cut_at);
  }
  return {};
}

}  // namespace beespace::io
