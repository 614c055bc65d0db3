// The rows, and helpers that make them from a member of MatchOptions.
#include "match/terms/option_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

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

// ---- forms of texts

ValueForm kind(ValueKind kind) { return {.kind = kind}; }
ValueForm whole(double min, std::optional<double> max = {}) {
  return {.kind = ValueKind::kWhole, .min = min, .max = max};
}
ValueForm number(double min, std::optional<double> max = {}) {
  return {.kind = ValueKind::kNumber, .min = min, .max = max};
}
ValueForm above(double min) { return {.kind = ValueKind::kNumber, .min = min, .above_min = true}; }
ValueForm text(std::string phrase) { return {.phrase = std::move(phrase)}; }
ValueForm flag_or(std::vector<std::string> words) {
  return {.kind = ValueKind::kFlag, .words = std::move(words)};
}
ValueForm one_of(std::vector<std::string> words) { return {.words = std::move(words)}; }

Error wrong(std::string_view key, std::string_view text, std::string_view what) {
  return Error{fmt::format("{} '{}': {}", option_name(key), text, what)};
}

// ---- rows

/// A row and what describes it beyond its value, one call each.
struct Row : MatchOption {
  /// In cls.toml as part of the plan, with an example.
  Row& in_toml(std::string_view toml) { return used(OptionUse::kConditions, toml); }
  /// In cls.toml, and free to change from run to run.
  Row& in_toml_of_runs(std::string_view toml) { return used(OptionUse::kExecution, toml); }
  Row& in_scenarios(std::string_view name) { return set_member(scenario_key, name); }
  Row& from_variable(std::string_view name) { return set_member(environment, name); }
  Row& with_opposite() { return set_member(has_opposite, true); }
  Row& of_side() { return set_member(is_side, true); }
  Row& of_words(int count) { return set_member(values, count); }
  /// The row of `cls config` that shows the value.
  Row& shown_in(std::string_view row) { return set_member(shown_as, row); }
  Row& showing(std::function<std::string(const Options&)> value) {
    return set_member(shown, std::move(value));
  }

 private:
  template <class Member, class Value>
  Row& set_member(Member& member, Value&& value) {
    member = std::forward<Value>(value);
    return *this;
  }
  Row& used(OptionUse where, std::string_view toml) {
    use = where;
    return set_member(example, toml);
  }
};

/// The member of a member of the options.
template <class Outer, class Inner>
auto in(Outer outer, Inner inner) {
  return [=](auto& options) -> auto& { return std::invoke(outer, options).*inner; };
}

// The type of a member, without std::optional.
template <class T>
struct ValueOf {
  using type = T;
};
template <class T>
struct ValueOf<std::optional<T>> {
  using type = T;
};

template <class T>
std::string shown_text(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(name(value));
  } else if constexpr (requires { value.text; }) {
    return value.text;
  } else {
    return base::text_of(value);
  }
}
template <class T>
std::string shown_text(const std::optional<T>& value) {
  return value ? shown_text(*value) : std::string();
}

/// A row whose text `parse` reads: the value or its own error, or nothing if it has not the form.
template <class Member, class Parse>
Row parsed(std::string_view key, Member member, std::string_view placeholder, ValueForm form,
           Parse parse, std::string_view help) {
  const auto set = [=](Options& options, const std::string& text) -> Result<void> {
    auto value = parse(text);
    if (value) {
      std::invoke(member, options) = *std::move(value);
      return {};
    }
    if constexpr (requires { value.error(); }) {
      return std::move(value).error();
    } else {
      return wrong(key, text, "must be " + base::phrase_of(form));
    }
  };
  const auto shown = [=](const Options& options) {
    return shown_text(std::invoke(member, options));
  };
  return {{key, placeholder, help, form, set, shown}};
}

