// Citations of the specifications name a page of docs/spec and a section that exists there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/rules.h"
#include "tests/architecture/source_files.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

/// Page, such as "simulation-model.md", to the numbers of its headings.
using Pages = std::map<std::string, std::set<std::string>>;

const std::string kNumber = R"(\d{1,2}(?:\.\d{1,2})?)";
const std::string kNumbers =
    kNumber + R"((?:(?:,[\s#]+|[\s#]+and[\s#]+|[\s#]+to[\s#]+))" + kNumber + ")*";
const std::string kPageNames =
    R"((?:(?:simulation(?:-|\s+)model|server(?:-|\s+)protocol|log(?:-|\s+)formats|)"
    R"(proxy(?:-|\s+)behaviou?r|playmaker(?:-|\s+)wire|match(?:-|\s+)statistics)))";

/// A piece of text that may cite, with the line at which it begins.
struct Passage {
  int line = 1;
  std::string text;
};

std::string extension_of(const std::string& path) { return fs::path(path).extension().string(); }

bool has_cpp_comments(const std::string& path) {
  static const std::set<std::string> extensions = {".h", ".cpp", ".inc", ".proto"};
  return extensions.count(extension_of(path)) != 0;
}

bool may_cite(const std::string& path) {
  static const std::set<std::string> others = {".md", ".py", ".sh", ".cmake"};
  return has_cpp_comments(path) || others.count(extension_of(path)) != 0;
}

// Comment markers become spaces, so that a citation may continue on the next line.
void erase_markers(std::string& text) {
  for (std::size_t at = text.find("//"); at != std::string::npos; at = text.find("//", at)) {
    while (at < text.size() && (text[at] == '/' || text[at] == '<')) text[at++] = ' ';
  }
}

/// The comments of C++ or proto source; lines of comments that follow each other make one passage.
std::vector<Passage> comments_of(const std::string& source) {
  const std::string code = without_comments(source, Literals::kKeep);
  std::vector<Passage> comments;
  int line = 1;
  bool open = false;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char c = source[i];
    const bool is_space = std::isspace(static_cast<unsigned char>(c)) != 0;
    const bool is_comment = !is_space && code[i] != c;
    if (is_comment && !open) comments.push_back({line, ""});
    open = is_comment || (open && is_space);
    if (open) comments.back().text += c;
    if (c == '\n') ++line;
  }
  for (Passage& comment : comments) erase_markers(comment.text);
  return comments;
}

std::vector<Passage> passages_of(const SourceFile& file) {
  if (has_cpp_comments(file.path)) return comments_of(file.text);
  return {{1, file.text}};
}

/// Every match of `pattern`; `report` gets the match and its line.
template <typename Report>
void for_each_match(const Passage& passage, const std::regex& pattern, Report report) {
  const std::string& text = passage.text;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at) {
    const auto lines = std::count(text.begin(), text.begin() + at->position(), '\n');
    report(*at, passage.line + static_cast<int>(lines));
  }
}

std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number(kNumber);
  std::vector<std::string> numbers;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at) {
    numbers.push_back(at->str());
  }
  return numbers;
}

/// `docs/spec/<page> <sections>`, or on a docs page a link to the page followed by the sections.
int check_citations(const SourceFile& file, const Pages& pages, std::vector<Violation>& out) {
  static const std::regex in_text(R"(docs/spec/([\w-]+\.md)(?:[\s#]+()" + kNumbers + "))?");
  static const std::regex by_link(R"(\]\((?:(?:\.\./)?spec/)?([\w-]+\.md)\)\s+()" + kNumbers + ")");
  int citations = 0;

  const auto check = [&](const std::smatch& match, int line) {
    const auto page = pages.find(match[1].str());
    if (page == pages.end()) {
      out.push_back({file.path, line, "docs/spec/" + match[1].str() + " does not exist"});
      return;
    }
    for (const std::string& number : numbers_in(match[2].str())) {
      ++citations;
      if (page->second.count(number) != 0) continue;
      out.push_back({file.path, line, "docs/spec/" + page->first + " has no section " + number});
    }
  };

  for (const Passage& passage : passages_of(file)) {
    if (passage.text.find("docs/spec/") != std::string::npos) {
      for_each_match(passage, in_text, check);
    }
    if (extension_of(file.path) != ".md") continue;
    for_each_match(passage, by_link, [&](const std::smatch& match, int line) {
      if (pages.count(match[1].str()) != 0) check(match, line);
    });
  }
  return citations;
}

bool is_section(const std::string& number, const Pages& pages) {
  return std::any_of(pages.begin(), pages.end(),
                     [&](const auto& page) { return page.second.count(number) != 0; });
}

