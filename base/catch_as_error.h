// Turns the exceptions of third-party libraries into results.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "base/result.h"

namespace cls::base {

/// Runs `work` and returns its value. An exception of type `Exception` becomes an Error with its
/// text, after "CONTEXT: " unless `context` is empty.
template <typename Exception, typename Work>
auto catch_as_error(std::string_view context, Work work) -> Result<decltype(work())> {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const Exception& exception) {
    const std::string prefix = context.empty() ? "" : std::string(context) + ": ";
    return Error{prefix + exception.what()};
  }
}

}  // namespace cls::base
