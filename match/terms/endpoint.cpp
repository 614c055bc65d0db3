// Parses SIDE arguments and derives team names from them.
#include "match/terms/endpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/io/home_path.h"
#include "base/io/whole_file.h"
#include "base/text/number_text.h"
#include "base/text/suggestion.h"
#include "match/terms/host_name.h"
#include "match/terms/learned_policy.h"
#include "match/terms/mixed_side.h"
#include "match/terms/planner_file.h"
#include "match/terms/run_command.h"
#include "mock-server/mock.h"
#include "proto/rpc.h"
#include "soccer/protocol/team_name.h"
#include "soccer/protocol/team_names.h"
#include "training/policy/policy.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;

constexpr int kMaxPort = 65535;
constexpr std::size_t kMaxSocketPath = 107;
constexpr std::string_view kPlannerForm = "planner:";
constexpr std::string_view kEachForm = "each:";
constexpr int kMaxPortStep = 13;
constexpr std::string_view kCoachOfPolicies = "planner";
constexpr std::string_view kLearnedSide = "mock:learned";
constexpr std::string_view kLearned = "learned";  // its policy_file

Error wrong(std::string_view side, std::string_view what) {
  return Error{fmt::format("side '{}': {}", side, what)};
}

// "python3 team.py" for "team.py"; empty for what is not a script.
std::string command_of_script(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kPrograms[] = {
      {".py", "python3 "}, {".js", "node "}, {".mjs", "node "}, {".sh", "sh "}};
  for (const auto& [ending, program] : kPrograms) {
    if (text.ends_with(ending)) return fmt::format("{}{}", program, text);
  }
  return text.starts_with("./") ? std::string(text) : "";
}

Error unknown_form(std::string_view text) {
  std::string message = fmt::format("unknown side '{}'", text);
  const std::string_view near = base::nearest_name(text, {"mock", "mock:hold"});

  if (text.ends_with(".json")) {
    message += fmt::format("; did you mean 'mock:{}'?", text);
  } else if (text.find("{port}") != std::string_view::npos) {
    message += fmt::format("; did you mean 'run:{}'?", text);
  } else if (const std::string command = command_of_script(text); !command.empty()) {
    message += fmt::format("; did you mean 'run:{} --port {{port}}'?", command);
  } else if (!near.empty()) {
    message += fmt::format("; did you mean '{}'?", near);
  } else if (text == "localhost" || base::parse_int(text)) {  // half of HOST:PORT
    message += fmt::format("; did you mean 'localhost:{}'?", text == "localhost" ? "50051" : text);
  }
  message +=
      " (a side is mock, mock:BEHAVIOR, mock:FILE.json, HOST:PORT, HOST:PORT+step, "
      "tls:HOST:PORT, unix:PATH, run:COMMAND, team:DIR, policy:FILE, mix:AGENTS=SIDE;..., "
      "each:run:COMMAND or planner:FILE=SIDE)";
  return Error{std::move(message)};
}

Endpoint endpoint_of_kind(Endpoint::Kind kind, std::string_view text) {
  Endpoint endpoint;
  endpoint.kind = kind;
  endpoint.text = text;
  return endpoint;
}

// "HOST:PORT" of a side that is written as `side`.
Result<Endpoint> parse_address(std::string_view text, std::string_view side) {
  if (text.find("://") != std::string_view::npos) {
    return wrong(side,
                 host_problem(text) + (text.starts_with("https") ? ", or tls:HOST:PORT" : ""));
  }

  const std::size_t colon = text.rfind(':');
  Endpoint endpoint = endpoint_of_kind(Endpoint::Kind::kAddress, text);
  endpoint.host = text.substr(0, colon);
  std::string_view port = text.substr(colon + 1);
  if (const std::size_t plus = port.find('+'); plus != std::string_view::npos) {
    if (port.substr(plus) != "+step") return unknown_form(text);
    endpoint.port_step = true;
    port = port.substr(0, plus);
  }

  const std::optional<int> number = base::parse_int(port);
  if (!number || port.starts_with('+')) return unknown_form(text);
  endpoint.port = *number;
  const int highest = endpoint.port + (endpoint.port_step ? kMaxPortStep : 0);
  if (endpoint.port < 1 || highest > kMaxPort) {
    return wrong(side, fmt::format("port {} is not within 1 to 65535", port));
  }
  const std::string problem = host_problem(endpoint.host);
  if (!problem.empty()) return wrong(side, problem);
  return endpoint;
}

