// The tables of arrows and of forbidden things, and the loops that hold a file against them.
#include "tests/architecture/rules.h"

#include <algorithm>
#include <map>
#include <regex>

namespace cls::tests {
namespace {

using Folders = std::set<std::string>;

/// A folder with a library of its own. Its sub-folders are layers: a file may include files of its
/// own layer and of the layers listed before it. "" is the folder itself.
struct Room {
  Folders may_include;              ///< rooms below it; a room may always include itself
  std::vector<std::string> layers;  ///< lowest first; empty: no sub-folders
};

/// All rooms, lowest first; docs/architecture.md has the same table for people.
const std::map<std::string, Room>& rooms() {
  static const std::map<std::string, Room> table = {
      {"base", {{}, {"", "text", "io", "system", "report"}}},
      {"proto", {}},
      {"soccer", {{"base"}, {"", "parameters", "protocol", "commands", "messages"}}},
      {"gamelog", {{"base", "soccer"}, {"record", "rcl", "rcg", "files"}}},
      {"proxy",
       {{"base", "soccer", "proto"},
        {"formation", "world", "estimates", "tracking", "perception", "commands", "messages",
         "playmaker", "looking", "movement", "ball_skills", "connection", "coach", "planner",
         "behaviors", "actions", "agent"}}},
      {"mock-server", {{"base", "soccer", "proto"}, {"", "script", "simple_team"}}},
      {"analysis", {{"base", "soccer", "gamelog"}, {"play", "measures", "results", "statistics"}}},
      {"simulator",
       {{"base", "soccer", "gamelog"},
        {"world", "referee", "rules", "motion", "actions", "", "senses", "replay", "sessions",
         "server"}}},
      {"viewer", {{"base", "soccer", "gamelog", "analysis"}, {}}},
      {"training",
       {{"base", "soccer", "proto", "gamelog", "proxy", "mock-server", "simulator"}, {}}},
      {"orchestration/process", {{"base"}, {}}},
      {"orchestration/match",
       {{"base", "soccer", "proto", "gamelog", "proxy", "mock-server", "analysis", "simulator",
         "viewer", "orchestration/process"},
        {"options", "result", "server", "sides", "hooks", ""}}},
      {"orchestration/tournament",
       {{"base", "soccer", "viewer", "orchestration/process", "orchestration/match"},
        {"rating", "config", "schedule", "store", "report", "run"}}},
      {"orchestration/scenario",
       {{"base", "soccer", "proto", "proxy", "mock-server", "simulator", "viewer",
         "orchestration/process", "orchestration/match"},
        {}}},
      {"orchestration/checks",
       {{"base", "soccer", "proto", "gamelog", "proxy", "simulator", "orchestration/process",
         "orchestration/match"},
        {"", "playmaker", "server", "doctor"}}},
      {"cli",
       {{"base", "soccer", "proto", "gamelog", "proxy", "mock-server", "analysis", "simulator",
         "viewer", "training", "orchestration/process", "orchestration/match",
         "orchestration/tournament", "orchestration/scenario", "orchestration/checks"},
        {"support", "terminal", "logs", "check", "tournament", "match", ""}}},
      {"bench",
       {{"base", "soccer", "proto", "gamelog", "proxy", "mock-server", "analysis", "simulator",
         "viewer", "training", "orchestration/process", "orchestration/match",
         "orchestration/tournament", "orchestration/scenario", "orchestration/checks", "tests"},
        {}}},
      {"tests",
       {{"base", "soccer", "proto", "gamelog", "proxy", "mock-server", "analysis", "simulator",
         "viewer", "training", "orchestration/process", "orchestration/match",
         "orchestration/tournament", "orchestration/scenario", "orchestration/checks", "cli"},
        {}}},
  };
  return table;
}

/// The layer of a file in its room: "world" for "simulator/world/player.h".
std::string layer_of(const std::string& room, const std::string& path) {
  const std::string inside = path.substr(room.size() + 1);
  const std::size_t slash = inside.rfind('/');
  return slash == std::string::npos ? "" : inside.substr(0, slash);
}

/// What is wrong with an include from one file of a room to another; empty: nothing.
std::string layer_fault(const std::string& room, const std::string& from, const std::string& to) {
  const std::vector<std::string>& layers = rooms().at(room).layers;
  if (layers.empty()) return "";
  const auto position = [&](const std::string& path) {
    return std::find(layers.begin(), layers.end(), layer_of(room, path));
  };
  if (position(from) == layers.end()) return "a new sub-folder: give it its place in rooms()";
  if (position(to) == layers.end()) return "includes a sub-folder without a place in rooms()";
  if (position(from) >= position(to)) return "";
  return layer_of(room, from) + " must not include " + layer_of(room, to) + ", a layer above it";
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
      {{"base", "soccer", "gamelog", "analysis", "simulator", "viewer", "orchestration/process"},
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
      {{"simulator"},
       "simulator/server",
       {"base/system/"},
       "no threads, sockets or host facts below simulator/server*"},
      {{"base", "soccer", "gamelog", "analysis", "simulator", "proxy", "mock-server"},
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
      {{"base", "soccer", "simulator", "proxy", "mock-server"},
       "soccer/math.",
       std::regex(R"((\bstd::|(^|[^\w:])::|(^|[^\w:.>])))" + functions + R"(\s*\()"),
       "its last bits depend on the processor: use soccer/math.h"},
      {{"base", "soccer", "simulator", "proxy", "mock-server"},
       "",
       std::regex(R"(\bstd::(\w+_distribution|random_device|shuffle|sample|generate_canonical)\b)"),
       "differs between libraries or runs: use the seeded streams of soccer/random.h"},
      {{"base", "soccer", "simulator", "proxy", "mock-server"},
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
  return folders.count(room_of(path)) != 0 && (except.empty() || !starts_with(path, except));
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

const std::set<std::string>& known_rooms() {
  static const std::set<std::string> names = [] {
    std::set<std::string> all;
    for (const auto& [room, unused] : rooms()) all.insert(room);
    return all;
  }();
  return names;
}

std::set<std::string> allowed_rooms(const std::string& room) {
  const auto found = rooms().find(room);
  if (found == rooms().end()) return {};
  std::set<std::string> allowed = found->second.may_include;
  allowed.insert(room);
  return allowed;
}

std::string room_of(const std::string& path) {
  for (std::size_t end = path.rfind('/'); end != std::string::npos && end > 0;
       end = path.rfind('/', end - 1)) {
    if (rooms().count(path.substr(0, end)) != 0) return path.substr(0, end);
  }
  return "";
}

std::vector<Violation> check_arrows(const SourceFile& file) {
  std::vector<Violation> violations;
  const std::string room = room_of(file.path);
  if (room.empty()) {
    return {{file.path, 0, "a new folder: give it its place in tests/architecture/rules.cpp"}};
  }
  const std::set<std::string> allowed = allowed_rooms(room);
  for (const Include& include : includes_of(file.text)) {
    const std::string target = room_of(include.path);
    std::string fault;
    if (target.empty()) {
      if (include.quoted) {
        fault = "quotes are for headers of this project, written from the root of the repository";
      }
    } else if (allowed.count(target) == 0) {
      fault = room + " must not include " + target;
    } else if (target == room) {
      fault = layer_fault(room, file.path, include.path);
    }
    if (!fault.empty()) {
      violations.push_back({file.path, include.line, include.path + ": " + fault});
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
      if (room_of(file.path) != "orchestration/process") {
        violations.push_back(
            {file.path, include.line, "Boost.Process belongs in orchestration/process"});
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
