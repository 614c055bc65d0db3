// Starts the script that makes the machines, and reads what agents have left.
#include "cli/project/package_check.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <regex>
#include <thread>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/byte_size.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/number_text.h"
#include "base/text/table.h"
#include "cli/project/project_files.h"
#include "cli/support/run_program.h"
#include "process/command_plan.h"
#include "process/process_host.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using base::Result;
using process::CommandPlan;
using Words = std::vector<std::string>;

constexpr int kAgents = 12;
constexpr std::chrono::seconds kStartLimit{150};  // all agents to join, and to leave
constexpr const char* kGroup = "cls-check-";      // of cgroups; the process follows
constexpr const char* kUnprivileged = "65534:65534";

std::string first_line_of(const fs::path& file) {
  const std::string text = base::read_file(file).value_or("");
  return text.substr(0, text.find('\n'));
}

std::string last_line_of(const fs::path& file) {
  std::string text = base::read_file(file).value_or("");
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// How this user may make namespaces: as root, or as root of a namespace of users.
Result<Words> namespace_command() {
  for (const char* program : {"ip", "unshare", "nsenter", "chroot", "taskset", "prlimit"}) {
    TRY(process::find_program(program));
  }
  Words words = {"unshare"};
  if (geteuid() != 0) words.push_back("--map-root-user");
  for (const char* word : {"--net", "--mount", "--pid", "--fork", "--kill-child", "--mount-proc",
                           "--propagation", "private"}) {
    words.emplace_back(word);
  }
  Words probe = words;
  for (const char* word : {"ip", "link", "add", "name", "probe", "type", "bridge"}) {
    probe.emplace_back(word);
  }
  TRY(run_program("network namespaces", probe));
  return words;
}

// Folders that the machines mount something on, and the version of the C library there.
Result<void> check_root(const fs::path& root) {
  for (const char* name : {"dev", "proc", "tmp", "mnt", "bin/sh"}) {
    if (const auto why = base::absence(root / name)) {
      return base::Error{
          fmt::format("{}: {}; --root needs the files of a Linux, as debootstrap makes them",
                      (root / name).string(), *why)};
    }
  }
  return {};
}

std::string c_library_of(const fs::path& root) {
  static const std::regex form("GNU C Library [^\n]* version ([0-9.]+[0-9])");
  for (const char* name : {"lib/x86_64-linux-gnu/libc.so.6", "usr/lib/x86_64-linux-gnu/libc.so.6",
                           "lib64/libc.so.6", "usr/lib64/libc.so.6"}) {
    const auto bytes = base::read_file(root / name);
    if (!bytes) continue;
    const std::size_t at = bytes->find("GNU C Library");
    std::smatch match;
    const std::string near = at == std::string::npos ? "" : bytes->substr(at, 200);
    if (std::regex_search(near, match, form)) return match[1];
  }
  return {};
}

CommandPlan competition_plan(const PackageCheckOptions& options, const fs::path& folder,
                             Words words) {
  words.insert(words.end(), {"sh", (folder / "competition").string()});
  CommandPlan plan;
  plan.name = "the machines";
  plan.argv = std::move(words);
  plan.folder = folder;
  plan.environment = {{"CLS", options.program.string()},
                      {"PACKAGE", fs::canonical(options.package).string()},
                      {"ROOT", fs::canonical(options.root).string()},
                      {"OUT", folder.string()},
                      {"CYCLES", fmt::to_string(options.cycles)},
                      {"MEMORY", fmt::to_string(options.memory)},
                      {"CPUS", fmt::to_string(options.cpus)},
                      {"CORES", fmt::to_string(std::max(1U, std::thread::hardware_concurrency()))},
                      {"GROUP", fmt::format("{}{}", kGroup, getpid())}};

  if (geteuid() == 0) plan.environment.push_back({"AS_USER", kUnprivileged});

  return plan;
}

// Empty groups stay until they are removed: those of this check, and of one that was killed.
void remove_groups() {
  for (const char* parent : {"/sys/fs/cgroup", "/sys/fs/cgroup/memory", "/sys/fs/cgroup/cpu"}) {
    std::error_code code;
    for (const auto& group : fs::directory_iterator(parent, code)) {
      const std::string name = group.path().filename().string();
      if (!name.starts_with(kGroup)) continue;
      const std::string pid = name.substr(std::string_view(kGroup).size());
      if (pid != fmt::to_string(getpid()) && fs::exists("/proc/" + pid)) continue;
      for (int unum = 1; unum <= kAgents; ++unum) {
        rmdir((group.path() / fmt::format("agent{}", unum)).c_str());
      }
      rmdir(group.path().c_str());
    }
  }
}

std::string limits_text(const PackageCheckOptions& options, const fs::path& folder) {
  const std::string kind = first_line_of(folder / "limits");
  const std::string size = base::byte_size_text(options.memory);
  if (kind.starts_with("cgroup")) {
    return fmt::format("{} of memory and {} processor{} an agent (cgroup {})", size, options.cpus,
                       options.cpus == 1 ? "" : "s", kind.back());
  }
  return fmt::format(
      "{} of data a process and one processor an agent (prlimit and taskset: this user "
      "cannot set cgroups)",
      size);
}

void read_player(const base::Json& player, int cycles, CheckedAgent& agent) {
  const auto undecided = player.at("undecided").get<std::int64_t>();
  agent.decisions = player.at("decisions").get<std::int64_t>();
  // Before its first decision an agent counts no cycles; with the clock stopped it has more of
  // them.
  const std::int64_t before = std::max<std::int64_t>(0, cycles - agent.decisions - undecided);
  agent.missed = before + undecided + player.at("missed").get<std::int64_t>();
  agent.late_commands = player.at("lost_commands").get<std::int64_t>();
  agent.p99_ms = player.at("rpc_us").at("p99").get<double>() / 1000.0;
}

// Why an agent has not finished: as cls says it, else the last line of the start script.
std::string end_of(const fs::path& place, const base::Json& document) {
  if (document.is_object() && document.value("message", base::Json()).is_string()) {
    return document["message"].get<std::string>();
  }
  const std::string code = first_line_of(place / "exit");
  const std::string line = last_line_of(place / "output");
  return fmt::format("{}{}", code.empty() ? "did not end" : "exit code " + code,
                     line.empty() ? "" : ": " + line);
}

CheckedAgent read_agent(int unum, int cycles, const fs::path& place) {
  CheckedAgent agent;
  agent.unum = unum;
  if (const auto peak = base::parse_number(first_line_of(place / "memory"))) {
    agent.memory = static_cast<std::uint64_t>(*peak);
  }

  const auto text = base::read_file(place / "tmp/result.json");
  const auto document = base::Json::parse_or_discarded(text.value_or(""));
  try {
    // A server that has reached its last cycle exits, and may be gone before an agent hears the
    // end.
    agent.finished = !document.is_discarded() && (document.at("end_reason") == "finished" ||
                                                  document.at("cycles").get<int>() >= cycles - 1);
    if (!document.is_discarded() && !document.at("players").empty()) {
      read_player(document.at("players").front(), document.at("cycles").get<int>(), agent);
    }
  } catch (const base::Json::exception& error) {
    agent.problem = error.what();
  }

  if (!agent.finished) {
    agent.problem = end_of(place, document);
  } else if (unum < kAgents && agent.decisions == 0) {
    agent.problem = "no decision";
  } else if (static_cast<double>(agent.missed) >
             kMaxMissedShare * static_cast<double>(agent.decisions + agent.missed)) {
    agent.problem = fmt::format("more than {:.0f} % missed", 100.0 * kMaxMissedShare);
  }

  return agent;
}

std::string who(const CheckedAgent& agent) {
  return agent.unum == kAgents ? "coach" : fmt::to_string(agent.unum);
}

}  // namespace

