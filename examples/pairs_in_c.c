/* Four drones, positions in metres: which pairs are closer than 100 m, and how far apart are they?
 */
#include <beespace.h>

#include <inttypes.h>
#include <stdio.h>

int main(void) {
  const double xyz[] = {0.0, 0.0, 50.0, 80.0, 60.0, 50.0, 300.0, 0.0, 50.0, 300.0, 0.0, 149.9};
  const beespace_points drones = beespace_points_interleaved(xyz, 4);
  const beespace_search search = {
      .struct_size = sizeof search, .flags = BEESPACE_DISTANCES, .threshold_m = 100.0};
  beespace_error error = {.struct_size = sizeof error};

  beespace_result* pairs = beespace_result_create();
  if (beespace_pairs(NULL, &drones, NULL, &search, NULL, pairs, &error) != BEESPACE_OK) {
    fprintf(stderr, "%s: %s\n", beespace_code_name(error.code), error.message);
    beespace_result_free(pairs);
    return 1;
  }
  const int64_t* first = beespace_result_first(pairs);
  const int64_t* second = beespace_result_second(pairs);
  const double* distances_m = beespace_result_distances_m(pairs);
  for (int64_t i = 0; i < beespace_result_size(pairs); ++i) {
    printf("%" PRId64 " and %" PRId64 " are %.1f m apart\n", first[i], second[i], distances_m[i]);
  }
  beespace_result_free(pairs);
  return 0;
}
