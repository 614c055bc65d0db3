// Parses recorded transcripts.
#include "tests/support/transcript.h"

#include "tests/support/rcg_lines.h"

namespace cls::tests {

std::vector<Spoken> read_transcript(std::string_view text) {
  std::vector<Spoken> spoken;
  for (const std::string_view line : split_lines(text)) {
    const bool by_server = line.starts_with("S>C\t");
    if (!by_server && !line.starts_with("C>S\t")) continue;
    const std::size_t tab = line.find('\t', 4);
    if (tab != std::string_view::npos) spoken.push_back({by_server, line.substr(tab + 1)});
  }
  return spoken;
}

}  // namespace cls::tests
