// Invariants for any bytes read as a log; shared by fuzzers and a test of the corpus.
#pragma once

#include <string_view>

namespace cls::tests {

/// Reads the bytes as a game log of any version, compressed or not. Writes the record in every
/// version, reads it back, and expects the same text. Computes results and statistics. Aborts on a
/// violation.
void check_game_log(std::string_view bytes);

/// Same for a text log: parses every datagram into commands, finds results, and computes response
/// times with a small synthetic match.
void check_text_log(std::string_view bytes);

}  // namespace cls::tests