Result<Endpoint> parse_mixed(std::string_view text) {
  const auto parts = parse_mixed_side(text.substr(4));
  if (!parts) return wrong(text, parts.error().message);

  Endpoint endpoint = endpoint_of_kind(Endpoint::Kind::kMixed, text);
  for (const MixedPart& part : *parts) {
    auto parsed = parse_endpoint(part.side);
    if (!parsed) return wrong(text, parsed.error().message);
    if (!parsed->planner_file.empty()) {
      return wrong(text, "planner:FILE= applies to the whole team; write it before mix:");
    }
    if (!parsed->policy_file.empty()) return wrong(text, "a policy plays for a whole team");
    if (!parsed->parts.empty()) return wrong(text, fmt::format("'{}' cannot be a part", part.side));

    parsed->label = part.label;
    parsed->agents = part.agents;
    endpoint.parts.push_back(*std::move(parsed));
  }

  const auto teams = std::ranges::count(endpoint.parts, false, &Endpoint::has_playmaker);
  if (teams == 0) return endpoint;
  if (teams != std::ssize(endpoint.parts)) {
    return wrong(text, "external teams and Playmakers do not play in one team");
  }
  endpoint.kind = Endpoint::Kind::kTeam;
  return endpoint;
}

// "each:run:COMMAND": a part for each agent.
Result<Endpoint> parse_each(std::string_view text) {
  auto agent = parse_endpoint(text.substr(kEachForm.size()));
  if (!agent) return wrong(text, agent.error().message);
  if (agent->kind != Endpoint::Kind::kRun) return wrong(text, "must be each:run:COMMAND");

  Endpoint endpoint = endpoint_of_kind(Endpoint::Kind::kMixed, text);
  for (int number = 1; number <= proto::kCoachNumber; ++number) {
    agent->label = number == proto::kCoachNumber ? "coach" : fmt::format("{}", number);
    agent->agents = {number};
    endpoint.parts.push_back(*agent);
  }
  return endpoint;
}

// "teams/helios/" is "helios", "." the name of the working directory.
std::string folder_name(const std::string& path) {
  std::error_code code;
  const std::filesystem::path whole = std::filesystem::absolute(path, code).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

// "ada" of "cd ada && ./run --port {port}", "playmaker" of "python3 playmaker.py".
std::string name_of_command(const std::string& command) {
  const std::string program = program_in(command);
  return program.empty() ? folder_name(folder_in(command)) : program;
}

// The name of the command of all parts of an `each:` side; empty: another side.
std::string name_of_all(const Endpoint& endpoint) {
  const std::vector<Endpoint>& parts = endpoint.parts;
  const bool same = !parts.empty() && std::ranges::all_of(parts, [&](const Endpoint& one) {
    return !one.command.empty() && one.command == parts.front().command;
  });
  return same ? name_of_command(parts.front().command) : std::string();
}

// "RED+BLUE", shortened where needed.
std::string name_of_teams(const Endpoint& endpoint) {
  std::vector<std::string> names;
  for (const Endpoint& part : endpoint.parts) {
    const std::string name = folder_name(part.path);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }

  const std::size_t share = (soccer::TeamName::kMaxSize + 1) / names.size() - 1;
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : "+") + name.substr(0, std::max<std::size_t>(share, 1));
  }
  return text.substr(0, soccer::TeamName::kMaxSize);
}

Result<Endpoint> parse_with_planner(std::string_view text) {
  const std::size_t equals = text.find('=');
  auto endpoint = parse_endpoint(text.substr(equals + 1));
  if (!endpoint) return wrong(text, endpoint.error().message);
  if (!endpoint->has_playmaker())
    return wrong(text, "an external team does not use the planner of cls");
  if (!endpoint->planner_file.empty()) return wrong(text, "planner:FILE= may be given once");

  endpoint->planner_file =
      base::expand_home(text.substr(kPlannerForm.size(), equals - kPlannerForm.size()));
  if (endpoint->planner_file.empty()) return wrong(text, "no file after 'planner:'");
  endpoint->text = text;
  return endpoint;
}

bool has_script(const Endpoint& endpoint) {
  return endpoint.kind == Endpoint::Kind::kMock && endpoint.script == nullptr &&
         mock_server::is_script_name(endpoint.behavior);
}

// A name of any characters.
std::string described_team(const Endpoint& endpoint) {
  using std::filesystem::path;
  switch (endpoint.kind) {
    case Endpoint::Kind::kMock:
      if (!endpoint.policy_file.empty()) return path(endpoint.policy_file).stem().string();
      return endpoint.behavior.empty() ? "mock" : path(endpoint.behavior).stem().string();
    case Endpoint::Kind::kAddress:
      return fmt::format("{}_{}", endpoint.host, endpoint.port);
    case Endpoint::Kind::kUnixSocket:
      return path(endpoint.path).stem().string();
    case Endpoint::Kind::kRun:
      return name_of_command(endpoint.command);
    case Endpoint::Kind::kTeam:
      return endpoint.parts.empty() ? folder_name(endpoint.path) : name_of_teams(endpoint);
    case Endpoint::Kind::kMixed:
      break;
  }
  const std::string name = name_of_all(endpoint);
  return name.empty() ? "mix" : name;
}

Result<std::shared_ptr<const training::Policy>> policy_of(const std::string& name) {
  if (name != kLearned) return training::read_policy(name);
  TRY_INIT(auto policy, training::parse_policy(learned_policy(), std::string(kLearnedSide)));
  return std::make_shared<const training::Policy>(std::move(policy));
}

/// A form that is a name or a path after a prefix.
struct SimpleForm {
  std::string_view prefix;
  Endpoint::Kind kind;
  std::string Endpoint::*member;
  std::string_view what;
};

