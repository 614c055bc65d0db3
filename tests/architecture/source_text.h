// C++ source for the architecture rules: without comments and literals, by line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::tests {

/// One source file; `path` is relative to the repository root, with forward slashes.
struct SourceFile {
  std::string path;
  std::string text;
};

struct Include {
  int line;          ///< from 1
  std::string path;  ///< path between the quotes or brackets
  bool quoted;       ///< "..." rather than <...>
};

enum class Literals { kKeep, kBlank };

/// Replaces comments, and with kBlank the contents of string and character literals, with spaces.
/// Line numbers do not change.
std::string without_comments(std::string_view text, Literals literals);

/// All include directives outside comments, in order.
std::vector<Include> includes_of(std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

struct Function {
  int line;    ///< its first line, from 1
  int length;  ///< in lines, from that line to the closing brace
};

/// Functions defined at the left margin, that is all but those within a class body.
std::vector<Function> functions_of(std::string_view text);

}  // namespace cls::tests
