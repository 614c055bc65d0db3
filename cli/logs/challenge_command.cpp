// `cls challenge stp`: tests, baselines, checks and scores of the trajectory challenge.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/tables/stp_challenge.h"
#include "base/io/byte_source.h"
#include "base/io/whole_file.h"
#include "base/text/json.h"
#include "cli/logs/output_file.h"
#include "cli/support/commands.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
using analysis::StpColumns;
using analysis::StpFile;
using analysis::StpModel;
using base::Error;
using base::Result;

constexpr const char* kTracking = ".tracking.csv";

struct ChallengeArguments {
  std::string in;
  std::string tests;
  std::string submission;
  std::string truth;
  std::string out;
  std::string model = "goal";
  bool force = false;
  bool json = false;
};

// The tracking tables below a folder by their path in it, sorted.
Result<std::vector<std::string>> tables_of(const std::string& folder) {
  if (const auto why = base::why_no_folder(folder)) {
    return Error{fmt::format("{}: {}", folder, *why)};
  }

  std::vector<std::string> names;
  std::error_code code;
  for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end;
       at.increment(code)) {
    const std::string path = at->path().string();
    std::error_code ignored;
    if (!path.ends_with(kTracking) || !at->is_regular_file(ignored)) continue;
    names.push_back(at->path().lexically_relative(folder).generic_string());
  }
  if (code) return Error{fmt::format("{}: {}", folder, code.message())};
  if (names.empty()) return Error{fmt::format("{}: no file NAME{}", folder, kTracking)};

  std::ranges::sort(names);
  return names;
}

std::string path_of(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

// Calls `read` with the bytes of a file, whose name its error gets.
template <typename Function>
auto with_file(const std::string& path, Function read)
    -> decltype(read(std::declval<base::ByteSource&>())) {
  auto source = base::open_source(path);
  if (!source) return source.error();
  auto result = read(**source);
  if (!result) return Error{fmt::format("{}: {}", path, result.error().message)};
  return result;
}

void print_document(const char* what, base::Json document) {
  base::Json all = {{"schema", "cls.challenge/1"}, {"command", what}};
  all.update(document);
  print_json(all);
}

// Files of a match beside its tracking table; a test has those that are there.
constexpr struct {
  const char* ending;
  StpFile file;
} kFiles[] = {{kTracking, StpFile::kTracking},
              {".event.csv", StpFile::kEvents},
              {".rcg.gz", StpFile::kGameLog},
              {".rcl.gz", StpFile::kTextLog}};

// 0, or the exit code after an error line.
int write_test(const std::string& match, const std::string& test, int last_cycle, bool force) {
  for (const auto& one : kFiles) {
    const std::string from = match + one.ending;
    const std::string to = test + one.ending;
    if (!fs::exists(from)) continue;

    TRY_STEP(report_failure(why_not_replaced(to, force)));

    std::optional<Error> error;
    const auto failure = write_output(to, [&](base::ByteSink& sink) {
      const auto cut = with_file(from, [&](base::ByteSource& source) {
        return analysis::cut_stp_file(source, one.file, last_cycle, sink);
      });
      if (!cut) error = cut.error();
      return cut.ok();
    });
    if (error) return print_error(kBadData, error->message);
    TRY_STEP(report_failure(failure));
  }
  return kOk;
}

// Tests lie in one folder, as the scripts want it.
std::string flat(std::string name) {
  std::ranges::replace(name, '/', '-');
  return name;
}

int run_challenge_make(const ChallengeArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto names, tables_of(arguments.in));
  TRY_OR(kCannotCreate, base::create_folders(arguments.out));

  std::size_t tests = 0;
  for (const std::string& table : names) {
    TRY_INIT_OR(kBadData, const auto cycle,
                with_file(path_of(arguments.in, table), analysis::stp_last_cycle));
    if (!cycle) continue;

    const std::string name = table.substr(0, table.size() - std::string_view(kTracking).size());
    TRY_STEP(write_test(path_of(arguments.in, name), path_of(arguments.out, flat(name)), *cycle,
                        arguments.force));
    ++tests;
    if (!arguments.json) fmt::print("{}  cycle {}\n", flat(name), *cycle);
  }
  if (arguments.json) {
    print_document("make", {{"matches", names.size()}, {"tests", tests}});
  } else {
    fmt::print("{} of {} matches have a test\n", tests, names.size());
  }
  return kOk;
}

Result<std::int64_t> last_row(const std::string& path) {
  TRY_INIT(const analysis::StpRow row, with_file(path, [](base::ByteSource& source) {
             return analysis::read_last_stp_row(source, StpColumns::kNumber);
           }));
  return row.number;
}

