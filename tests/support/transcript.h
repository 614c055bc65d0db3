// Recorded transcripts of a client and rcssserver.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::tests {

/// Messages of a transcript with lines of direction (`S>C` or `C>S`), seconds and message,
/// separated by tabs; other lines are skipped. The views point into `text`.
struct Spoken {
  bool by_server = false;
  std::string_view message;
};
std::vector<Spoken> read_transcript(std::string_view text);

}  // namespace cls::tests