bool PackageCheck::passed() const {
  return skipped.empty() && problem.empty() &&
         std::ranges::all_of(agents,
                             [](const CheckedAgent& agent) { return agent.problem.empty(); });
}

Result<PackageCheck> check_package(const PackageCheckOptions& options,
                                   const std::atomic<int>& stop) {
  PackageCheck check;
  if (const auto why = base::why_no_file(options.package / "start")) {
    return base::Error{fmt::format("{}: {}; cls package-team without --check writes it",
                                   (options.package / "start").string(), *why)};
  }
  TRY(check_root(options.root));
  check.busy = base::busy_host();
  check.own_files = fs::equivalent(options.root, "/");
  check.c_library = c_library_of(options.root);
  auto words = namespace_command();
  if (!words) {
    check.skipped = words.error().message;
    return check;
  }

  const fs::path& folder = options.folder;
  fs::permissions(folder, fs::perms(0755));
  for (const char* script : {"competition", "machine"}) {
    TRY(base::write_file(folder / script,
                         embedded_file(fmt::format("cli/project/league/{}", script))));
  }

  TRY_INIT(auto host, process::ProcessHost::create());
  TRY_INIT(const auto child, host.start(competition_plan(options, folder, *std::move(words))));
  const auto limit = kStartLimit + std::chrono::milliseconds(options.cycles * 120);
  const auto ended = process::wait_until_ready(
      *child, [] { return false; }, limit, stop);
  host.end_all(std::chrono::milliseconds(500));
  remove_groups();

  check.limits = limits_text(options, folder);
  if (ended == process::Readiness::kTimedOut) {
    check.problem = fmt::format("not over after {} s: {}", limit / std::chrono::seconds(1),
                                last_line_of(folder / "server.log"));
  } else if (const std::string code = first_line_of(folder / "server.exit"); code != "0") {
    const auto lines = child->last_lines(1);
    check.problem = fmt::format("the server: {}", code.empty() && !lines.empty()
                                                      ? lines.front()
                                                      : last_line_of(folder / "server.log"));
  }

  for (int unum = 1; unum <= kAgents; ++unum) {
    check.agents.push_back(read_agent(unum, options.cycles, folder / fmt::format("agent{}", unum)));
  }

  return check;
}

