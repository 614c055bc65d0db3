// A pipe whose ends no program inherits.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <optional>

#include "base/system/unique_fd.h"

namespace cls::process {

struct Pipe {
  base::UniqueFd read;
  base::UniqueFd write;
};

/// Nothing, with errno set, without free descriptors.
inline std::optional<Pipe> make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Pipe{base::UniqueFd(ends[0]), base::UniqueFd(ends[1])};
}

}  // namespace cls::process
