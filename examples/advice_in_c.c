/* Eight drones on a circle fly to the opposite point, through the middle of all, as they are
 * advised: how close do they come?
 */
#include <beespace.h>

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

enum { DRONES = 8, STEPS = 250 };

static double position[DRONES][3], velocity[DRONES][3], goal[DRONES][3], preferred[DRONES][3];

/* The least distance of two. */
static double closest(void) {
  double least = INFINITY;
  for (int i = 0; i < DRONES; ++i) {
    for (int j = 0; j < i; ++j) {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const double apart = position[i][axis] - position[j][axis];
        square += apart * apart;
      }
      least = fmin(least, sqrt(square));
    }
  }
  return least;
}

int main(void) {
  for (int i = 0; i < DRONES; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / DRONES;
    position[i][0] = 30.0 * cos(angle);
    position[i][1] = 30.0 * sin(angle);
    position[i][2] = goal[i][2] = 40.0;
    goal[i][0] = -position[i][0];
    goal[i][1] = -position[i][1];
  }
  const double max_speed = 6.0, max_acceleration = 4.0; /* of all: their strides are 0 */
  const beespace_limits limits = {.struct_size = sizeof limits,
                                  .max_speeds_mps = &max_speed,
                                  .max_accelerations_mps2 = &max_acceleration};
  const beespace_advise_options options = {
      .struct_size = sizeof options, .threshold_m = 2.0, .step_s = 0.1};
  const beespace_points at = beespace_points_interleaved(position[0], DRONES);
  const beespace_points speed = beespace_points_interleaved(velocity[0], DRONES);
  const beespace_points to = beespace_points_interleaved(goal[0], DRONES);
  const beespace_points wish = beespace_points_interleaved(preferred[0], DRONES);
  beespace_error error = {.struct_size = sizeof error};
  beespace_adviser* adviser = beespace_adviser_create();
  beespace_advice* advice = beespace_advice_create();
  double least = closest();
  int64_t not_certified = 0;

  for (int step = 0; step < STEPS; ++step) {
    if (beespace_velocity_to_goal(&at, &to, &limits, options.step_s, preferred[0], &error) !=
            BEESPACE_OK ||
        beespace_advise(adviser, &at, &speed, &wish, &limits, &options, NULL, advice, &error) !=
            BEESPACE_OK) {
      fprintf(stderr, "%s: %s\n", beespace_code_name(error.code), error.message);
      return 1;
    }
    for (int i = 0; i < DRONES; ++i) {
      not_certified += !beespace_advice_certified(advice)[i];
      /* Where this step leads as advised. The next call begins there. */
      for (int axis = 0; axis < 3; ++axis) {
        const double advised = beespace_advice_velocities(advice)[3 * i + axis];
        position[i][axis] += (velocity[i][axis] + advised) / 2.0 * options.step_s;
        velocity[i][axis] = advised;
      }
    }
    least = fmin(least, closest());
  }

  int arrived = 0;
  for (int i = 0; i < DRONES; ++i) {
    arrived += hypot(position[i][0] - goal[i][0], position[i][1] - goal[i][1]) < 1.0;
  }
  printf("arrived: %d of %d, not certified: %" PRId64 ", never closer than 2 m: %s\n", arrived,
         DRONES, not_certified, least >= 2.0 ? "true" : "false");
  beespace_advice_free(advice);
  beespace_adviser_free(adviser);
  return 0;
}