std::string to_text(const PackageCheckOptions& options, const PackageCheck& check) {
  if (!check.skipped.empty()) {
    return fmt::format("skipped: twelve machines: {}\n", check.skipped);
  }

  using Align = base::Table::Align;
  base::Table table;
  table.add_column("agent");
  table.add_columns({"decisions", "missed", "late commands", "p99 ms", "memory MB"}, Align::kRight);
  table.add_column("");
  for (const CheckedAgent& agent : check.agents) {
    const bool player = agent.unum < kAgents;
    const auto count = [player](std::int64_t value) {
      return player ? fmt::to_string(value) : std::string("-");
    };
    table.add_row(
        {who(agent), count(agent.decisions), count(agent.missed), count(agent.late_commands),
         player ? fmt::format("{:.1f}", agent.p99_ms) : "-",
         agent.memory ? fmt::format("{:.0f}", static_cast<double>(*agent.memory) / 1e6) : "-",
         agent.problem.empty() ? "ok" : agent.problem});
  }

  std::string text = fmt::format(
      "{}: {} cycles at 10 Hz, twelve machines, {}{}\n{}\n", options.package.string(),
      options.cycles,
      check.own_files ? "the files of this host" : "the files of " + options.root.string(),
      check.c_library.empty() ? "" : " (glibc " + check.c_library + ")", check.limits);
  if (check.own_files) text += "an older C library needs --root DIR with its files\n";
  text += table.format_text();
  if (!check.problem.empty()) text += check.problem + "\n";
  if (!check.busy.empty()) text += check.busy + ": missed cycles are those of the host\n";
  text += check.passed() ? "passed\n" : "failed\n";

  return text;
}

std::string to_json(const PackageCheckOptions& options, const PackageCheck& check) {
  using base::Json;
  const auto text_or_null = [](const std::string& text) {
    return text.empty() ? Json() : Json(text);
  };

  Json agents = Json::array();
  for (const CheckedAgent& agent : check.agents) {
    agents.push_back({{"agent", who(agent)},
                      {"finished", agent.finished},
                      {"problem", text_or_null(agent.problem)},
                      {"decisions", agent.decisions},
                      {"missed", agent.missed},
                      {"late_commands", agent.late_commands},
                      {"p99_ms", agent.p99_ms},
                      {"memory_bytes", agent.memory ? Json(*agent.memory) : Json()}});
  }

  const Json document = {{"schema", "cls.package-check/1"},
                         {"package", options.package.string()},
                         {"root", options.root.string()},
                         {"glibc", text_or_null(check.c_library)},
                         {"cycles", options.cycles},
                         {"passed", check.passed()},
                         {"skipped", text_or_null(check.skipped)},
                         {"problem", text_or_null(check.problem)},
                         {"limits", text_or_null(check.limits)},
                         {"busy", text_or_null(check.busy)},
                         {"agents", agents}};
  return base::json_document(document);
}

}  // namespace cls::cli
