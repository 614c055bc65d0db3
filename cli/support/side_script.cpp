// Reading scripts for the command line.
#include "cli/support/side_script.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "cli/support/exit_code.h"

namespace cls::cli {

int read_script_of(orchestration::match::Endpoint& side) {
  const auto loaded = load_script(side);
  if (loaded) return kDone;
  fmt::print(stderr, "cls: {}\n", loaded.error().message);
  return std::filesystem::exists(side.behaviour) ? kBadData : kNoInput;
}

}  // namespace cls::cli
