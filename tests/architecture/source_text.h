// C++ source as the architecture rules see it: without comments, without literals, by line.
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
  std::string path;  ///< what stands between the quotes or brackets
  bool quoted;       ///< "..." rather than <...>
};

enum class Literals { kKeep, kBlank };

/// The text with comments (and, when asked, the contents of string and character literals)
/// replaced by spaces; line breaks stay, so line numbers do.
std::string without_comments(std::string_view text, Literals literals);

/// All include directives outside comments, in order.
std::vector<Include> includes_of(std::string_view text);

std::vector<std::string> lines_of(std::string_view text);

struct Function {
  int line;    ///< where its first line stands, from 1
  int length;  ///< in lines, from that line to the closing brace
};

/// Functions that are defined at the left margin, which is where clang-format puts everything that
/// is not a member of a class body.
std::vector<Function> functions_of(std::string_view text);

}  // namespace cls::tests