/// A row whose text is the value of a member: a number, a flag, a text or a path.
template <class Member>
Row row(std::string_view key, Member member, std::string_view placeholder, ValueForm form,
        std::string_view help) {
  using Type = std::remove_reference_t<std::invoke_result_t<Member, Options&>>;
  using Value = typename ValueOf<Type>::type;
  const auto parse = [key](const std::string& text) -> Result<Value> {
    auto value = base::value_of<Value>(text);
    if (!value) return wrong(key, text, "too large");
    return *std::move(value);
  };
  return parsed(key, member, placeholder, std::move(form), parse, help);
}

Row flag(std::string_view key, bool Options::*member, std::string_view help) {
  return row(key, member, "", kind(ValueKind::kFlag), help);
}

Row tls_file(std::string_view key, std::string TlsFileNames::*member, std::string_view help) {
  return row(key, in(&Options::tls, member), "FILE", text("a file"), help);
}

// The folder is read here, so that its errors are those of the option.
template <class Member>
Row formations(std::string_view key, Member folder, std::vector<soccer::Side> sides,
               std::string_view help) {
  Row made = row(key, folder, "DIR", text("a folder"), help);
  made.set = [=](Options& options, const std::string& text) -> Result<void> {
    auto read = player::read_formations(text);
    if (!read) return Error{fmt::format("{}: {}", option_name(key), read.error().message)};

    std::invoke(folder, options) = text;
    for (const soccer::Side side : sides) options.formations[side] = *read;
    return {};
  };
  return made;
}

// A folder for files of soccerwindow2.
Row debug_folder(std::string_view key, std::string proxy::DebugOptions::*member,
                 std::string_view help) {
  const auto existing = [key](const std::string& folder) -> Result<std::string> {
    if (const auto why = base::why_no_folder(folder)) return wrong(key, folder, *why);
    return folder;
  };
  return parsed(key, in(&Options::debug, member), "DIR", text("a folder"), existing, help);
}

// "30 saved/half-time": the cycle ends at the first space.
Result<void> set_save_at(Options& options, const std::string& text) {
  const std::size_t space = text.find(' ');
  const std::string cycle = text.substr(0, space);
  if (!base::fits(kind(ValueKind::kWhole), cycle)) {
    return wrong("save_at", cycle, "must be a cycle, then a file");
  }
  if (!base::fits(whole(1), cycle)) return wrong("save_at", cycle, "the cycle must be positive");

  options.save_at = base::value_of<int>(cycle);
  if (!options.save_at) return wrong("save_at", cycle, "too large");
  options.save_file = text.substr(space + 1);
  return {};
}

std::string saved_at(const Options& options) {
  if (!options.save_at) return {};
  return fmt::format("{} {}", *options.save_at, options.save_file.string());
}

Result<void> set_debug_server(Options& options, const std::string& text) {
  const auto set = proxy::set_debug_server(options.debug, text);
  if (!set) return Error{"--" + set.error().message};
  return {};
}

std::string shown_seed(const Options& options) {
  return options.seed ? fmt::to_string(*options.seed) : "random";
}

std::string shown_deadline(const Options& options) {
  const auto deadline = decision_deadline(options);
  return deadline ? fmt::to_string(deadline->count()) : std::string();
}

// Of a size in bytes; none: no limit, or the default.
template <class Block>
auto shown_size(Block Options::*block, std::uint64_t Block::*size) {
  return [=](const Options& options) {
    const std::uint64_t bytes = options.*block.*size;
    return bytes == 0 ? std::string() : base::byte_size_text(bytes);
  };
}

std::string shown_cpu_seconds(const Options& options) {
  const int seconds = options.limits.cpu_seconds;
  return seconds == 0 ? std::string() : fmt::to_string(seconds);
}

// ---- the table

