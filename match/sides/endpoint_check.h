// Checks that a match could start with a side, without starting a program.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "match/terms/endpoint.h"

namespace cls::match {

struct EndpointProblem {
  enum class Kind {
    kUnreachable,  ///< no Playmaker listens at the address
    kMissing,      ///< a file or program does not exist or cannot be executed
    kBadScript,    ///< a mock script with errors
    kUnknown,      ///< no behavior of the mock has this name
  };
  Kind kind = Kind::kUnreachable;
  std::string text;  ///< what is wrong, and the remedy where there is one
};

/// Checks mock scripts and behaviors, programs of `run:` commands and start scripts of teams;
/// relative paths start in the working directory. An address must accept a gRPC connection within
/// `patience`, because a Playmaker may be starting.
std::optional<EndpointProblem> check_endpoint(const Endpoint& endpoint,
                                              std::chrono::milliseconds patience);

}  // namespace cls::match
