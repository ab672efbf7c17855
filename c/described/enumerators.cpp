// Compiled into the library that is described for scripts/check-abi, and into no other: functions
// that each take an enumeration of <beespace.h>. All others take numbers of a fixed width, from
// which no description tells what a number means.
#include <beespace.h>

// It returns its name, so that the compiler makes no two of them one.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a name is made of another one
#define BEESPACE_DESCRIBE(enumeration)                                               \
  extern "C" BEESPACE_C_API const char* described_##enumeration(enumeration number); \
  const char* described_##enumeration(enumeration /*number*/) {                      \
    return #enumeration;                                                             \
  }

BEESPACE_DESCRIBE(beespace_codes)
BEESPACE_DESCRIBE(beespace_number_types)
BEESPACE_DESCRIBE(beespace_search_flags)
BEESPACE_DESCRIBE(beespace_out_of_core_phases)
BEESPACE_DESCRIBE(beespace_obstacle_kinds)
BEESPACE_DESCRIBE(beespace_obstacle_flags)
BEESPACE_DESCRIBE(beespace_swarm_flags)
BEESPACE_DESCRIBE(beespace_event_kinds)
BEESPACE_DESCRIBE(beespace_bounds)
BEESPACE_DESCRIBE(beespace_verify_flags)
BEESPACE_DESCRIBE(beespace_violation_kinds)
BEESPACE_DESCRIBE(beespace_free_shapes)
BEESPACE_DESCRIBE(beespace_advise_methods)
BEESPACE_DESCRIBE(beespace_advise_flags)
BEESPACE_DESCRIBE(beespace_kinds_of_advice)
BEESPACE_DESCRIBE(beespace_finding_lists)
BEESPACE_DESCRIBE(beespace_refused_kinds)
BEESPACE_DESCRIBE(beespace_loop_places)
BEESPACE_DESCRIBE(beespace_command_replies)
BEESPACE_DESCRIBE(beespace_report_flags)
BEESPACE_DESCRIBE(beespace_contract_states)
BEESPACE_DESCRIBE(beespace_contract_reasons)
