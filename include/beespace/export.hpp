// Marks what the shared library exports; everything else stays hidden.
#pragma once

#if defined(BEESPACE_STATIC)
#define BEESPACE_API
#else
#define BEESPACE_API __attribute__((visibility("default")))
#endif
