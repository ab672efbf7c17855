/* Which bees of a file are closer than a threshold to another one?
 *
 *   read_in_c FILE METRES
 */
#include <beespace_io.h>

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

int main(int count, char** arguments) {
  char* end = NULL;
  const double metres = count == 3 ? strtod(arguments[2], &end) : 0.0;
  if (count != 3 || end == arguments[2] || *end != '\0') return 2; /* "5ft" is no number */
  beespace_io_error problem = {.struct_size = sizeof problem};
  beespace_io_points* bees = NULL;
  if (beespace_io_read_points(arguments[1], NULL, &bees, &problem) != BEESPACE_OK) {
    char line[2200];
    beespace_io_error_text(&problem, line, sizeof line);
    fprintf(stderr, "%s\n", line);
    return 1;
  }
  const beespace_io_facts* facts = beespace_io_points_facts(bees);
  printf("%s: %s\n", beespace_io_facts_frame(facts), beespace_io_facts_frame_reason(facts));
  for (int64_t i = 0; i < beespace_io_facts_note_count(facts); ++i) {
    printf("%s\n", beespace_io_facts_note(facts, i));
  }

  const beespace_points points = beespace_io_points_view(bees);
  const beespace_search search = {.struct_size = sizeof search, .threshold_m = metres};
  beespace_error error = {.struct_size = sizeof error};
  beespace_result* at_risk = beespace_result_create();
  const beespace_code code = beespace_at_risk(NULL, &points, NULL, &search, NULL, at_risk, &error);
  if (code == BEESPACE_OK) {
    const int64_t* ids = beespace_result_ids(at_risk);
    for (int64_t i = 0; i < beespace_result_size(at_risk); ++i) {
      const char* name = beespace_io_points_id(bees, ids[i]);
      printf("%s is at risk\n", name == NULL ? "a bee without a name" : name);
    }
  } else {
    fprintf(stderr, "%s\n", error.message);
  }
  beespace_result_free(at_risk);
  beespace_io_points_free(bees);
  return code == BEESPACE_OK ? 0 : 1;
}