constexpr SimpleForm kSimpleForms[] = {
    {"mock:", Endpoint::Kind::kMock, &Endpoint::behavior, "behavior"},
    {"policy:", Endpoint::Kind::kMock, &Endpoint::policy_file, "file"},
    {"unix:", Endpoint::Kind::kUnixSocket, &Endpoint::path, "path"},
    {"team:", Endpoint::Kind::kTeam, &Endpoint::path, "folder"},
};

}  // namespace

Result<Endpoint> parse_endpoint(std::string_view text) {
  using Kind = Endpoint::Kind;
  constexpr std::string_view kTls = "tls:";
  if (text == "mock") return endpoint_of_kind(Kind::kMock, text);
  if (text == kLearnedSide) {
    Endpoint endpoint = endpoint_of_kind(Kind::kMock, text);
    endpoint.behavior = kCoachOfPolicies;
    endpoint.policy_file = kLearned;
    return endpoint;
  }

  for (const SimpleForm& form : kSimpleForms) {
    if (!text.starts_with(form.prefix)) continue;
    Endpoint endpoint = endpoint_of_kind(form.kind, text);
    endpoint.*form.member = base::expand_home(text.substr(form.prefix.size()));
    if ((endpoint.*form.member).empty()) {
      return wrong(text, fmt::format("no {} after the colon", form.what));
    }
    if (!endpoint.policy_file.empty()) endpoint.behavior = kCoachOfPolicies;
    if (form.kind == Kind::kUnixSocket && endpoint.path.size() > kMaxSocketPath) {
      return wrong(text, fmt::format("the path of a socket has at most {} bytes, this one {}",
                                     kMaxSocketPath, endpoint.path.size()));
    }
    return endpoint;
  }

  if (text.starts_with(kTls)) {
    if (text.find(':', kTls.size()) == std::string_view::npos) {
      return wrong(text, "must be tls:HOST:PORT");
    }
    TRY_INIT(auto secure, parse_address(text.substr(kTls.size()), text));
    secure.text = text;
    secure.tls = std::make_shared<proxy::TlsFiles>();
    return secure;
  }
  if (text.starts_with("run:")) {
    Endpoint endpoint = endpoint_of_kind(Kind::kRun, text);
    endpoint.command = text.substr(4);
    const auto good = check_run_command(endpoint.command);
    if (!good) return wrong(text, good.error().message);
    return endpoint;
  }
  if (text.starts_with("mix:")) return parse_mixed(text);
  if (text.starts_with(kEachForm)) return parse_each(text);

  // Without "=" it is the port of a host of this name.
  if (text.starts_with(kPlannerForm) && text.find('=') != std::string_view::npos) {
    return parse_with_planner(text);
  }
  if (text.find(':') == std::string_view::npos) return unknown_form(text);
  return parse_address(text, text);
}

bool Endpoint::starts_programs() const {
  return kind == Kind::kRun || kind == Kind::kTeam ||
         std::ranges::any_of(parts, &Endpoint::starts_programs);
}

bool Endpoint::is_built_in() const {
  const bool mixed = kind == Kind::kMixed && std::ranges::all_of(parts, &Endpoint::is_built_in);
  return (kind == Kind::kMock || mixed) && planner_file.empty() && !has_policy_file() &&
         !has_script(*this);
}

bool Endpoint::has_policy_file() const {
  return !policy_file.empty() && policy_file != kLearned &&
         !training::is_built_in_policy(policy_file);
}

Result<void> load_files(Endpoint& endpoint) {
  for (Endpoint& part : endpoint.parts) TRY(load_files(part));

  if (!endpoint.planner_file.empty() && endpoint.planner == nullptr) {
    TRY_INIT(auto parameters, read_planner_file(endpoint.planner_file));
    endpoint.planner = std::move(parameters);
  }
  if (!endpoint.policy_file.empty() && endpoint.policy == nullptr) {
    TRY_INIT(endpoint.policy, policy_of(endpoint.policy_file));
  }
  if (!has_script(endpoint)) return {};

  TRY_INIT(auto script, mock_server::read_script(endpoint.behavior));
  endpoint.script = std::move(script);
  return {};
}

std::string missing_file(const Endpoint& endpoint) {
  for (const Endpoint& part : endpoint.parts) {
    if (std::string missing = missing_file(part); !missing.empty()) return missing;
  }
  const std::string& planner = endpoint.planner_file;
  if (!planner.empty() && base::absence(planner)) return planner;
  const std::string& policy = endpoint.policy_file;
  if (endpoint.has_policy_file() && base::absence(policy)) return policy;
  return has_script(endpoint) && base::absence(endpoint.behavior) ? endpoint.behavior : "";
}

std::string default_team_name(const Endpoint& endpoint) {
  return soccer::team_name_from(described_team(endpoint));
}

Result<std::string> check_team_name(std::string_view name) { return soccer::check_team_name(name); }

TeamNames distinct_names(std::string left, std::string right) {
  return soccer::distinct_names(std::move(left), std::move(right));
}

}  // namespace cls::match