std::vector<Row> match_rows() {
  return {
      row("seed", &Options::seed, "N", kind(ValueKind::kUnsigned),
          "random seed; the same seed repeats the match (default: random, printed)")
          .showing(shown_seed),
      row("cycles", &Options::cycles, "N", whole(1),
          "end the match at this game time; with --book: cycles of each situation (default: 50)")
          .in_toml("6000"),
      row("half_time", in(&Options::server, &soccer::ServerParams::half_time), "N", whole(-1),
          "length of a half in seconds (default: 300)")
          .in_toml("300")
          .shown_in("server::half_time"),

      row("adjudicate", &Options::adjudicate, "GOALS", whole(1),
          "end the match when a team leads by this (docs/tournaments.md)")
          .in_toml("5"),
      row("book", &Options::book, "FILE", text("a file"),
          "play situations of this book (docs/tournaments.md) instead of a whole match")
          .in_toml("\"moments.book.gz\""),
      row("situations", &Options::situations, "N", whole(1, 100),
          "with --book: situations of a match (default: 8)")
          .in_toml("8"),
      row("dir", &Options::folder, "DIR", text("a folder"),
          "match folder (default: ./runs/<UTC>-<left>-vs-<right>)"),

      parsed("server", &Options::server_choice, "SERVER", {}, parse_server,
             "embedded, rcssserver, PATH of a server, or HOST:PORT (default: embedded)")
          .in_toml("\"embedded\""),
      parsed("mode", &Options::mode, "MODE", one_of({"lockstep", "synch", "realtime"}), parse_mode,
             "lockstep, synch or realtime (default: lockstep; synch with an external server or "
             "team)")
          .showing([](const Options& options) { return std::string(name(mode_of(options))); })
          .in_toml("\"lockstep\""),
      flag("pin", &Options::pin, "give each side half of the processor cores"),
  };
}

std::vector<Row> team_rows() {
  using soccer::Side;
  using Names = soccer::PerSide<std::string>;
  return {
      row("left_name", in(&Options::names, &Names::left), "NAME", text("a name"),
          "team name of the left side"),
      row("right_name", in(&Options::names, &Names::right), "NAME", text("a name"),
          "team name of the right side"),

      flag("rated", &Options::rated,
           "refuse policies that were trained with the full state, as tournaments do"),
      flag("own_names", &Options::own_names, "allow external teams to use their own names"),
      flag("coach", &Options::coach, "connect an online coach for each cls team (default: on)")
          .with_opposite()
          .in_toml("true")
          .in_scenarios("coach"),
      parsed("trainer", &Options::trainer, "SIDE", {}, parse_endpoint,
             "SIDE whose Playmaker handles GetTrainerActions (default: none)")
          .of_side(),

      formations("formation", &Options::formation, {Side::kLeft, Side::kRight},
                 "folder with formations of cls teams, see docs/formations.md (default: built-in)"),
      formations("left_formation", in(&Options::side_formations, &Names::left), {Side::kLeft},
                 "--formation of the left side"),
      formations("right_formation", in(&Options::side_formations, &Names::right), {Side::kRight},
                 "--formation of the right side"),

      parsed("sandbox", &Options::sandbox, "", flag_or({"files", "namespaces"}), parse_sandbox,
             "let team: sides read the system and change their own folder only, in namespaces of "
             "their own where the host has them; =namespaces: nowhere else, =files: without them "
             "(default: on; docs/security.md)")
          .with_opposite()
          .in_toml_of_runs("true"),
      flag("sandbox_playmakers", &Options::sandbox_playmakers,
           "run the programs of run: sides as those of team: sides with --sandbox=namespaces")
          .in_toml_of_runs("true"),
      flag("bind_clients", &Options::bind_clients,
           "accept players and coaches from the programs of their side only "
           "(default: on; off for teams in containers; docs/security.md)")
          .with_opposite()
          .in_toml_of_runs("true"),
  };
}

