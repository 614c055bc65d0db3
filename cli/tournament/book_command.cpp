// `cls book`: books of situations for `cls compare` and `cls tune`.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/play/flow.h"
#include "analysis/situations/book_file.h"
#include "analysis/situations/book_fit.h"
#include "analysis/situations/make_book.h"
#include "base/index.h"
#include "base/text/counted.h"
#include "base/text/json.h"
#include "cli/logs/counted_logs.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "cli/terminal/json_stdout.h"
#include "cli/terminal/log_progress.h"
#include "gamelog/files/log_files.h"
#include "gamelog/rcg/rcg_reader.h"
#include "review/state_value.h"

namespace cls::cli {
namespace {

using namespace match;
using base::Json;

struct BookArguments {
  std::vector<std::string> logs;
  std::string book;
  std::string out;
  std::vector<std::string> classes;
  analysis::BookOptions options;
  int cycles = kFitCycles;
  double ridge = analysis::BookFitter::kDefaultRidge;
  bool force = false;
  bool json = false;

  static constexpr int kFitCycles = 50;
};

// Calls `add` with each game log; it returns why a match is left out. 0, or an exit code after an
// error line.
template <typename Add>
int for_each_log(const std::vector<std::string>& arguments, Add add) {
  const gamelog::FoundLogs found = find_counted_logs(arguments);
  for (const std::string& missing : found.missing) {
    print_error(0, "{}: no game log", missing);
  }
  if (!found.missing.empty()) return kNoInput;

  LogProgress progress(found.matches.size());
  std::size_t done = 0;
  std::size_t used = 0;
  for (const gamelog::MatchLogs& match : found.matches) {
    if (watch_interrupts() != 0) return signal_exit_code(watch_interrupts());
    progress.update(done++);
    if (match.game.empty()) continue;
    TRY_INIT_OR(kNoInput, const auto record, gamelog::read_rcg_file(match.game));
    if (const std::string why = add(record, match.game); !why.empty()) {
      print_error(0, "{}: left out: {}", match.game, why);
      continue;
    }
    ++used;
  }
  if (used == 0) return print_error(kBadData, "no log can be used");

  return kOk;
}

Json counts_of(const analysis::Book& book) {
  Json counts = Json::object();
  for (std::size_t i = 0; i < analysis::kSituationClasses; ++i) {
    const auto kind = static_cast<analysis::SituationClass>(i);
    counts[std::string(name(kind))] = std::ranges::count_if(
        book.situations, [kind](const analysis::Situation& one) { return one.kind == kind; });
  }
  return counts;
}

int print_book(const analysis::Book& book, const std::string& file, bool json) {
  if (json) {
    return print_json({{"schema", "cls.book-summary/1"},
                       {"file", file},
                       {"seed", book.seed},
                       {"warm_up", book.warm_up},
                       {"logs", book.logs.size()},
                       {"situations", book.situations.size()},
                       {"classes", counts_of(book)}});
  }

  std::string classes;
  const Json counts = counts_of(book);
  for (const auto& [kind, count] : counts.items()) {
    if (count == 0) continue;
    if (!classes.empty()) classes += ", ";
    classes += fmt::format("{} {}", kind, count.get<int>());
  }

  fmt::print("{}: {} of {} ({})\n", file, base::counted(book.situations.size(), "situation"),
             base::counted(book.logs.size(), "match", "matches"), classes);
  return kOk;
}

// "attack, defense, ..."
std::string all_classes() {
  std::string names;
  for (std::size_t i = 0; i < analysis::kSituationClasses; ++i) {
    if (i > 0) names += ", ";
    names += name(static_cast<analysis::SituationClass>(i));
  }
  return names;
}

// Those of --classes, once each; without it those of every book.
base::Result<std::vector<analysis::SituationClass>> chosen_classes(const BookArguments& arguments) {
  if (arguments.classes.empty()) return arguments.options.classes;
  std::vector<analysis::SituationClass> chosen;
  for (const std::string& text : arguments.classes) {
    const auto kind = analysis::parse_situation_class(text);
    if (!kind) {
      return base::Error{fmt::format("--classes '{}': must be one of {}", text, all_classes())};
    }
    if (std::ranges::find(chosen, *kind) == chosen.end()) chosen.push_back(*kind);
  }

  const int count = arguments.options.count;
  if (base::index(count) < chosen.size()) {
    return base::Error{fmt::format("--count {}: less than one situation of each of {} classes",
                                   count, chosen.size())};
  }
  return chosen;
}

int run_book_make(const BookArguments& arguments) {
  TRY_STEP(report_failure(why_not_replaced(arguments.out, arguments.force)));
  analysis::BookOptions options = arguments.options;
  TRY_INIT_OR(kUsage, const auto classes, chosen_classes(arguments));
  options.classes = classes;
  analysis::BookMaker maker(options);
  const int read = for_each_log(arguments.logs, [&](const auto& record, const std::string& file) {
    const std::filesystem::path path(file);
    const auto folder = path.parent_path().filename();
    return maker.add(record, (folder / path.filename()).string());
  });
  if (read != kOk) return read;

  for (const analysis::SituationClass kind : options.classes) {
    if (maker.moments(kind) > 0) continue;
    return print_error(kBadData, "the matches have no moment of the class {}; add logs",
                       name(kind));
  }

  const analysis::Book book = maker.make();
  const auto failure = write_output(arguments.out, [&](base::ByteSink& sink) {
    analysis::write_book(book, sink);
    return true;
  });
  if (failure) return report_failure(failure);
  const std::size_t wanted =
      static_cast<std::size_t>(options.count) / options.classes.size() * options.classes.size();
  if (book.situations.size() < wanted) {
    const bool single = options.classes.size() == 1;
    print_error(0, "--count {}: {} fewer moments; the book has {}", options.count,
                single ? "there are" : "the rarest class has",
                base::counted(book.situations.size(), "situation"));
  }

  return print_book(book, arguments.out, arguments.json);
}

int run_book_show(const BookArguments& arguments) {
  TRY_INIT_OR(exit_code_of_book(arguments.book), const auto book,
              analysis::read_book(arguments.book));
  return print_book(book, arguments.book, arguments.json);
}

// The weights of the chance to score, fitted and used, and how well the used ones agree.
Json chances_json(const review::StateFitter& fitter) {
  const review::StateFigures fitted = fitter.fit();
  Json weights = Json::object();
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    weights[std::string(review::kStateFigures[i])] = {{"fitted", fitted[i]},
                                                      {"used", review::state_weights()[i]}};
  }

