// The tables of arrows and of forbidden things, and the loops that hold a file against them.
#include "tests/architecture/rules.h"

#include <algorithm>
#include <map>
#include <regex>

namespace cls::tests {
namespace {

using Folders = std::set<std::string>;

/// The table of arrows (docs/architecture.md has the same for people).
const std::map<std::string, Folders>& arrows() {
  static const std::map<std::string, Folders> table = {
      {"soccer", {"soccer"}},
      {"proto", {"proto"}},
      {"gamelog", {"gamelog", "soccer"}},
      {"proxy", {"proxy", "soccer", "proto"}},
      {"mock-server", {"mock-server", "soccer", "proto"}},
      {"simulator", {"simulator", "soccer", "gamelog"}},
      {"viewer", {"viewer", "soccer", "gamelog"}},
      {"orchestration",
       {"orchestration", "soccer", "proto", "gamelog", "proxy", "mock-server", "simulator",
        "viewer"}},
      {"cli",
       {"cli", "soccer", "proto", "gamelog", "proxy", "mock-server", "simulator", "viewer",
        "orchestration"}},
      {"bench",
       {"bench", "soccer", "proto", "gamelog", "proxy", "mock-server", "simulator", "viewer",
        "orchestration", "tests"}},
      {"tests",
       {"tests", "soccer", "proto", "gamelog", "proxy", "mock-server", "simulator", "viewer",
        "orchestration", "cli"}},
  };
  return table;
}

/// A header that some folders must not include; `except` is the start of paths that may.
struct ForbiddenHeader {
  Folders folders;
  std::string except;
  std::vector<std::string> headers;  ///< whole names, or beginnings when they end in '/'
  std::string message;
};

const std::vector<ForbiddenHeader>& forbidden_headers() {
  static const std::vector<ForbiddenHeader> table = {
      {{"soccer", "gamelog", "simulator", "viewer"},
       "",
       {"grpc/", "grpcpp/", "grpc++/", "google/protobuf/"},
       "the wire to Playmakers is no business of this folder"},
      // Only what drives the simulator (UDP, real time) may know clocks, threads and sockets:
      // the files whose path begins with simulator/server.
      {{"simulator"},
       "simulator/server",
       {"arpa/", "atomic", "boost/asio/", "boost/asio.hpp", "chrono", "condition_variable", "ctime",
        "future", "mutex", "netinet/", "poll.h", "pthread.h", "sys/epoll.h", "sys/select.h",
        "sys/socket.h", "sys/time.h", "thread", "time.h"},
       "no clocks, threads or sockets below simulator/server*"},
      {{"soccer", "gamelog", "simulator", "proxy", "mock-server"},
       "",
       {"math.h"},
       "include <cmath> for exact functions, soccer/math.h for the others"},
  };
  return table;
}

/// A pattern of code that some folders must not contain; `except` is the start of paths that may.
struct ForbiddenCode {
  Folders folders;
  std::string except;
  std::regex pattern;
  std::string message;
};

const std::vector<ForbiddenCode>& forbidden_code() {
  // A name qualified by anything but std, or a member, is not the C library's.
  static const std::string functions =
      "(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|"
      "log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma)[fl]?";
  static const std::vector<ForbiddenCode> table = {
      {{"soccer", "simulator", "proxy", "mock-server"},
       "soccer/math.",
       std::regex(R"((\bstd::|(^|[^\w:])::|(^|[^\w:.>])))" + functions + R"(\s*\()"),
       "its last bits depend on the processor: use soccer/math.h"},
      {{"soccer", "simulator", "proxy", "mock-server"},
       "",
       std::regex(R"(\bstd::(\w+_distribution|random_device|shuffle|sample|generate_canonical)\b)"),
       "differs between libraries or runs: use the seeded streams of soccer/random.h"},
      {{"soccer", "simulator", "proxy", "mock-server"},
       "",
       std::regex(R"((\bstd::|(^|[^\w:.>]))(rand|srand|random|drand48)\s*\()"),
       "hidden global state: use the seeded streams of soccer/random.h"},
      {{"simulator"},
       "simulator/server",
       std::regex(R"(\bstd::(chrono|thread|jthread|mutex|this_thread|async|atomic|time)\b)"),
       "no clocks or threads below simulator/server*"},
      {{"tests"},
       "tests/support/",
       std::regex(R"(\b(TempDir|temp_directory_path|tmpnam)\s*\()"),
       "two runs at once would meet there: use tests/support/temporary_folder.h"},
  };
  return table;
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool applies(const Folders& folders, const std::string& except, const std::string& path) {
  return folders.count(folder_of(path)) != 0 && (except.empty() || !starts_with(path, except));
}

bool is_header(const std::string& name, const std::string& entry) {
  return entry.back() == '/' ? starts_with(name, entry) : name == entry;
}

constexpr int kMaxFileLines = 800;
constexpr int kMaxFunctionLines = 60;
constexpr int kMaxMainLines = 60;

}  // namespace

std::string to_text(const std::vector<Violation>& violations) {
  std::string text;
  for (const Violation& violation : violations) {
    text += violation.path + ":" + std::to_string(violation.line) + ": " + violation.message + "\n";
  }
  return text;
}

const std::set<std::string>& known_folders() {
  static const std::set<std::string> folders = [] {
    std::set<std::string> names;
    for (const auto& [folder, unused] : arrows()) names.insert(folder);
    return names;
  }();
  return folders;
}

const std::set<std::string>& allowed_folders(const std::string& folder) {
  static const std::set<std::string> none;
  const auto found = arrows().find(folder);
  return found == arrows().end() ? none : found->second;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

std::vector<Violation> check_arrows(const SourceFile& file) {
  std::vector<Violation> violations;
  const std::string folder = folder_of(file.path);
  if (known_folders().count(folder) == 0) {
    return {{file.path, 0, "a new folder: give it its arrows in tests/architecture/rules.cpp"}};
  }
  for (const Include& include : includes_of(file.text)) {
    const std::string target = folder_of(include.path);
    const bool ours = known_folders().count(target) != 0;
    if (include.quoted && !ours) {
      violations.push_back({file.path, include.line,
                            "\"" + include.path +
                                "\": quotes are for our own headers, written "
                                "from the root of the repository"});
    } else if (ours && allowed_folders(folder).count(target) == 0) {
      violations.push_back({file.path, include.line,
                            folder + " must not include " + target + " (" + include.path + ")"});
    }
  }
  return violations;
}

std::vector<Violation> check_foreign_headers(const SourceFile& file) {
  std::vector<Violation> violations;
  for (const Include& include : includes_of(file.text)) {
    for (const ForbiddenHeader& rule : forbidden_headers()) {
      if (!applies(rule.folders, rule.except, file.path)) continue;
      const bool hit =
          std::any_of(rule.headers.begin(), rule.headers.end(),
                      [&](const auto& entry) { return is_header(include.path, entry); });
      if (hit) violations.push_back({file.path, include.line, include.path + ": " + rule.message});
    }
  }
  return violations;
}

std::vector<Violation> check_determinism(const SourceFile& file) {
  std::vector<Violation> violations;
  const auto lines = lines_of(without_comments(file.text, Literals::kBlank));
  for (const ForbiddenCode& rule : forbidden_code()) {
    if (!applies(rule.folders, rule.except, file.path)) continue;
    int number = 0;
    for (const std::string& line : lines) {
      ++number;
      std::smatch match;
      if (std::regex_search(line, match, rule.pattern)) {
        violations.push_back({file.path, number, match.str() + ": " + rule.message});
      }
    }
  }
  return violations;
}

std::vector<Violation> check_shape(const SourceFile& file) {
  std::vector<Violation> violations;
  const std::vector<std::string> lines = lines_of(file.text);
  if (lines.empty() || !starts_with(lines.front(), "// ")) {
    violations.push_back({file.path, 1, "begin with one sentence of purpose: // ..."});
  }
  const bool is_main = file.path == "cli/main.cpp";
  const int limit = is_main ? kMaxMainLines - 1 : kMaxFileLines;
  if (static_cast<int>(lines.size()) > limit) {
    violations.push_back({file.path, 0,
                          std::to_string(lines.size()) + " lines, at most " +
                              std::to_string(limit) + ": split by idea"});
  }
  for (const Function& function : functions_of(file.text)) {
    if (function.length <= kMaxFunctionLines) continue;
    violations.push_back({file.path, function.line,
                          "a function of " + std::to_string(function.length) +
                              " lines: split it, it does not fit a screen"});
  }
  static const std::regex put_off(std::string("\\b(TO") + "DO|FIX" + "ME|X" + "XX)\\b");
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    if (std::regex_search(line, put_off)) {
      violations.push_back({file.path, number, "do it now or write it in an issue"});
    }
  }
  return violations;
}

std::vector<Violation> check_process_wrapper(const std::vector<SourceFile>& files) {
  std::vector<Violation> violations;
  std::string wrapper;
  for (const SourceFile& file : files) {
    for (const Include& include : includes_of(file.text)) {
      if (!starts_with(include.path, "boost/process")) continue;
      if (folder_of(file.path) != "orchestration") {
        violations.push_back({file.path, include.line, "Boost.Process belongs in orchestration"});
      } else if (wrapper.empty()) {
        wrapper = file.path;
      } else if (wrapper != file.path) {
        violations.push_back({file.path, include.line, "Boost.Process is wrapped in " + wrapper});
      }
    }
  }
  return violations;
}

}  // namespace cls::tests
