// The table of idioms with their replacements; names that are declared, but not used.
#include "tests/architecture/idioms.h"

#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace cls::tests {
namespace {

struct Idiom {
  std::string_view sign;  ///< part of every match: most lines lack it, and their search is short
  std::regex pattern;
  std::string_view instead;
  std::vector<std::string_view> allowed_in;  ///< starts of paths
};

const std::vector<Idiom>& idioms() {
  static const std::vector<Idiom> table = {
      {"rfind(", std::regex(R"(\brfind\([^()]*, 0\) [!=]= 0)"), "starts_with()", {}},
      {"std::sto",
       std::regex(R"(\bstd::sto(i|l|ll|ul|ull|f|d)\()"),
       "base::parse_int(), base::parse_number()",
       {"tests/"}},
      {"strto",
       std::regex(R"(\bstrto(l|ul|d)\()"),
       "base::parse_int(), base::parse_number()",
       {"base/", "cmake/", "packaging/", "process/", "tests/"}},
      {"ato",
       std::regex(R"(\bato[if]\()"),
       "base::parse_int(), base::parse_number()",
       {"base/", "cmake/", "packaging/", "process/", "tests/"}},
      {"from_chars",
       std::regex(R"(\bfrom_chars\()"),
       "base::parse_int(), base::parse_number()",
       {"base/", "cmake/", "soccer/protocol/", "tests/"}},
      {"thread>",
       std::regex(R"(std::vector<std::j?thread>)"),
       "base/system/parallel.h",
       {"base/system/", "training/pool/", "tests/"}},
      {"rows",
       std::regex(R"(\brows(\[\d+\]|\.front\(\)|\.back\(\))\.\w+ = )"),
       "a row that is whole where it is declared",
       {"tests/"}},
      {"? 0 : 1",
       std::regex(R"(kLeft \? 0 : 1)"),
       "soccer::PerSide, soccer::side_index()",
       {"soccer/"}},
      {"nlohmann",
       std::regex(R"(#include <nlohmann/)"),
       "base/text/json.h",
       {"base/text/json", "tests/"}},
      {"0xcbf29ce",
       std::regex(R"(\b0xcbf29ce484222325)"),
       "base/text/fnv1a.h",
       {"base/text/fnv1a.h", "tests/"}},
      {"std::c",
       std::regex(R"(\bstd::(cout|cerr|clog)\b)"),
       "fmt::print()",
       {"tests/", "examples/"}},
      {"std::bind", std::regex(R"(\bstd::bind\()"), "a lambda", {}},
      {"NULL", std::regex(R"(\bNULL\b)"), "nullptr", {}},
      {")[", std::regex(R"((^|[^\w>)\]])\([a-z_]+\)\[)"), "the name without parentheses", {}},
      {"std::find(",
       std::regex(R"(\bstd::find\(([\w.]+)\.begin\(\), \1\.end\(\))"),
       "std::ranges::find()",
       {"tests/"}},
      {"std::sort(",
       std::regex(R"(\bstd::sort\(([\w.]+)\.begin\(\), \1\.end\(\)\))"),
       "std::ranges::sort()",
       {"tests/"}},
  };

  return table;
}

bool starts_with_any(std::string_view path, const std::vector<std::string_view>& starts) {
  for (const std::string_view start : starts) {
    if (path.starts_with(start)) return true;
  }
  return false;
}

/// Calls `use` with each identifier of a line.
template <typename Use>
void each_name(std::string_view line, Use use) {
  const auto is_word = [](char c) {
    return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  for (std::size_t at = 0; at < line.size();) {
    std::size_t end = at;
    while (end < line.size() && is_word(line[end])) ++end;
    if (end > at) use(std::string(line.substr(at, end - at)));
    at = end + 1;
  }
}

/// The name that a line at the left margin declares or defines; empty: none.
std::string declared_name(const std::string& line) {
  static const std::regex constant(R"(^inline constexpr .*?\b(k[A-Z]\w*)( =|\{|\[|;|$))");
  static const std::regex type(R"(^(?:struct|class|enum class|using) (\w+)\b(?!;))");
  static const std::regex function(
      R"(^(?:\[\[nodiscard\]\] )?(?!return|using|namespace|template|#)[A-Za-z_][\w:<>,&*\s]*?[\s&*](?:\w+::)?(\w+)\()");
  std::smatch found;
  for (const std::regex* pattern : {&constant, &type, &function}) {
    if (std::regex_search(line, found, *pattern)) return found[1];
  }
  return {};
}

}  // namespace

std::vector<Violation> check_idioms(const SourceFile& file) {
  std::vector<Violation> violations;
  int number = 0;
  for (const std::string& line : lines_of(without_comments(file.text, Literals::kBlank))) {
    ++number;
    for (const Idiom& idiom : idioms()) {
      std::smatch found;
      if (line.find(idiom.sign) == std::string::npos) continue;
      if (starts_with_any(file.path, idiom.allowed_in)) continue;
      if (!std::regex_search(line, found, idiom.pattern)) continue;
      violations.push_back(
          {file.path, number, found.str() + ": use " + std::string(idiom.instead)});
    }
  }
  return violations;
}

std::vector<Violation> check_unused_declarations(const std::vector<SourceFile>& files) {
  struct Declaration {
    std::string path;
    int line;
  };
  std::map<std::string, Declaration> declared;
  std::set<std::string> used;

  for (const SourceFile& file : files) {
    // Users of the C interface are programs of others.
    const bool product_header =
        file.path.ends_with(".h") && !starts_with_any(file.path, {"tests/", "training/c_api/"});
    int number = 0;
    for (const std::string& line : lines_of(without_comments(file.text, Literals::kBlank))) {
      ++number;
      const std::string own = declared_name(line);
      if (!own.empty() && product_header) declared.try_emplace(own, Declaration{file.path, number});

      bool own_seen = false;
      each_name(line, [&](std::string name) {
        // The declaration itself is no use; a second mention in its line is.
        if (name == own && !std::exchange(own_seen, true)) return;
        used.insert(std::move(name));
      });
    }
  }

  std::vector<Violation> violations;
  for (const auto& [name, place] : declared) {
    if (used.contains(name)) continue;
    violations.push_back({place.path, place.line, name + ": nothing uses it; delete it"});
  }
  return violations;
}

}  // namespace cls::tests