Result<analysis::StpPrediction> read_prediction(const std::string& path, StpColumns columns) {
  return with_file(path, [columns](base::ByteSource& source) {
    return analysis::read_stp_prediction(source, columns);
  });
}

// The fault of the predictions; empty: none.
std::vector<std::string> problems_of(const ChallengeArguments& arguments,
                                     const std::vector<std::string>& tests,
                                     const std::vector<std::string>& predictions) {
  std::vector<std::string> problems;
  for (const std::string& name : predictions) {
    if (!std::ranges::binary_search(tests, name)) {
      problems.push_back(fmt::format("{}: no test of this name", name));
    }
  }

  for (const std::string& name : tests) {
    if (!std::ranges::binary_search(predictions, name)) {
      problems.push_back(fmt::format("{}: no prediction of this test", name));
      continue;
    }
    const auto last = last_row(path_of(arguments.tests, name));
    const auto prediction =
        read_prediction(path_of(arguments.submission, name), StpColumns::kLeftAndBall);
    const auto wrong =
        last && prediction ? analysis::check_stp_prediction(*prediction, *last) : std::nullopt;
    if (!last) problems.push_back(last.error().message);
    if (!prediction) problems.push_back(prediction.error().message);
    if (wrong) problems.push_back(fmt::format("{}: {}", name, *wrong));
  }

  return problems;
}

int run_challenge_validate(const ChallengeArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto tests, tables_of(arguments.tests));
  TRY_INIT_OR(kNoInput, const auto predictions, tables_of(arguments.submission));
  const std::vector<std::string> problems = problems_of(arguments, tests, predictions);
  if (arguments.json) {
    print_document("validate", {{"valid", problems.empty()}, {"problems", problems}});
  } else {
    for (const std::string& problem : problems) fmt::print("{}\n", problem);
    if (problems.empty()) fmt::print("Submission is valid.\n");
  }
  return problems.empty() ? kOk : kFailed;
}

Result<analysis::StpScore> score_of(const ChallengeArguments& arguments, const std::string& name,
                                    const std::string& table) {
  TRY_INIT(const std::int64_t last, last_row(path_of(arguments.tests, name)));
  const std::string path = path_of(arguments.submission, name);
  TRY_INIT(const auto prediction, read_prediction(path, StpColumns::kAllPlaces));
  auto truth = base::open_source(table);
  if (!truth) return truth.error();
  auto score = analysis::score_stp_prediction(prediction, **truth, last);
  if (!score) return Error{fmt::format("{}: {}", path, score.error().message)};
  return score;
}

base::Json number(double value) { return std::isnan(value) ? base::Json() : base::Json(value); }

// The tables of whole matches by the name of their test: those of a tournament lie in sub-folders.
Result<std::map<std::string, std::string>> tables_by_test(const std::string& folder) {
  TRY_INIT(const auto names, tables_of(folder));
  std::map<std::string, std::string> tables;
  for (const std::string& name : names) tables.emplace(flat(name), path_of(folder, name));
  return tables;
}

int run_challenge_score(const ChallengeArguments& arguments) {
  TRY_INIT_OR(kNoInput, const auto predictions, tables_of(arguments.submission));
  TRY_INIT_OR(kNoInput, const auto tables, tables_by_test(arguments.truth));
  analysis::StpScore sum;
  auto matches = base::Json::array();
  for (const std::string& name : predictions) {
    const auto table = tables.find(flat(name));
    if (table == tables.end()) continue;
    TRY_INIT_OR(kBadData, const auto score, score_of(arguments, name, table->second));
    sum.average += score.average;
    sum.endpoint += score.endpoint;
    matches.push_back({{"name", name},
                       {"average_error", number(score.average)},
                       {"endpoint_error", number(score.endpoint)}});
  }

  if (matches.empty()) {
    return print_error(kNoInput, "{}: no table of {}", arguments.truth, arguments.submission);
  }

  const auto count = static_cast<double>(matches.size());
  if (arguments.json) {
    print_document("score", {{"average_error", number(sum.average / count)},
                             {"endpoint_error", number(sum.endpoint / count)},
                             {"matches", matches}});
  } else {
    fmt::print("Number of Evaluated Sequences: {}\nAverage Error: {:.4f}\nEndpoint Error: {:.4f}\n",
               matches.size(), sum.average / count, sum.endpoint / count);
  }

  return kOk;
}

