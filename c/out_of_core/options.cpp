#include "c/out_of_core/out_of_core.hpp"

#include "c/door/door.hpp"

namespace beespace::c {

namespace {

std::int32_t phase_of(OutOfCoreProgress::Phase phase) {
  return phase == OutOfCoreProgress::Phase::kDistributing ? BEESPACE_DISTRIBUTING
                                                          : BEESPACE_SEARCHING;
}

}  // namespace

Result<OutOfCoreOptions> options_of(const beespace_out_of_core_options& given) {
  if (given.folder == nullptr || *given.folder == '\0') {
    return invalid("no folder: name one for the temporary file", "options");
  }
  if (given.memory_bytes < OutOfCoreOptions::kLeastMemoryBytes) {
    return invalid("memory_bytes is less than 16 MiB, which each thread needs", "options");
  }
  OutOfCoreOptions options;
  options.memory_bytes = given.memory_bytes;
  options.folder = given.folder;
  if (given.progress != nullptr) {
    options.progress = [tell = given.progress,
                        data = given.progress_data](const OutOfCoreProgress& progress) {
      tell(data, phase_of(progress.phase), static_cast<std::int64_t>(progress.done),
           static_cast<std::int64_t>(progress.of));
    };
  }
  return options;
}

}  // namespace beespace::c