/// Section numbers without a page, such as a number alone in parentheses, in comments.
std::vector<Violation> bare_citations(const SourceFile& file, const Pages& pages) {
  if (!has_cpp_comments(file.path)) return {};
  static const std::regex alone(R"(\(()" + kNumbers + R"()\))");
  static const std::regex named("(?:" + kPageNames + R"(|\(protocol),?\s+(?:sections?\s+)?\d)",
                                std::regex::icase);
  static const std::regex page_alone(R"((?:^|[^/\w-]))" + kPageNames + R"(\.md\s+\d)");
  static const std::regex section(R"(\bsections?\s+\d)", std::regex::icase);
  std::vector<Violation> violations;

  const auto report = [&](const std::smatch& match, int line) {
    violations.push_back({file.path, line,
                          match.str() + ": cite as docs/spec/<page>.md <section>, or give a "
                                        "number its unit"});
  };

  for (const Passage& comment : comments_of(file.text)) {
    const bool has_digit = std::any_of(comment.text.begin(), comment.text.end(),
                                       [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!has_digit) continue;
    for (const std::regex* pattern : {&named, &page_alone, &section}) {
      for_each_match(comment, *pattern, report);
    }
    for_each_match(comment, alone, [&](const std::smatch& match, int line) {
      const auto numbers = numbers_in(match[1].str());
      const bool dotted = match[1].str().find('.') != std::string::npos;
      const bool sections = std::all_of(numbers.begin(), numbers.end(),
                                        [&](const auto& n) { return is_section(n, pages); });
      if (dotted && sections) report(match, line);
    });
  }
  return violations;
}

std::set<std::string> sections_of(const std::string& page) {
  static const std::regex heading(R"(^#+ (\d+(?:\.\d+)*)\.? )");
  std::set<std::string> sections;
  bool in_code = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with("```")) in_code = !in_code;
    std::smatch match;
    if (!in_code && std::regex_search(line, match, heading)) sections.insert(match[1]);
  }
  return sections;
}

const Pages& pages() {
  static const Pages found = [] {
    Pages result;
    for (const auto& entry : fs::directory_iterator(source_folder() / "docs/spec")) {
      if (entry.path().extension() != ".md") continue;
      result[entry.path().filename().string()] = sections_of(read_file(entry.path()));
    }
    return result;
  }();
  return found;
}

void add_file(const fs::path& path, std::vector<SourceFile>& files) {
  const std::string name = fs::relative(path, source_folder()).generic_string();
  if (may_cite(name)) files.push_back({name, read_file(path)});
}

/// Sources, proto files, scripts and pages.
std::vector<SourceFile> read_tree() {
  std::vector<SourceFile> files;
  for (const fs::path& file : source_files()) add_file(file, files);
  return files;
}

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = read_tree();
  return files;
}

/// What check_citations finds in a file of this path and text.
std::string dangling(const std::string& path, const std::string& text) {
  std::vector<Violation> violations;
  check_citations({path, text}, pages(), violations);
  return to_text(violations);
}

std::string bare(const std::string& text) {
  return to_text(bare_citations({"a.h", text}, pages()));
}

TEST(Citations, NameExistingSections) {
  std::vector<Violation> violations;
  int citations = 0;
  for (const SourceFile& file : tree()) citations += check_citations(file, pages(), violations);
  EXPECT_EQ(to_text(violations), "");
  EXPECT_GE(citations, 150);
}

TEST(Citations, NameTheirPage) {
  std::vector<Violation> all;
  for (const SourceFile& file : tree()) {
    for (Violation& violation : bare_citations(file, pages())) all.push_back(std::move(violation));
  }
  EXPECT_EQ(to_text(all), "");
}

TEST(Citations, SpecificationsHaveNumberedSections) {
  EXPECT_EQ(pages().size(), 7u);
  for (const auto& [page, sections] : pages()) {
    if (page == "README.md") continue;
    EXPECT_GE(sections.size(), 18u) << page;
  }
}

TEST(CitationCheck, ReportsMissingSectionAndPage) {
  EXPECT_EQ(dangling("a.h", "int a;\n// Motion (docs/spec/simulation-model.md 3.99).\n"),
            "a.h:2: docs/spec/simulation-model.md has no section 3.99\n");
  EXPECT_EQ(dangling("a.proto", "// See docs/spec/simulation-models.md 3.1.\n"),
            "a.proto:1: docs/spec/simulation-models.md does not exist\n");
  EXPECT_EQ(dangling("a.py", "# docs/spec/log-formats.md 1.1, 1.99\n"),
            "a.py:1: docs/spec/log-formats.md has no section 1.99\n");
  EXPECT_EQ(dangling("docs/a.md", "See [logs](spec/log-formats.md) 9.9.\n"),
            "docs/a.md:1: docs/spec/log-formats.md has no section 9.9\n");
}

TEST(CitationCheck, AcceptsListsRangesAndWrappedLines) {
  EXPECT_EQ(dangling("a.h",
                     "/// docs/spec/simulation-model.md 0, 9.2 to 9.9 and 9.12.\n"
                     "/// Text (docs/spec/log-formats.md\n/// 1.4 to\n/// 1.6).\nint a;  ///< "
                     "docs/spec/README.md\n"),
            "");
  EXPECT_EQ(dangling("a.h", "/// docs/spec/log-formats.md 1.4 to\n/// 1.66\n"),
            "a.h:1: docs/spec/log-formats.md has no section 1.66\n");
}

TEST(CitationCheck, ReportsCitationsWithoutPage) {
  for (const char* citation :
       {"(9.10)", "(4.10, 4.11, 7.2)", "(9.2 to 9.9, 9.12)", "(simulation model 7.2)",
        "(simulation\n/// model 7.2)", "log-formats 1.4", "simulation-model.md 7.2",
        "proxy behavior 3.2", "(protocol 6.5)", "(section 5)"}) {
    EXPECT_NE(bare("int a;\n/// Text " + std::string(citation) + ".\n"), "") << citation;
  }
}

TEST(CitationCheck, IgnoresNumbersWithUnitsAndCode) {
  EXPECT_EQ(bare("// docs/spec/simulation-model.md 9.10, 9.11 (9.15 m), f(0.95), (2, 3), v(1).\n"
                 "double a = f(9.10);  // one\nconst char* b = \"(9.10) section 5\";\n"),
            "");
}

}  // namespace
}  // namespace cls::tests
