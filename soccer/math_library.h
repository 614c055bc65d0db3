// Defines CLS_SLEEF where math.cpp and directions.cpp call SLEEF instead of portable_math.h: on
// x86-64, unless the build has -DCLS_MATH=portable.
#pragma once

#if defined(__x86_64__) && !defined(CLS_PORTABLE_MATH)
#define CLS_SLEEF 1
#endif
