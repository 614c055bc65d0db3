// Tables of allowed includes and of forbidden headers and code, and the checks.
#include "tests/architecture/rules.h"

#include <algorithm>
#include <map>
#include <regex>

namespace cls::tests {
namespace {

using Folders = std::set<std::string>;

/// A folder with its own library. Its sub-folders are layers: files may include their own layer and
/// the layers listed before it. "" is the folder itself.
struct Library {
  Folders may_include;              ///< lower libraries; a library may always include itself
  std::vector<std::string> layers;  ///< lowest first; empty: no sub-folders
};

/// Everything that the command line may use.
Folders below_cli() {
  return {"base",        "soccer",   "proto",     "gamelog",    "player",   "proxy",
          "mock-server", "analysis", "simulator", "viewer",     "training", "process",
          "match",       "league",   "review",    "tournament", "scenario", "checks"};
}

Folders below_cli_and(const std::string& another) {
  Folders folders = below_cli();
  folders.insert(another);
  return folders;
}

/// What a match without threads, sockets and files consists of.
Folders below_playground() {
  return {"base",  "soccer",      "proto",     "gamelog",  "league", "player",
          "proxy", "mock-server", "simulator", "analysis", "viewer", "match"};
}

Folders everything() {
  Folders folders = below_cli_and("cli");
  folders.insert("playground");
  return folders;
}

/// All libraries, lowest first; docs/architecture.md documents this table.
const std::map<std::string, Library>& libraries() {
  static const std::map<std::string, Library> table = {
      {"base", {{}, {"", "text", "system", "io", "report"}}},
      {"proto", {}},
      {"soccer", {{"base"}, {"", "parameters", "protocol", "commands", "messages"}}},
      {"gamelog", {{"base", "soccer"}, {"record", "rcl", "rcg", "files"}}},
      {"league", {{"base", "soccer"}, {"rating", "competition", "matches", "schedule"}}},
      {"player",
       {{"base", "soccer"},
        {"simple_team", "formation", "world", "estimates", "tracking", "perception", "commands",
         "looking", "movement", "ball_skills", "planner", "behaviors", "options"}}},
      {"proxy",
       {{"base", "soccer", "proto", "player"},
        {"messages", "playmaker", "connection", "coach", "planner", "actions", "agent"}}},
      {"mock-server",
       {{"base", "soccer", "proto", "player"}, {"behavior", "script", "service", ""}}},
      {"analysis",
       {{"base", "soccer", "gamelog"},
        {"play", "measures", "situations", "results", "statistics", "tables"}}},
      {"simulator",
       {{"base", "soccer", "gamelog"},
        {"world", "referee", "rules", "motion", "actions", "", "senses", "replay", "sessions",
         "server"}}},
      {"viewer",
       {{"base", "soccer", "gamelog", "analysis"},
        {"stream", "decisions", "page", "live", "terminal", "charts", "report"}}},
      {"training",
       {{"base", "soccer", "gamelog", "player", "analysis", "simulator"},
        {"scene", "senses", "features", "skills", "actions", "npc", "policy", "tasks", "episode",
         "pool", "c_api"}}},
      {"process", {{"base"}, {}}},
      {"match",
       {{"base", "soccer", "proto", "gamelog", "player", "proxy", "mock-server", "analysis",
         "simulator", "viewer", "training", "process"},
        {"terms", "programs", "saved", "result", "server", "sides", "hooks", "replay", ""}}},
      {"review",
       {{"base", "soccer", "gamelog", "player", "analysis", "simulator", "training"}, {}}},
      {"playground", {below_playground(), {}}},
      {"tournament",
       {{"base", "soccer", "league", "viewer", "process", "match"},
        {"config", "slots", "store", "report", "site", "run", "dataset", "tuning"}}},
      {"scenario",
       {{"base", "soccer", "proto", "player", "proxy", "mock-server", "simulator", "viewer",
         "process", "match"},
        {}}},
      {"checks",
       {{"base", "soccer", "proto", "gamelog", "player", "proxy", "simulator", "process", "match"},
        {"", "playmaker", "server", "doctor"}}},
      {"cli",
       {below_cli(),
        {"terminal", "command", "support", "project", "explain", "shell", "logs", "check",
         "tournament", "match", ""}}},
      {"bench", {below_cli_and("tests"), {}}},
      {"packaging", {}},
      {"cmake", {}},
      {"tests", {everything(), {}}},
  };

  return table;
}

/// The layer of a file in its library: "world" for "simulator/world/player.h".
std::string layer_of(const std::string& library, const std::string& path) {
  const std::string inside = path.substr(library.size() + 1);
  const std::size_t slash = inside.rfind('/');
  return slash == std::string::npos ? "" : inside.substr(0, slash);
}

/// The error of an include within a library; empty if it is allowed.
std::string layer_error(const std::string& library, const std::string& from,
                        const std::string& to) {
  const std::vector<std::string>& layers = libraries().at(library).layers;
  if (layers.empty()) return "";
  const auto position = [&](const std::string& path) {
    return std::find(layers.begin(), layers.end(), layer_of(library, path));
  };
  for (const std::string& path : {from, to}) {
    if (position(path) != layers.end()) continue;
    return "sub-folder '" + layer_of(library, path) +
           "' is unknown; add it to libraries() in tests/architecture/rules.cpp";
  }
  if (position(from) >= position(to)) return "";
  return "layer '" + layer_of(library, from) + "' must not include the higher layer '" +
         layer_of(library, to) + "'";
}

/// Headers that some folders ("library" or "library/layer") must not include, except files whose
/// path starts with one of `except`.
struct ForbiddenHeader {
  Folders folders;
  std::vector<std::string> except;
  std::vector<std::string> headers;  ///< names, or prefixes that end in '/'
  std::string message;
};

const std::vector<ForbiddenHeader>& forbidden_headers() {
  static const std::vector<ForbiddenHeader> table = {
      {{"base", "soccer", "gamelog", "league", "player", "analysis", "simulator", "training",
        "viewer", "process"},
       {},
       {"grpc/", "grpcpp/", "grpc++/", "google/protobuf/"},
       "gRPC and protobuf do not belong in this folder"},
      {{"viewer", "cli", "match", "tournament"},
       {"viewer/live/http_server"},
       {"boost/asio/", "boost/asio.hpp", "boost/beast/", "boost/beast.hpp"},
       "HTTP belongs in viewer/live/http_server.cpp"},
      // Only the server drivers (UDP, real time) may use clocks, threads and sockets: files whose
      // path begins with simulator/server.
      {{"simulator"},
       {"simulator/server"},
       {"arpa/", "atomic", "boost/asio/", "boost/asio.hpp", "chrono", "condition_variable", "ctime",
        "future", "mutex", "netinet/", "poll.h", "pthread.h", "sys/epoll.h", "sys/select.h",
        "sys/socket.h", "sys/time.h", "thread", "time.h"},
       "no clocks, threads or sockets below simulator/server*"},
      {{"simulator"},
       {"simulator/server"},
       {"base/system/"},
       "no threads, sockets or host facts below simulator/server*"},
      {{"base", "soccer", "gamelog", "analysis", "simulator", "training", "player", "proxy",
        "mock-server"},
       {},
       {"math.h"},
       "include <cmath> for exact functions, soccer/math.h for the others"},
  };

  return table;
}

/// Code that some folders must not contain, except files whose path starts with one of `except`.
struct ForbiddenCode {
  Folders folders;
  std::vector<std::string> except;
  std::regex pattern;
  std::string message;
};

const std::vector<ForbiddenCode>& forbidden_code() {
  // Names qualified by anything but std, and members, are not those of the C library.
  static const std::string functions =
      "(sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|asinh|acosh|atanh|exp|exp2|expm1|log|log2|"
      "log10|log1p|pow|hypot|cbrt|erf|erfc|tgamma|lgamma)[fl]?";

  static const std::vector<ForbiddenCode> table = {
      {{"base", "soccer", "simulator", "training", "player", "proxy", "mock-server"},
       {"soccer/math.", "soccer/portable_math."},
       std::regex(R"((\bstd::|(^|[^\w:])::|(^|[^\w:.>])))" + functions + R"(\s*\()"),
       "last bits depend on the CPU; use soccer/math.h"},
      {{"base", "soccer", "simulator", "training", "player", "proxy", "mock-server"},
       {},
       std::regex(R"(\bstd::(\w+_distribution|random_device|shuffle|sample|generate_canonical)\b)"),
       "differs between libraries or runs; use the seeded streams of soccer/random.h"},
      {{"base", "soccer", "simulator", "training", "player", "proxy", "mock-server"},
       {},
       std::regex(R"((\bstd::|(^|[^\w:.>]))(rand|srand|random|drand48)\s*\()"),
       "hidden global state; use the seeded streams of soccer/random.h"},
      {{"simulator"},
       {"simulator/server"},
       std::regex(R"(\bstd::(chrono|thread|jthread|mutex|this_thread|async|atomic|time)\b)"),
       "no clocks or threads below simulator/server*"},
      {{"tests"},
       {"tests/support/"},
       std::regex(R"(\b(TempDir|temp_directory_path|tmpnam)\s*\()"),
       "shared between concurrent runs; use tests/support/temporary_folder.h"},
  };

  return table;
}

bool starts_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool applies(const Folders& folders, const std::vector<std::string>& except,
             const std::string& path) {
  const std::string library = library_of(path);
  const auto is_excepted = [&](const std::string& start) { return starts_with(path, start); };
  if (library.empty() || std::ranges::any_of(except, is_excepted)) return false;
  return folders.count(library) != 0 || folders.count(library + "/" + layer_of(library, path)) != 0;
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

const std::set<std::string>& known_libraries() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const auto& [library, unused] : libraries()) all.insert(library);
    return all;
  }();
  return names;
}