std::vector<Row> playmaker_rows() {
  return {
      row("rpc_deadline", &Options::rpc_deadline_ms, "N", whole(1),
          "deadline of an RPC in ms (default: lockstep 10000, synch 1000, realtime 70)")
          .showing(shown_deadline)
          .in_toml("10000")
          .in_scenarios("rpc_deadline_ms"),
      flag("no_deadline", &Options::no_deadline, "wait without limit (for debuggers)"),

      parsed("on_late", &Options::on_late, "WHAT", one_of({"hold", "last", "default"}),
             proxy::parse_on_late,
             "commands after a missed decision: hold, last or default (default: hold)")
          .in_toml("\"hold\"")
          .in_scenarios("on_late"),
      parsed("batch", &Options::batch, "WHEN", one_of({"auto", "never", "always"}),
             proxy::parse_batch_mode,
             "one call per team and cycle: auto, never or always (docs/wire.md) (default: auto)")
          .in_toml("\"auto\"")
          .in_scenarios("batch"),
      row("max_missed", &Options::max_missed, "N", whole(0),
          "consecutive missed decisions of a player; one more ends the match (default: 20)")
          .in_toml("20")
          .in_scenarios("max_missed"),
      row("reconnect_within", &Options::reconnect_within_s, "X", number(0),
          "seconds to wait for a disconnected Playmaker, where the server waits (default: 3)")
          .in_toml("3"),

      tls_file("tls_ca", &TlsFileNames::authorities,
               "PEM file of CA certificates that verify tls:HOST:PORT (default: system CAs)")
          .from_variable("CLS_TLS_CA"),
      tls_file("tls_cert", &TlsFileNames::certificate,
               "PEM file of the client certificate, for Playmakers that require one")
          .from_variable("CLS_TLS_CERT"),
      tls_file("tls_key", &TlsFileNames::key, "PEM file of the private key of --tls-cert")
          .from_variable("CLS_TLS_KEY"),
      row("tls_name", in(&Options::tls, &TlsFileNames::server_name), "NAME", text("a name"),
          "expected name in the Playmaker's certificate (default: its host)")
          .from_variable("CLS_TLS_NAME"),
  };
}

std::vector<Row> limit_rows() {
  return {
      row("start_timeout", &Options::start_timeout_s, "X", above(0),
          "seconds until the first response of a Playmaker (default: 20)")
          .in_toml_of_runs("20"),
      row("stall_after", &Options::stall_after_s, "X", above(0),
          "seconds without a new cycle that end the match (default: 10)")
          .in_toml_of_runs("10"),
      row("time_limit", &Options::time_limit_s, "X", above(0),
          "maximum seconds of the match (default: no limit)")
          .in_toml_of_runs("600"),

      parsed("max_memory", in(&Options::limits, &process::ResourceLimits::memory), "SIZE",
             text("a size such as 512M or 2G"), base::parse_byte_size,
             "memory of each process of run: and team: sides, such as 512M or 2G: what it "
             "allocates for itself, without files and shared memory (default: no limit)")
          .showing(shown_size(&Options::limits, &process::ResourceLimits::memory))
          .in_toml_of_runs("\"2G\""),
      row("max_cpu", in(&Options::limits, &process::ResourceLimits::cpu_seconds), "N", whole(1),
          "seconds of CPU time of each process of run: and team: sides; its child processes have "
          "their own (default: no limit)")
          .showing(shown_cpu_seconds)
          .in_toml_of_runs("600"),
      row("side_processes", in(&Options::side_limits, &SideLimits::processes), "N", whole(1),
          "processes and threads that the programs of a team: side may be (default: 4096)")
          .in_toml_of_runs("8000"),
      parsed("side_memory", in(&Options::side_limits, &SideLimits::memory), "SIZE",
             text("a size such as 512M or 2G"), base::parse_byte_size,
             "memory of all programs of a team: side (default: two fifths of this host's)")
          .showing(shown_size(&Options::side_limits, &SideLimits::memory))
          .in_toml_of_runs("\"8G\""),
      parsed("side_disk", in(&Options::side_limits, &SideLimits::disk), "SIZE",
             text("a size such as 512M or 2G"), base::parse_byte_size,
             "what all programs of a team: side may add to their folders (default: 1G)")
          .showing(shown_size(&Options::side_limits, &SideLimits::disk))
          .in_toml_of_runs("\"4G\""),
  };
}

