// The rows, and helpers that make them from a member of MatchOptions.
#include "match/terms/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "base/io/whole_file.h"
#include "base/text/byte_size.h"
#include "base/text/value_text.h"
#include "player/formation/formation_set.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::match {
namespace {

using base::Error;
using base::Result;
using base::ValueForm;
using base::ValueKind;
using Options = MatchOptions;
using Row = MatchOption;
using Rows = std::vector<MatchOption>;

ValueForm form_of(ValueKind kind) {
  ValueForm form;
  form.kind = kind;
  return form;
}
ValueForm whole_from(double min, std::optional<double> max = {}) {
  ValueForm form = form_of(ValueKind::kWhole);
  form.min = min;
  form.max = max;
  return form;
}
ValueForm number_above(double min) {
  ValueForm form = form_of(ValueKind::kNumber);
  form.min = min;
  form.above_min = true;
  return form;
}
ValueForm number_from(double min, std::optional<double> max = {}) {
  ValueForm form = form_of(ValueKind::kNumber);
  form.min = min;
  form.max = max;
  return form;
}
ValueForm text_as(std::string phrase) {
  ValueForm form;
  form.phrase = std::move(phrase);
  return form;
}
ValueForm one_of(std::vector<std::string> words) {
  ValueForm form;
  form.words = std::move(words);
  return form;
}

Error wrong(std::string_view key, std::string_view text, std::string_view what) {
  return Error{fmt::format("{} '{}': {}", option_name(key), text, what)};
}

// The value of a text that has the form of the option.
template <typename Value>
Result<Value> value_of(std::string_view key, const std::string& text) {
  auto value = base::value_of<Value>(text);
  if (!value) return wrong(key, text, "too large");
  return *std::move(value);
}

// The type of a member, without std::optional.
template <typename Member>
struct ValueType {
  using type = Member;
};
template <typename Value>
struct ValueType<std::optional<Value>> {
  using type = Value;
};

/// A row whose text is the value of a member: a number, a flag, a text or a path.
template <typename Member>
Row row(std::string_view key, Member Options::*member, std::string_view placeholder, ValueForm form,
        std::string_view help) {
  using Value = typename ValueType<Member>::type;
  const auto set = [key, member](Options& options, const std::string& text) -> Result<void> {
    TRY_INIT(options.*member, value_of<Value>(key, text));
    return {};
  };
  const auto shown = [member](const Options& options) { return base::text_of(options.*member); };
  return {key, placeholder, help, std::move(form), set, shown};
}

Row flag(std::string_view key, bool Options::*member, std::string_view help) {
  return row(key, member, "", form_of(ValueKind::kFlag), help);
}

Row in(OptionGroup group, Row made) {
  made.group = group;
  return made;
}

// A row that cls.toml may have, with an example for it.
Row with(OptionUse use, std::string_view example, Row made) {
  made.use = use;
  made.example = example;
  return made;
}

Row with_opposite(Row made) {
  made.has_opposite = true;
  return made;
}

Row in_scenarios(std::string_view scenario_key, Row made) {
  made.scenario_key = scenario_key;
  return made;
}

Row from_variable(std::string_view variable, Row made) {
  made.environment = variable;
  return made;
}

// The folder is read here, so that its errors are those of the option.
Row formations(std::string_view key, std::string Options::*folder,
               std::vector<std::shared_ptr<const player::FormationSet> Options::*> sets,
               std::string_view help) {
  Row made = row(key, folder, "DIR", text_as("a folder"), help);
  made.set = [=](Options& options, const std::string& text) -> Result<void> {
    auto read = player::read_formations(text);
    if (!read) return Error{fmt::format("{}: {}", option_name(key), read.error().message)};
    options.*folder = text;
    for (const auto set : sets) options.*set = *read;
    return {};
  };
  return in(OptionGroup::kTeams, std::move(made));
}

Rows match_rows() {
  const OptionUse conditions = OptionUse::kConditions;
  Rows rows = {
      row("seed", &Options::seed, "N", form_of(ValueKind::kUnsigned),
          "random seed; the same seed repeats the match (default: random, printed)"),
      with(conditions, "6000",
           row("cycles", &Options::cycles, "N", whole_from(1),
               "end the match at this game time; with --book: cycles of each situation (default: "
               "50)")),
      with(conditions, "300",
           {"half_time", "N", "length of a half in seconds (default: 300)", whole_from(-1),
            [](Options& options, const std::string& text) -> Result<void> {
              TRY_INIT(options.server.half_time, value_of<int>("half_time", text));
              return {};
            },
            [](const Options& options) { return fmt::to_string(options.server.half_time); }}),
      with(conditions, "5",
           row("adjudicate", &Options::adjudicate, "GOALS", whole_from(1),
               "end the match when a team leads by this (docs/tournaments.md)")),
      with(conditions, "\"moments.book.gz\"",
           row("book", &Options::book, "FILE", text_as("a file"),
               "play situations of this book (docs/tournaments.md) instead of a whole match")),
      with(conditions, "8",
           row("situations", &Options::situations, "N", whole_from(1, 100),
               "with --book: situations of a match (default: 8)")),
      row("dir", &Options::folder, "DIR", text_as("a folder"),
          "match folder (default: ./runs/<UTC>-<left>-vs-<right>)"),
      with(conditions, "\"embedded\"",
           {"server",
            "SERVER",
            "embedded, rcssserver, PATH of a server, or HOST:PORT (default: embedded)",
            {},
            [](Options& options, const std::string& text) -> Result<void> {
              TRY_INIT(auto server, parse_server(text));
              options.server_choice = std::move(server);
              return {};
            },
            [](const Options& options) { return options.server_choice.text; }}),
      with(conditions, "\"lockstep\"",
           {"mode", "MODE",
            "lockstep, synch or realtime (default: lockstep; synch with an external server or "
            "team)",
            one_of({"lockstep", "synch", "realtime"}),
            [](Options& options, const std::string& text) -> Result<void> {
              TRY_INIT(const auto mode, parse_mode(text));
              options.mode = mode;
              return {};
            },
            [](const Options& options) { return std::string(name(mode_of(options))); }}),
      flag("pin", &Options::pin, "give each side half of the processor cores"),
  };
  rows.front().shown = [](const Options& options) {
    return options.seed ? fmt::to_string(*options.seed) : "random";
  };
  rows[2].shown_as = "server::half_time";
  return rows;
}

Rows team_rows() {
  Rows rows = {
      row("left_name", &Options::left_name, "NAME", text_as("a name"),
          "team name of the left side"),
      row("right_name", &Options::right_name, "NAME", text_as("a name"),
          "team name of the right side"),
      flag("rated", &Options::rated,
           "refuse policies that were trained with the full state, as tournaments do"),
      flag("own_names", &Options::own_names, "allow external teams to use their own names"),
      in_scenarios("coach", with(OptionUse::kConditions, "true",
                                 with_opposite(flag(
                                     "coach", &Options::coach,
                                     "connect an online coach for each cls team (default: on)")))),
      {"trainer",
       "SIDE",
       "SIDE whose Playmaker handles GetTrainerActions (default: none)",
       {},
       [](Options& options, const std::string& text) -> Result<void> {
         TRY_INIT(auto side, parse_endpoint(text));
         options.trainer = std::move(side);
         return {};
       },
       [](const Options& options) { return options.trainer ? options.trainer->text : ""; }},
      formations("formation", &Options::formation,
                 {&Options::left_formations, &Options::right_formations},
                 "folder with formations of cls teams, see docs/formations.md (default: built-in)"),
      formations("left_formation", &Options::left_formation, {&Options::left_formations},
                 "--formation of the left side"),
      formations("right_formation", &Options::right_formation, {&Options::right_formations},
                 "--formation of the right side"),
      with(OptionUse::kExecution, "true",
           with_opposite(flag("sandbox", &Options::sandbox,
                              "let team: sides read the system and change their own folder only "
                              "(default: on; docs/security.md)"))),
      with(OptionUse::kExecution, "true",
           with_opposite(flag("bind_clients", &Options::bind_clients,
                              "accept players and coaches from the programs of their side only "
                              "(default: on; off for teams in containers; docs/security.md)"))),
  };
  for (Row& one : rows) {
    one.group = OptionGroup::kTeams;
    one.is_side = one.key == "trainer";
  }
  return rows;
}

Row tls_row(std::string_view key, std::string TlsFileNames::*member, std::string_view placeholder,
            std::string_view variable, std::string_view help) {
  return from_variable(
      variable, {key, placeholder, help, text_as(placeholder == "FILE" ? "a file" : "a name"),
                 [member](Options& options, const std::string& text) -> Result<void> {
                   options.tls.*member = text;
                   return {};
                 },
                 [member](const Options& options) { return options.tls.*member; }});
}

Rows playmaker_rows() {
  const OptionUse conditions = OptionUse::kConditions;
  Rows rows = {
      in_scenarios("rpc_deadline_ms",
                   with(conditions, "10000",
                        row("rpc_deadline", &Options::rpc_deadline_ms, "N", whole_from(1),
                            "deadline of an RPC in ms (default: lockstep 10000, synch 1000, "
                            "realtime 70)"))),
      flag("no_deadline", &Options::no_deadline, "wait without limit (for debuggers)"),
      in_scenarios(
          "on_late",
          with(conditions, "\"hold\"",
               {"on_late", "WHAT",
                "commands after a missed decision: hold, last or default (default: hold)",
                one_of({"hold", "last", "default"}),
                [](Options& options, const std::string& text) -> Result<void> {
                  const auto on_late = proxy::parse_on_late(text);
                  if (!on_late) return wrong("on_late", text, "must be hold, last or default");
                  options.on_late = *on_late;
                  return {};
                },
                [](const Options& options) { return std::string(name(options.on_late)); }})),
      in_scenarios(
          "batch",
          with(conditions, "\"auto\"",
               {"batch", "WHEN",
                "one call per team and cycle: auto, never or always (docs/wire.md) (default: auto)",
                one_of({"auto", "never", "always"}),
                [](Options& options, const std::string& text) -> Result<void> {
                  const auto batch = proxy::parse_batch_mode(text);
                  if (!batch) return wrong("batch", text, "must be auto, never or always");
                  options.batch = *batch;
                  return {};
                },
                [](const Options& options) { return std::string(name(options.batch)); }})),
      in_scenarios("max_missed",
                   with(conditions, "20",
                        row("max_missed", &Options::max_missed, "N", whole_from(0),
                            "consecutive missed decisions of a player; one more ends the match "
                            "(default: 20)"))),
      with(conditions, "3",
           row("reconnect_within", &Options::reconnect_within_s, "X", number_from(0),
               "seconds to wait for a disconnected Playmaker, where the server waits "
               "(default: 3)")),
      tls_row("tls_ca", &TlsFileNames::authorities, "FILE", "CLS_TLS_CA",
              "PEM file of CA certificates that verify tls:HOST:PORT (default: system CAs)"),
      tls_row("tls_cert", &TlsFileNames::certificate, "FILE", "CLS_TLS_CERT",
              "PEM file of the client certificate, for Playmakers that require one"),
      tls_row("tls_key", &TlsFileNames::key, "FILE", "CLS_TLS_KEY",
              "PEM file of the private key of --tls-cert"),
      tls_row("tls_name", &TlsFileNames::server_name, "NAME", "CLS_TLS_NAME",
              "expected name in the Playmaker's certificate (default: its host)"),
  };
  for (Row& one : rows) one.group = OptionGroup::kPlaymakers;
  rows.front().shown = [](const Options& options) {
    const auto deadline = decision_deadline(options);
    return deadline ? fmt::to_string(deadline->count()) : std::string();
  };
  return rows;
}

Rows limit_rows() {
  const OptionUse execution = OptionUse::kExecution;
  Rows rows = {
      with(execution, "20",
           row("start_timeout", &Options::start_timeout_s, "X", number_above(0),
               "seconds until the first response of a Playmaker (default: 20)")),
      with(execution, "10",
           row("stall_after", &Options::stall_after_s, "X", number_above(0),
               "seconds without a new cycle that end the match (default: 10)")),
      with(execution, "600",
           row("time_limit", &Options::time_limit_s, "X", number_above(0),
               "maximum seconds of the match (default: no limit)")),
      with(execution, "\"2G\"",
           {"max_memory", "SIZE",
            "memory of each process of run: and team: sides, such as 512M or 2G: "
            "what it allocates for itself, without files and shared memory "
            "(default: no limit)",
            text_as("a size such as 512M or 2G"),
            [](Options& options, const std::string& text) -> Result<void> {
              const auto size = base::parse_byte_size(text);
              if (!size) return wrong("max_memory", text, "must be a size such as 512M or 2G");
              options.limits.memory = *size;
              return {};
            },
            [](const Options& options) {
              const auto memory = options.limits.memory;
              return memory == 0 ? std::string() : base::byte_size_text(memory);
            }}),
      with(execution, "600",
           {"max_cpu", "N",
            "seconds of CPU time of each process of run: and team: sides; its "
            "child processes have their own (default: no limit)",
            whole_from(1),
            [](Options& options, const std::string& text) -> Result<void> {
              TRY_INIT(options.limits.cpu_seconds, value_of<int>("max_cpu", text));
              return {};
            },
            [](const Options& options) {
              const auto seconds = options.limits.cpu_seconds;
              return seconds == 0 ? std::string() : fmt::to_string(seconds);
            }}),
  };
  for (Row& one : rows) one.group = OptionGroup::kLimits;
  return rows;
}

// "30 saved/half-time": the cycle ends at the first space.
Row save_at_row() {
  Row made = {"save_at",
              "CYCLE FILE",
              "save the match in FILE when game time reaches CYCLE (docs/matches.md)",
              {},
              [](Options& options, const std::string& text) -> Result<void> {
                const std::size_t space = text.find(' ');
                const std::string cycle = text.substr(0, space);
                if (!base::fits(form_of(ValueKind::kWhole), cycle)) {
                  return wrong("save_at", cycle, "must be a cycle, then a file");
                }
                if (!base::fits(whole_from(1), cycle)) {
                  return wrong("save_at", cycle, "the cycle must be positive");
                }
                TRY_INIT(options.save_at, value_of<int>("save_at", cycle));
                options.save_file = text.substr(space + 1);
                return {};
              },
              [](const Options& options) {
                return options.save_at
                           ? fmt::format("{} {}", *options.save_at, options.save_file.string())
                           : std::string();
              }};
  made.values = 2;
  return made;
}

// A folder for files of soccerwindow2.
Row debug_folder(std::string_view key, std::string proxy::DebugOptions::*member,
                 std::string_view help) {
  return {key,
          "DIR",
          help,
          text_as("a folder"),
          [key, member](Options& options, const std::string& text) -> Result<void> {
            if (const auto why = base::why_no_folder(text)) return wrong(key, text, *why);
            options.debug.*member = text;
            return {};
          },
          [member](const Options& options) { return options.debug.*member; }};
}

Row debug_server_row() {
  return {"debug_server",
          "HOST:PORT",
          "send what players estimate, and what Playmakers show, to the debug server of "
          "soccerwindow2 (docs/formats/debug-view.md) (default: none)",
          text_as("HOST:PORT"),
          [](Options& options, const std::string& text) -> Result<void> {
            const auto set = proxy::set_debug_server(options.debug, text);
            if (!set) return Error{"--" + set.error().message};
            return {};
          },
          [](const Options& options) { return options.debug.server; }};
}

Rows debugging_rows() {
  Rows rows = {
      row("record_rpc", &Options::record_rpc, "FILE", text_as("a file"),
          "record all requests and replies in FILE (see cls test --replay)"),
      with(OptionUse::kConditions, "true",
           flag("record_world_models", &Options::record_world_models,
                "record what each player estimates, receives and sends; cls watch then "
                "shows it beside the full state (docs/watching.md)")),
      save_at_row(),
      row("resume", &Options::resume, "FILE", text_as("a file"),
          "continue the match saved in FILE; with --seed its random draws differ from there on"),
      row("monitor_port", &Options::monitor_port, "N", whole_from(0, 65535),
          "UDP port for monitors; 0 selects a free port and prints it"),
      debug_server_row(),
      debug_folder("debug_server_log", &proxy::DebugOptions::view_folder,
                   "write the same into DIR/TEAM-NUMBER.dcl"),
      debug_folder("debug_log", &proxy::DebugOptions::log_folder,
                   "write what Playmakers log into DIR/TEAM-NUMBER.log, as soccerwindow2 reads it"),
  };
  for (Row& one : rows) one.group = OptionGroup::kDebugging;
  rows.push_back(row("speed", &Options::speed, "X", number_from(0.1, 1000.0),
                     "limit speed to X times real time (default: no limit)"));
  rows.push_back(with(OptionUse::kConditions, "19",
                      row("protocol", &Options::protocol, "N",
                          whole_from(soccer::kMinProtocolVersion, soccer::kMaxProtocolVersion),
                          "protocol version of cls agents, 14 to 19; 19 becomes 18 on older "
                          "servers (default: 19)")));
  return rows;
}

// Rows are referred to, so a deque, which never moves them.
std::deque<MatchOption>& table() {
  static std::deque<MatchOption> rows = [] {
    std::deque<MatchOption> all;
    for (Rows part :
         {match_rows(), team_rows(), playmaker_rows(), limit_rows(), debugging_rows()}) {
      std::move(part.begin(), part.end(), std::back_inserter(all));
    }
    return all;
  }();
  return rows;
}

}  // namespace

