// The script file of a mock side: read before anything is played.
#pragma once

#include "orchestration/match/options/endpoint.h"

namespace cls::cli {

/// Reads the script that the side names, if it names one. What is wrong with it is told on stderr;
/// the exit code then is kNoInput or kBadData, else kDone.
int read_script_of(orchestration::match::Endpoint& side);

}  // namespace cls::cli