std::vector<Row> debugging_rows() {
  return {
      row("record_rpc", &Options::record_rpc, "FILE", text("a file"),
          "record all requests and replies in FILE (see cls test --replay)"),
      flag("record_world_models", &Options::record_world_models,
           "record what each player estimates, receives and sends; cls watch then shows it beside "
           "the full state (docs/watching.md)")
          .in_toml("true"),
      flag("record_choices", &Options::record_choices,
           "record what players with the ball observed and chose, for learning programs "
           "(docs/formats/choices.md)")
          .in_toml("true"),
      Row{{"save_at",
           "CYCLE FILE",
           "save the match in FILE when game time reaches CYCLE (docs/matches.md)",
           {},
           set_save_at,
           saved_at}}
          .of_words(2),
      row("resume", &Options::resume, "FILE", text("a file"),
          "continue the match saved in FILE; with --seed its random draws differ from there on"),

      row("monitor_port", &Options::monitor_port, "N", whole(0, 65535),
          "UDP port for monitors; 0 selects a free port and prints it"),
      {{"debug_server", "HOST:PORT",
        "send what players estimate, and what Playmakers show, to the debug server of "
        "soccerwindow2 (docs/formats/debug-view.md) (default: none)",
        text("HOST:PORT"), set_debug_server,
        [](const Options& options) { return options.debug.server; }}},
      debug_folder("debug_server_log", &proxy::DebugOptions::view_folder,
                   "write the same into DIR/TEAM-NUMBER.dcl"),
      debug_folder("debug_log", &proxy::DebugOptions::log_folder,
                   "write what Playmakers log into DIR/TEAM-NUMBER.log, as soccerwindow2 reads it"),
  };
}

std::vector<Row> pace_rows() {
  return {
      row("speed", &Options::speed, "X", number(0.1, 1000.0),
          "limit speed to X times real time (default: no limit)"),
      row("protocol", &Options::protocol, "N",
          whole(soccer::kMinProtocolVersion, soccer::kMaxProtocolVersion),
          "protocol version of cls agents, 14 to 19; 19 becomes 18 on older servers (default: 19)")
          .in_toml("19"),
  };
}

}  // namespace

const std::vector<MatchOption>& match_options() {
  static const std::vector<MatchOption> table = [] {
    const std::pair<OptionGroup, std::vector<Row>> parts[] = {
        {OptionGroup::kMatch, match_rows()},          {OptionGroup::kTeams, team_rows()},
        {OptionGroup::kPlaymakers, playmaker_rows()}, {OptionGroup::kLimits, limit_rows()},
        {OptionGroup::kDebugging, debugging_rows()},  {OptionGroup::kMatch, pace_rows()}};
    std::vector<MatchOption> all;
    for (const auto& [group, rows] : parts) {
      for (const Row& made : rows) all.emplace_back(made).group = group;
    }
    return all;
  }();
  return table;
}

const MatchOption* find_match_option(std::string_view key) {
  const auto found = std::ranges::find(match_options(), key, &MatchOption::key);
  return found == match_options().end() ? nullptr : &*found;
}

std::string option_name(std::string_view key) {
  std::string name = "--" + std::string(key);
  std::ranges::replace(name, '_', '-');
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
      words.insert(words.end(), {option_name(option.key), text->second});
    } else if (text->second == "true") {
      words.push_back(option_name(option.key));
    } else if (text->second != "false") {
      words.push_back(fmt::format("{}={}", option_name(option.key), text->second));
    } else if (option.has_opposite) {
      words.push_back(option_name("no_" + std::string(option.key)));
    }
  }
  return words;
}

}  // namespace cls::match