const std::deque<MatchOption>& match_options() { return table(); }

AddedMatchOption::AddedMatchOption(MatchOption option) { table().push_back(std::move(option)); }

AddedMatchOption::~AddedMatchOption() { table().pop_back(); }

const MatchOption* find_match_option(std::string_view key) {
  const auto found = std::find_if(table().begin(), table().end(),
                                  [key](const MatchOption& one) { return one.key == key; });
  return found == table().end() ? nullptr : &*found;
}

std::string option_name(std::string_view key) {
  std::string name = "--" + std::string(key);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::vector<std::string> set_options(MatchOptions& options, const OptionTexts& texts) {
  std::vector<std::string> errors;
  for (const MatchOption& option : match_options()) {
    const auto text = texts.find(option.key);
    if (text == texts.end()) continue;
    // Texts have errors of their own, with suggestions.
    const bool is_text = option.form.kind == ValueKind::kText;
    if (!is_text && !base::fits(option.form, text->second)) {
      errors.push_back(
          wrong(option.key, text->second, "must be " + base::phrase_of(option.form)).message);
      continue;
    }
    const Result<void> set = option.set(options, text->second);
    if (!set) errors.push_back(set.error().message);
  }
  return errors;
}

std::vector<std::string> option_words(const OptionTexts& texts) {
  std::vector<std::string> words;
  for (const MatchOption& option : match_options()) {
    const auto text = texts.find(option.key);
    if (text == texts.end()) continue;
    if (option.form.kind != ValueKind::kFlag) {
      words.push_back(option_name(option.key));
      words.push_back(text->second);
    } else if (text->second == "true") {
      words.push_back(option_name(option.key));
    } else if (option.has_opposite) {
      words.push_back(option_name("no_" + std::string(option.key)));
    }
  }
  return words;
}

}  // namespace cls::match
