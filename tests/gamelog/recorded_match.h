// Recorded matches of the fixtures.
#pragma once

#include <string>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"

namespace cls::tests {

/// The game log gamelog/NAME.rcg.gz.
inline gamelog::MatchRecord record_of(const std::string& name) {
  return gamelog::read_rcg_file(fixture("gamelog/" + name + ".rcg.gz").string()).value();
}

}  // namespace cls::tests