int run_challenge_predict(const ChallengeArguments& arguments) {
  if (arguments.model != "velocity" && arguments.model != "goal") {
    return print_error(kUsage, "--model '{}': must be velocity or goal", arguments.model);
  }
  const auto model = arguments.model == "goal" ? StpModel::kGoal : StpModel::kVelocity;
  TRY_INIT_OR(kNoInput, const auto tests, tables_of(arguments.tests));
  for (const std::string& name : tests) {
    TRY_INIT_OR(kBadData, const auto last,
                with_file(path_of(arguments.tests, name), [](base::ByteSource& source) {
                  return analysis::read_last_stp_row(source, StpColumns::kMotion);
                }));
    const fs::path out = path_of(arguments.out, name);
    TRY_OR(kCannotCreate, base::create_folders(out.parent_path()));
    TRY_STEP(report_failure(why_not_replaced(out, arguments.force)));

    TRY_STEP(report_failure(write_output(out, [&](base::ByteSink& sink) {
      sink.write(analysis::format_stp_prediction(analysis::predict_stp(model, last)));
      return true;
    })));
  }

  if (arguments.json) {
    print_document("predict", {{"model", arguments.model}, {"tests", tests.size()}});
  } else {
    fmt::print("{} predictions\n", tests.size());
  }

  return kOk;
}

void add_make_command(Command& stp) {
  auto [command, arguments] = stp.command(
      "make",
      "make tests: matches up to 30 cycles before a goal of the left team\n"
      "IN is a folder of tables. A match with a goal that 50 frames of play_on precede\n"
      "is a test; its logs, if IN has them, are shortened, too.\n"
      "\n"
      "  cls convert cup --tables csv\n"
      "  cls challenge stp make csv tests",
      run_challenge_make);
  command.option("IN", arguments.in, "folder with the tables of whole matches").required();
  command.option("OUT", arguments.out, "folder for the tests").required();
  command.flag("--force", arguments.force, "replace existing files");
  command.flag("--json", arguments.json, "print the numbers as one JSON document")
      .of_group(kOutputGroup);
}

void add_predict_command(Command& stp) {
  auto [command, arguments] = stp.command("predict",
                                          "write the predictions of a baseline\n"
                                          "\n"
                                          "  cls challenge stp predict tests mine\n"
                                          "  cls challenge stp predict tests mine --model velocity",
                                          run_challenge_predict);
  command.option("TESTS", arguments.tests, "folder with tests").required();
  command.option("OUT", arguments.out, "folder for the predictions").required();
  command.setting("--model", arguments.model,
                  "velocity (all keep theirs) or goal (the ball runs into it)");
  command.flag("--force", arguments.force, "replace existing files");
  command.flag("--json", arguments.json, "print the numbers as one JSON document")
      .of_group(kOutputGroup);
}

void add_validate_command(Command& stp) {
  auto [command, arguments] = stp.command("validate",
                                          "check that predictions are complete\n"
                                          "\n"
                                          "  cls challenge stp validate tests mine\n"
                                          "\n"
                                          "Exit code: 0 if they are, 1 if not.",
                                          run_challenge_validate);
  command.option("TESTS", arguments.tests, "folder with tests").required();
  command.option("SUBMISSION", arguments.submission, "folder with predictions").required();
  command.flag("--json", arguments.json, "print the problems as one JSON document")
      .of_group(kOutputGroup);
}

void add_score_command(Command& stp) {
  auto [command, arguments] = stp.command("score",
                                          "measure predictions by the whole matches\n"
                                          "\n"
                                          "  cls challenge stp score csv tests mine",
                                          run_challenge_score);
  command.option("TRUTH", arguments.truth, "folder with the tables of whole matches").required();
  command.option("TESTS", arguments.tests, "folder with tests").required();
  command.option("SUBMISSION", arguments.submission, "folder with predictions").required();
  command.flag("--json", arguments.json, "print the errors as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace

void add_challenge_command(Command& app) {
  Command& command = app.command(
      "challenge",
      "tests and scores of public challenges\n"
      "\n"
      "  cls convert cup --tables csv\n"
      "  cls challenge stp make csv tests               matches that end before a goal\n"
      "  cls challenge stp predict tests mine           a baseline\n"
      "  cls challenge stp validate tests mine\n"
      "  cls challenge stp score csv tests mine         mean error in meters");
  command.group = kResultCommands;

  Command& stp =
      command.command("stp",
                      "the trajectory challenge: where will ball and players be at the goal?\n"
                      "\n"
                      "  cls challenge stp make csv tests\n"
                      "  cls challenge stp predict tests mine\n"
                      "  cls challenge stp validate tests mine\n"
                      "  cls challenge stp score csv tests mine");
  add_make_command(stp);

  add_predict_command(stp);
  add_validate_command(stp);
  add_score_command(stp);
}

}  // namespace cls::cli
