// The languages of the example teams, for tests of projects and of code in the documentation.
#pragma once

#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace cls::tests {

/// A language of `cls new`, and what the host needs for it.
struct Language {
  std::string name;                       ///< as `cls new` has it
  std::vector<std::string> tools;         ///< programs on PATH
  std::vector<std::string> version = {};  ///< prints the version of the first tool
  std::pair<int, int> least = {};         ///< version that the first tool needs

  friend void PrintTo(const Language& language, std::ostream* out);
};

const std::vector<Language>& languages();

/// Why the host lacks the tools of a language; empty: it has them. Its registry of packages may be
/// unreachable nevertheless.
std::string why_missing(const Language& language);
std::string why_missing(const std::string& language);

/// True if `output` of a build says that a registry of packages cannot be reached.
bool is_about_network(const std::string& output);

}  // namespace cls::tests
