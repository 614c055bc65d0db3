// CLS_SANITIZED is 1 in builds with address or thread sanitizer, otherwise 0.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // GCC
#define CLS_SANITIZED 1
#elif defined(__has_feature)  // Clang
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define CLS_SANITIZED 1
#endif
#endif
#ifndef CLS_SANITIZED
#define CLS_SANITIZED 0
#endif
