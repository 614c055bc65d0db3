// The errors of results.
#pragma once

#include <string>

#include "base/result.h"

namespace cls::tests {

/// The message; empty if there is a value.
template <typename T>
std::string error_of(const base::Result<T>& result) {
  return result ? "" : result.error().message;
}

}  // namespace cls::tests
