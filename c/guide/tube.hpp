// A tube as C sees it.
#pragma once

#include <beespace.h>
#include <beespace/fleet.hpp>
#include <beespace/result.hpp>

namespace beespace::c {

Status write_tube(const Tube& tube, beespace_tube* into);

}  // namespace beespace::c
