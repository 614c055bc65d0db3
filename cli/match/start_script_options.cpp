// Tables of the options.
#include "cli/match/start_script_options.h"

#include <fmt/format.h>
#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <memory>

#include "base/io/whole_file.h"
#include "proto/playmaker.pb.h"

namespace cls::cli {
namespace {

using match::StandaloneTeamOptions;

constexpr const char* kLogGroup =
    "Logs for soccerwindow2, as the framework's start scripts name them";
constexpr const char* kCategoryGroup = "Categories of the debug log (default: all)";
constexpr const char* kRefusedGroup = "Refused, with the way to do it here";
constexpr int kMaxDebugPort = 65535;

struct Refused {
  const char* name;
  const char* reason;
};

constexpr std::array kRefused = {
    Refused{"--offline-client-mode",
            "cls proxy plays on a server only; record a match with cls match --record-rpc FILE and "
            "repeat its calls with cls test --replay FILE"},
    Refused{"--goalie", "one process for each player is --unum 1 here"},
    Refused{"--player", "one process for each player is --unum N here"},
    Refused{"--use-random-rpc-port",
            "cls proxy starts no Playmaker; 'run:COMMAND --port {port}' of cls match starts one on "
            "a free port"},
    Refused{"--auto-close-rpc-server",
            "cls proxy starts no Playmaker; cls match ends the one that run:COMMAND starts"},
};

// An option that has a meaning only with one of others.
struct Dependent {
  const char* name;
  std::array<const char*, 3> needs;
};

constexpr std::array kDependents = {
    Dependent{"--debug-server-host", {"--debug-server-connect"}},
    Dependent{"--debug-server-port", {"--debug-server-connect"}},
    Dependent{"--debug-start-time", {"--debug", "--debug-log"}},
    Dependent{"--debug-end-time", {"--debug", "--debug-log"}},
    Dependent{"--debug-log-ext", {"--debug", "--debug-log"}},
    Dependent{"--log-dir", {"--debug", "--debug-server-logging", "--offline-logging"}},
};

bool is_given(const Command& command, std::string_view name) {
  return std::ranges::any_of(command.options, [&](const Option& option) {
    return name_of(option) == name && !option.given.empty();
  });
}

// "--debug_action_chain" of ACTION_CHAIN.
std::string category_option(std::string_view level) {
  std::string name = "--debug_";
  for (const char c : level) name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

// Those of the interface, in the order of their bits.
std::vector<const google::protobuf::EnumValueDescriptor*> levels() {
  std::vector<const google::protobuf::EnumValueDescriptor*> all;
  const auto* type = protos::LoggerLevel_descriptor();
  for (int i = 0; i < type->value_count(); ++i) {
    if (type->value(i)->number() != 0) all.push_back(type->value(i));
  }
  return all;
}

std::uint32_t chosen_levels(const Command& command) {
  std::uint32_t chosen = 0;
  for (const auto* level : levels()) {
    if (is_given(command, category_option(level->name()))) {
      chosen |= static_cast<std::uint32_t>(level->number());
    }
  }
  return chosen != 0 ? chosen : proxy::DebugOptions().levels;
}

void add_log_options(Command& command, StartScriptValues& values) {
  const auto option = [&command](const char* name, auto& target, const char* help) -> Option& {
    return command.option(name, target, help).of_group(kLogGroup);
  };
  const auto flag = [&command](const char* name, bool& target, const char* help) {
    command.flag(name, target, help).of_group(kLogGroup);
  };

  flag("--debug", values.debug, "--debug-log in --log-dir");
  option("--log-dir", values.log_dir, "folder of these logs").placeholder("DIR").shows_default();
  option("--debug-log-ext", values.debug_log_ext, "end of the names of debug logs")
      .placeholder("EXTENSION")
      .shows_default();

  option("--debug-start-time", values.debug_start_time, "first cycle of debug logs")
      .placeholder("CYCLE")
      .shows_default();

  option("--debug-end-time", values.debug_end_time, "last cycle of debug logs")
      .placeholder("CYCLE")
      .shows_default();

  flag("--debug-server-connect", values.debug_server_connect,
       "--debug-server at the next two options");
  option("--debug-server-host", values.debug_server_host,
         "host of the debug server (default: --host)")
      .placeholder("HOST");
  option("--debug-server-port", values.debug_server_port,
         "port of the debug server (default: --port + 32)")
      .range(1, kMaxDebugPort);
  flag("--debug-server-logging", values.debug_server_logging, "--debug-server-log in --log-dir");
  flag("--offline-logging", values.offline_logging,
       "write the server's messages into TEAM-NUMBER.ocl in --log-dir");
}

std::string folder_error(std::string_view option, const std::string& folder) {
  const auto why = base::why_no_folder(folder);
  return why ? fmt::format("{} '{}': {}", option, folder, *why) : std::string();
}

void set_debug_server(const StartScriptValues& values, StandaloneTeamOptions& options,
                      std::vector<std::string>& errors) {
  const std::string host =
      values.debug_server_host.empty() ? options.server_host : values.debug_server_host;
  const int port = values.debug_server_port != 0 ? values.debug_server_port
                                                 : options.server_port + kDebugPortOffset;
  const bool bare_ipv6 = host.find(':') != std::string::npos && host.front() != '[';
  const auto set = proxy::set_debug_server(
      options.debug,
      fmt::format("{}{}{}:{}", bare_ipv6 ? "[" : "", host, bare_ipv6 ? "]" : "", port));
  if (!set) errors.push_back("--" + set.error().message);
}

}  // namespace

void add_start_script_options(Command& command, StartScriptValues& values) {
  command
      .setting("--fullstate", values.fullstate,
               "full state of a server that sends it: ignore; reference: in full_world_model of "
               "State; override: players decide on it")
      .one_of({"ignore", "reference", "override"})
      .placeholder("WHAT");

  command
      .option("--team-graphic", values.team_graphic,
              "X PixMap that the coach shows, at most 256 x 64 pixels")
      .placeholder("FILE");
  add_log_options(command, values);

  for (const auto* level : levels()) {
    command.flag(category_option(level->name()), "texts and shapes of this level")
        .of_group(kCategoryGroup);
  }
  for (const Refused& one : kRefused) command.flag(one.name, one.reason).of_group(kRefusedGroup);
}

std::vector<std::string> apply_start_script_options(const Command& command,
                                                    const StartScriptValues& values,
                                                    StandaloneTeamOptions& options) {
  std::vector<std::string> errors;
  for (const Refused& one : kRefused) {
    if (is_given(command, one.name)) errors.push_back(fmt::format("{}: {}", one.name, one.reason));
  }

  const bool logs = values.debug || values.debug_server_logging || values.offline_logging;
  if (const std::string error = folder_error("--log-dir", values.log_dir); logs && !error.empty()) {
    errors.push_back(error);
  }

  if (values.debug) options.debug.log_folder = values.log_dir;
  if (values.debug_server_logging) options.debug.view_folder = values.log_dir;
  if (values.offline_logging) options.offline_log = values.log_dir;
  if (values.debug_server_connect) set_debug_server(values, options, errors);
  options.debug.log_extension = values.debug_log_ext;
  options.debug.first_cycle = values.debug_start_time;
  options.debug.last_cycle = values.debug_end_time;
  options.debug.levels = chosen_levels(command);
  options.team.full_state = *proxy::parse_full_state_use(values.fullstate);

  if (!values.team_graphic.empty()) {
    if (auto graphic = proxy::read_team_graphic(values.team_graphic)) {
      options.team.graphic = std::make_shared<const proxy::TeamGraphic>(*std::move(graphic));
    } else {
      errors.push_back("--team-graphic " + graphic.error().message);
    }
  }
  return errors;
}

std::vector<std::string> start_script_warnings(const Command& command) {
  std::vector<std::string> lines;
  for (const Dependent& one : kDependents) {
    if (!is_given(command, one.name)) continue;
    std::vector<std::string_view> needs;
    for (const char* name : one.needs) {
      if (name != nullptr) needs.emplace_back(name);
    }
    const bool useful =
        std::ranges::any_of(needs, [&](std::string_view name) { return is_given(command, name); });
    if (useful) continue;
    lines.push_back(fmt::format("{} has no effect without {}", one.name, fmt::join(needs, " or ")));
  }

  for (const auto* level : levels()) {
    const std::string name = category_option(level->name());
    const bool useful =
        is_given(command, "--debug") || is_given(command, "--debug-log") ||
        is_given(command, "--debug-server") || is_given(command, "--debug-server-connect") ||
        is_given(command, "--debug-server-log") || is_given(command, "--debug-server-logging");
    if (is_given(command, name) && !useful) {
      lines.push_back(fmt::format("{} has no effect without --debug", name));
    }
  }

  return lines;
}

}  // namespace cls::cli
