// Books as files (docs/formats/book.md).
#pragma once

#include <string>
#include <string_view>

#include "analysis/situations/book.h"
#include "base/io/byte_sink.h"
#include "base/result.h"

namespace cls::analysis {

/// Parses the text of a file. The error names the line: "line 3: 'frames' has 10 elements instead
/// of 11".
base::Result<Book> parse_book(std::string_view text);

/// Reads a file, plain or gzip. The error names the file and the line.
base::Result<Book> read_book(const std::string& file);

/// Numbers have six significant digits, as in game logs. The same book gives the same bytes.
void write_book(const Book& book, base::ByteSink& out);

}  // namespace cls::analysis