std::set<std::string> allowed_libraries(const std::string& library) {
  const auto found = libraries().find(library);
  if (found == libraries().end()) return {};
  std::set<std::string> allowed = found->second.may_include;
  allowed.insert(library);
  return allowed;
}

std::string library_of(const std::string& path) {
  for (std::size_t end = path.rfind('/'); end != std::string::npos && end > 0;
       end = path.rfind('/', end - 1)) {
    if (libraries().count(path.substr(0, end)) != 0) return path.substr(0, end);
  }
  return "";
}

std::vector<Violation> check_includes(const SourceFile& file) {
  std::vector<Violation> violations;
  const std::string library = library_of(file.path);
  if (library.empty()) {
    return {
        {file.path, 0, "unknown folder; add it to libraries() in tests/architecture/rules.cpp"}};
  }

  const std::set<std::string> allowed = allowed_libraries(library);
  for (const Include& include : includes_of(file.text)) {
    const std::string target = library_of(include.path);
    std::string error;
    if (target.empty()) {
      if (include.quoted) {
        error = "quoted includes are relative to the root of the repository";
      }
    } else if (allowed.count(target) == 0) {
      error = library + " must not include " + target;
    } else if (target == library) {
      error = layer_error(library, file.path, include.path);
    }
    if (!error.empty()) {
      violations.push_back({file.path, include.line, include.path + ": " + error});
    }
  }

  return violations;
}

