/// @file
/// @brief Static obstacles: buildings, masts, no-fly zones, the ground. Part of <beespace.h>.
#ifndef BEESPACE_C_OBSTACLES_H
#define BEESPACE_C_OBSTACLES_H

#include <beespace/c/basics.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// @brief The kinds of obstacles, for beespace_obstacle::kind.
enum beespace_obstacle_kinds {
  BEESPACE_SPHERE = 1,    ///< A sphere: `center`, `radius_m`.
  BEESPACE_BOX = 2,       ///< A box along the axes: `low` and `high`, two of its corners.
  BEESPACE_GROUND = 3,    ///< All space below a height: `high[2]`.
  BEESPACE_CYLINDER = 4,  ///< A cylinder whose axis is vertical: `center[0]`, `center[1]`,
                          ///< `radius_m`, and heights.
  BEESPACE_PRISM = 5      ///< A prism whose edges are vertical: `outline`, and heights.
};

/// @brief The flags of beespace_obstacle::flags: how high a cylinder or prism goes. Without one it
/// has no end there.
enum beespace_obstacle_flags {
  BEESPACE_LOWEST = 1,  ///< It begins at the height `low[2]`.
  BEESPACE_HIGHEST = 2  ///< It ends at the height `high[2]`.
};

/// @brief An obstacle, in the frame of the positions that it is compared with, in which z is up.
/// What its kind does not use must be zero: a height without its flag is an error.
typedef struct beespace_obstacle {
  size_t struct_size;     ///< sizeof(beespace_obstacle)
  int32_t kind;           ///< BEESPACE_SPHERE ...
  uint32_t flags;         ///< BEESPACE_LOWEST | BEESPACE_HIGHEST
  double center[3];       ///< Metres: the centre; of a cylinder x and y of its axis.
  double radius_m;        ///< Metres; zero or more.
  double low[3];          ///< Metres: the lowest corner of a box; of others a height, as [2].
  double high[3];         ///< Metres: the highest corner of a box; of others a height, as [2].
  const double* outline;  ///< x0 y0 x1 y1 ...: corner after corner, either way round, the last
                          ///< joined to the first. It must not cross or touch itself.
  int64_t corners;        ///< How many corners `outline` has; three or more.
  int64_t reserved;       ///< Zero.
} beespace_obstacle;

/// @brief Many obstacles, checked and ordered in space, in memory of their own. Many threads may
/// use them at the same time.
typedef struct beespace_obstacles beespace_obstacles;

/// @brief Checks obstacles and keeps a copy of them.
///
/// Time grows with the square of the corners of an outline, and little with the obstacles.
///
/// @param obstacles One after the other, each `struct_size` bytes behind the one before; copied.
///   NULL where there is none.
/// @param count How many there are; zero or more.
/// @param[out] made The obstacles, to be freed by beespace_obstacles_free(); NULL after an error.
/// @param[out] error What went wrong, with the obstacle in beespace_error::record; or NULL.
/// @return BEESPACE_OK or the code of the error:
///   - BEESPACE_INVALID_ARGUMENT: an obstacle that is none: a radius below zero, a box or heights
///     upside down, an outline of fewer than three corners, with one given twice, that crosses or
///     touches itself, or that encloses nothing;
///   - BEESPACE_NOT_FINITE, BEESPACE_OUTSIDE_DOMAIN: a number of it, which is to be 0 or of a
///     magnitude from 2^-100 to 2^100;
///   - BEESPACE_OUT_OF_MEMORY.
BEESPACE_C_API beespace_code beespace_obstacles_create(const beespace_obstacle* obstacles,
                                                       int64_t count, beespace_obstacles** made,
                                                       beespace_error* error);
/// @brief Frees obstacles; no call, and no handle that was made with them, may be using them.
/// @param obstacles The obstacles; NULL does nothing.
BEESPACE_C_API void beespace_obstacles_free(beespace_obstacles* obstacles);
/// @brief Says how many obstacles there are.
/// @param obstacles The obstacles.
/// @return Their number; 0 of NULL.
BEESPACE_C_API int64_t beespace_obstacles_size(const beespace_obstacles* obstacles);

#ifdef __cplusplus
}
#endif

#endif
