#include "c/advice/findings.hpp"

#include "c/door/door.hpp"
#include "c/door/structs.hpp"

namespace beespace::c {

void Findings::clear() {
  first.clear();
  second.clear();
  distances_m.clear();
  times_s.clear();
}

Status Findings::show(const Findings* list, beespace_findings* into) {
  if (list == nullptr) return invalid("there is no list of this number", "what");
  beespace_findings shown{};
  shown.count = static_cast<std::int64_t>(list->first.size());
  shown.first = list->first.data();
  shown.second = list->second.data();
  shown.distances_m = list->distances_m.data();
  shown.times_s = list->times_s.data();
  return write_struct(into, shown, "findings");
}

}  // namespace beespace::c