std::vector<Violation> check_forbidden_headers(const SourceFile& file) {
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
    violations.push_back({file.path, 1, "first line must state the purpose: // ..."});
  }

  const bool is_main = file.path == "cli/main.cpp";
  const int limit = is_main ? kMaxMainLines - 1 : kMaxFileLines;
  if (static_cast<int>(lines.size()) > limit) {
    violations.push_back(
        {file.path, 0,
         std::to_string(lines.size()) + " lines; the maximum is " + std::to_string(limit)});
  }

  for (const Function& function : functions_of(file.text)) {
    if (function.length <= kMaxFunctionLines) continue;
    violations.push_back({file.path, function.line,
                          "a function of " + std::to_string(function.length) +
                              " lines; the maximum is " + std::to_string(kMaxFunctionLines)});
  }
  static const std::regex to_do(std::string("\\b(TO") + "DO|FIX" + "ME|X" + "XX)\\b");
  int number = 0;
  for (const std::string& line : lines) {
    ++number;
    if (std::regex_search(line, to_do)) {
      violations.push_back({file.path, number, "to-do comment; fix it or file an issue"});
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
      if (library_of(file.path) != "process") {
        violations.push_back({file.path, include.line, "Boost.Process belongs in process"});
      } else if (wrapper.empty()) {
        wrapper = file.path;
      } else if (wrapper != file.path) {
        violations.push_back({file.path, include.line, "Boost.Process belongs in " + wrapper});
      }
    }
  }
  return violations;
}

}  // namespace cls::tests
