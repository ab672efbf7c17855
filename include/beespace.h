/// @file
/// @brief beespace for C, and for each language that can call C: which points are closer than a
/// threshold to which others?
///
/// C99. The comparisons are those of the C++ library: of real numbers, on the given values. No
/// rounding, machine or number of threads changes an answer.
///
/// Units: metres, in any Cartesian frame; seconds, metres per second. Ids are indices of the
/// caller's points, from 0.
///
/// Structures begin with their size, so that they can grow in later versions. Fill the rest with
/// zeros: zero means the default wherever there is one.
///
///     beespace_search search = {.struct_size = sizeof search, .threshold_m = 50.0};
///
/// Errors: a function that can fail returns a #beespace_code, and writes what is wrong into the
/// caller's beespace_error, if one is given. A result is empty after an error. No function prints,
/// aborts, throws, or keeps anything between calls besides what its handles hold.
///
/// Ownership: what a `..._create` function returns belongs to the caller, until the `..._free`
/// function of its type; to free NULL does nothing. Points and structures are read during the call
/// and not kept, but for those of beespace_out_of_core_refer(); they must not change while a call
/// reads them.
///
/// Thread safety: any number of threads may call at the same time, with handles of their own. An
/// engine, a swarm, a verifier, a search out of core and a result serve one call at a time. An
/// index may be asked by many threads at the same time, while none changes it. A stop may be used
/// by all threads.
#ifndef BEESPACE_H
#define BEESPACE_H

#include <beespace/c/advise.h>
#include <beespace/c/basics.h>
#include <beespace/c/fleet.h>
#include <beespace/c/geodesy.h>
#include <beespace/c/guide.h>
#include <beespace/c/index.h>
#include <beespace/c/large_recording.h>
#include <beespace/c/motion.h>
#include <beespace/c/obstacles.h>
#include <beespace/c/out_of_core.h>
#include <beespace/c/recording.h>
#include <beespace/c/search.h>
#include <beespace/c/swarm.h>
#include <beespace/c/verify.h>

#endif