  constexpr std::size_t kBins = 10;
  Json bins = Json::array();
  for (const review::CalibrationBin& bin : fitter.calibration(kBins)) {
    bins.push_back({{"moments", bin.moments}, {"chance", bin.chance}, {"goals", bin.goals}});
  }
  return {{"cycles", review::kValueHorizon},
          {"moments", fitter.rows()},
          {"goals", fitter.goals()},
          {"weights", weights},
          {"calibration", bins}};
}

void print_chances(const Json& chances) {
  fmt::print("\nchance to score within {} cycles: {} moments, {} of them before a goal\n",
             chances["cycles"].get<int>(), chances["moments"].get<int>(),
             chances["goals"].get<int>());
  fmt::print("{:<20}{:>10}{:>10}\n", "figure", "fitted", "used");
  for (const auto& [figure, values] : chances["weights"].items()) {
    fmt::print("{:<20}{:>10.3f}{:>10.3f}\n", figure, values["fitted"].get<double>(),
               values["used"].get<double>());
  }

  fmt::print("{:<20}{:>10}{:>10}\n", "moments", "chance", "goals");
  for (const Json& bin : chances["calibration"]) {
    fmt::print("{:<20}{:>10.4f}{:>10.4f}\n", bin["moments"].get<int>(), bin["chance"].get<double>(),
               bin["goals"].get<double>());
  }
}

int run_book_fit(const BookArguments& arguments) {
  analysis::BookFitter fitter(arguments.cycles, arguments.ridge);
  review::StateFitter states;
  const int read = for_each_log(arguments.logs, [&](const auto& record, const std::string&) {
    const analysis::Flow flow = analysis::build_flow(record);
    std::string why = fitter.add(flow);
    if (why.empty()) states.add(flow);
    return why;
  });
  if (read != kOk) return read;

  const analysis::BookFit fit = fitter.fit();
  const Json chances = chances_json(states);
  Json weights = Json::object();
  for (std::size_t i = 0; i < analysis::kFigures; ++i) {
    weights[std::string(analysis::kFigureNames[i])] = {{"fitted", fit.weights[i]},
                                                       {"used", analysis::situation_weights()[i]}};
  }

  if (arguments.json) {
    const Json document = {
        {"schema", "cls.book-fit/1"},     {"cycles", arguments.cycles},
        {"ridge", arguments.ridge},       {"matches", fit.matches},
        {"windows", fit.windows},         {"weights", weights},
        {"correlation", fit.correlation}, {"correlation_of_goals", fit.correlation_of_goals},
        {"variance", fit.variance},       {"variance_of_goals", fit.variance_of_goals},
        {"chance_to_score", chances}};
    return print_json(document);
  }

  fmt::print("{} windows of {} cycles in {}\n", fit.windows, arguments.cycles,
             base::counted(static_cast<std::size_t>(fit.matches), "match", "matches"));
  fmt::print("{:<16}{:>10}{:>10}\n", "figure", "fitted", "used");
  for (const auto& [figure, values] : weights.items()) {
    fmt::print("{:<16}{:>10.3f}{:>10.3f}\n", figure, values["fitted"].get<double>(),
               values["used"].get<double>());
  }

  fmt::print("correlation with the match: {:.3f}, of goals alone {:.3f}\n", fit.correlation,
             fit.correlation_of_goals);
  fmt::print("variance within matches: {:.2f}, of goals alone {:.2f}\n", fit.variance,
             fit.variance_of_goals);
  print_chances(chances);
  return kOk;
}

void add_logs_argument(Command& command, BookArguments& arguments) {
  command.option("LOGS", arguments.logs, "game logs, or folders with game logs").required();
}

void add_book_make(Command& book) {
  auto [command, arguments] = book.command(
      "make",
      "choose situations from recorded matches\n"
      "\n"
      "  cls book make cup/matches --out moments.book.gz\n"
      "  cls book make a.rcg.gz b.rcg.gz --out small.book --count 80 --seed 7\n"
      "  cls book make runs --out build-up.book --classes build_up\n"
      "\n"
      "A situation is the exact world of a moment and the steps before it; a book has\n"
      "as many of each class as of the others. The same logs in the same order, options\n"
      "and seed give the same file (docs/formats/book.md).",
      run_book_make);
  add_logs_argument(command, arguments);
  command.option("--out FILE", arguments.out, "the book; compressed if it ends in .gz")
      .of_group(kOutputGroup)
      .required();

  command.setting("--count", arguments.options.count, "situations")
      .range(static_cast<int>(analysis::kDefaultClasses.size()),
             static_cast<int>(analysis::kMaxSituations));

  command
      .option("--classes A,B,...", arguments.classes,
              fmt::format("of {} (default: all but build_up)", all_classes()))
      .split_at(',')
      .takes(1);

  command.setting("--warm-up", arguments.options.warm_up, "steps before each moment")
      .range(3, analysis::kMaxWarmUp);

  command
      .setting("--spacing", arguments.options.spacing,
               "minimum cycles between two moments of one class and match")
      .above(0);

  command.setting("--seed", arguments.options.seed, "seed of the choice");
  command.flag("--force", arguments.force, "replace the file");
  command.flag("--json", arguments.json, "print the summary as JSON").of_group(kOutputGroup);
}

void add_book_show(Command& book) {
  auto [command, arguments] = book.command("show",
                                           "check a book and print its size\n"
                                           "\n"
                                           "  cls book show moments.book.gz --json",
                                           run_book_show);
  command.option("BOOK", arguments.book, "a file of `cls book make`").required();
  command.flag("--json", arguments.json, "print the summary as JSON").of_group(kOutputGroup);
}

void add_book_fit(Command& book) {
  auto [command, arguments] =
      book.command("fit",
                   "compute the weights of the value of situations from whole matches\n"
                   "\n"
                   "  cls book fit cup/matches\n"
                   "\n"
                   "Prints the weights that these matches give beside those in use\n"
                   "(docs/tournaments.md). It changes nothing.",
                   run_book_fit);

  add_logs_argument(command, arguments);
  command.setting("--cycles", arguments.cycles, "length of a window").above(0);

  command
      .setting("--ridge", arguments.ridge,
               "shrink weights towards those of each figure alone, 0: not at all")
      .from(0);
  command.flag("--json", arguments.json, "print the fit as JSON").of_group(kOutputGroup);
}

}  // namespace

void add_book_command(Command& app) {
  Command& command = app.command("book",
                                 "books of situations for compare and tune\n"
                                 "\n"
                                 "  cls book make cup/matches --out moments.book.gz\n"
                                 "  cls compare NEW OLD --book moments.book.gz");
  command.group = kPlayCommands;
  add_book_make(command);
  add_book_show(command);
  add_book_fit(command);
}

}  // namespace cls::cli
