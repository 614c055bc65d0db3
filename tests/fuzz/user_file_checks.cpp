// One check per kind of file.
#include "tests/fuzz/user_file_checks.h"

#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/delimited_message_util.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "analysis/situations/book_file.h"
#include "base/index.h"
#include "base/io/byte_sink.h"
#include "base/io/gzip_sink.h"
#include "base/system/unique_fd.h"
#include "base/text/json.h"
#include "base/text/json_document.h"
#include "league/schedule/schedule.h"
#include "league/schedule/schedule_check.h"
#include "match/result/match_result.h"
#include "match/saved/saved_match.h"
#include "match/terms/planner_file.h"
#include "mock-server/script/named_behaviors.h"
#include "mock-server/script/script.h"
#include "player/formation/formation_file.h"
#include "player/world/planner_parameters.h"
#include "proto/playmaker.pb.h"
#include "proto/recording_file.h"
#include "proto/saved_match.pb.h"
#include "scenario/scenario_file.h"
#include "tests/fuzz/require.h"
#include "tournament/config/config.h"
#include "tournament/config/config_file.h"
#include "tournament/store/match_document.h"
#include "tournament/tuning/tune_config.h"
#include "training/policy/policy.h"

namespace cls::tests {
namespace {

void check_scenario(const std::string& text) {
  const auto document = base::JsonDocument::parse("scenario.json", text);
  if (!document) return;
  const auto scenario = scenario::parse_scenario(*document, base::Json());
  require(scenario.ok() || !scenario.error().message.empty());
}

void check_script(const std::string& text) {
  const auto document = base::JsonDocument::parse("script.json", text);
  if (!document) return;
  // Files that it names are not those of the fuzzer.
  if (text.find("replay:") != std::string::npos) return;
  const auto script = mock_server::parse_script(base::JsonValue(*document));
  if (!script) return;
  const mock_server::ScriptedBehavior behavior(*script);
  protos::State state;
  state.mutable_world_model()->set_cycle(1);
  protos::PlayerActions player;
  protos::CoachActions coach;
  protos::TrainerActions trainer;
  behavior.decide(state, player);
  behavior.decide_as_coach(state, coach);
  behavior.decide_as_trainer(state, trainer);
}

void check_formation(const std::string& text) {
  const auto formation = player::parse_formation(text, "fuzz");
  if (!formation) return;
  const std::string written = player::format_formation(*formation);
  const auto again = player::parse_formation(written, "fuzz");
  require(again.ok());
  require(player::format_formation(*again) == written);
}

void check_config(const std::string& text) {
  using namespace tournament;
  const ParsedConfig parsed = parse_config(text, "cls.toml");
  if (!parsed.errors.empty() || !validate(parsed.config).empty()) return;
  const ParsedConfig again = parse_config(format_config(parsed.config), "cls.toml");
  require(again.errors.empty());
  require(first_difference(parsed.config, again.config).empty());
  constexpr std::size_t kFewTeams = 16;
  constexpr int kFewRounds = 20;
  if (parsed.config.competition.teams.size() > kFewTeams ||
      rounds_of(parsed.config.competition) > kFewRounds)
    return;
  for (const Fixture& fixture : next_fixtures(parsed.config.competition, {})) {
    require(check_teams(parsed.config.competition, fixture).ok());
  }
}

void check_tune_config(const std::string& text) {
  using namespace tournament;
  const ParsedTuneConfig parsed = parse_tune_config(text, kTuneFile);
  if (!parsed.errors.empty()) return;
  require(!parsed.config.parameters.empty());
  require(!plan_lines(parsed.config).empty());
}

void check_planner_file(const std::string& text) {
  const auto parameters = match::parse_planner_file(text, "planner.toml");
  if (!parameters) return require(!parameters.error().message.empty());
  for (const player::PlannerParameter& row : player::planner_parameter_table()) {
    const double value = value_of(**parameters, row);
    require(value >= row.low && value <= row.high);
  }
}

/// A compressed file in memory, for functions that read files.
class MemoryFile {
 public:
  explicit MemoryFile(std::string_view content) : fd_(::memfd_create("fuzz", MFD_CLOEXEC)) {
    auto out = std::make_unique<base::StringSink>();
    const base::StringSink& compressed = *out;
    base::GzipSink gzip(std::move(out), 1);
    gzip.write(content);
    require(gzip.close().ok());
    const std::string& bytes = compressed.bytes();
    require(::write(fd_.get(), bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
  }
  std::string path() const { return "/proc/self/fd/" + std::to_string(fd_.get()); }

 private:
  base::UniqueFd fd_;
};

// What the text format of `Message` says, with the length in front.
template <typename Message>
std::string delimited(const std::string& text) {
  Message message;
  google::protobuf::TextFormat::Parser parser;
  parser.AllowPartialMessage(true);
  parser.ParseFromString(text, &message);
  std::ostringstream out;
  google::protobuf::util::SerializeDelimitedToOstream(message, &out);
  return out.str();
}

// A header and calls in protobuf's text format, with lines of "--" in between.
std::string recording_of(const std::string& text) {
  constexpr std::string_view kBorder = "\n--\n";
  std::size_t end = text.find(kBorder);
  std::string bytes = delimited<recording::RecordingHeader>(text.substr(0, end));
  while (end != std::string::npos) {
    const std::size_t begin = end + kBorder.size();
    end = text.find(kBorder, begin);
    bytes += delimited<recording::RecordedCall>(text.substr(begin, end - begin));
  }
  return bytes;
}

void check_recording(const std::string& bytes) {
  const MemoryFile file(bytes);
  std::string error;
  const auto reader = proto::RecordingReader::open(file.path(), error);
  if (reader == nullptr) return require(!error.empty());
  recording::RecordedCall call;
  std::size_t calls = 0;
  while (reader->next(call)) ++calls;
  require(calls <= bytes.size());
  const auto replay = mock_server::make_behavior("replay:" + file.path());
  require(replay.ok() == reader->parse_error().empty());
  if (!replay) return;
  protos::PlayerActions actions;
  (*replay)->decide(protos::State(), actions);
}

void check_saved_match(const std::string& bytes) {
  const MemoryFile file(bytes);
  const auto match = match::read_saved_match(file.path());
  if (!match) return require(!match.error().message.empty());
  match::MatchOptions options;
  const auto resumed = match::resume_from(*match, options);
  require(resumed.ok() || !resumed.error().message.empty());
  require(options.on_late <= proxy::OnLate::kDefault);
  for (const soccer::Side side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    match::replies_of(**match, side);
  }
}

std::string saved_match_of(const std::string& text) {
  saved::SavedMatch match;
  google::protobuf::TextFormat::Parser parser;
  parser.AllowPartialMessage(true);
  parser.ParseFromString(text, &match);
  return match.SerializePartialAsString();
}

void check_book(const std::string& text) {
  using namespace match;
  const auto book = analysis::parse_book(text);
  if (!book) return require(!book.error().message.empty());
  const auto bytes = [](const analysis::Book& one) {
    base::StringSink out;
    analysis::write_book(one, out);
    return out.bytes();
  };
  const std::string written = bytes(*book);
  const auto again = analysis::parse_book(written);
  require(again.ok() && bytes(*again) == written);
  constexpr int kMany = 100;
  require(!analysis::situations_of(*book, 1, kMany).empty());
}

// A header and, behind a line of "--", weights as they are in the file.
void check_policy(const std::string& text) {
  constexpr std::string_view kBorder = "\n--\n";
  const std::size_t end = text.find(kBorder);
  const std::string header = text.substr(0, end);
  std::string bytes = "CLSPOL2\n";
  for (std::size_t i = 0; i < 4; ++i) bytes += static_cast<char>(header.size() >> (8 * i) & 0xff);
  bytes += header;
  if (end != std::string::npos) bytes += text.substr(end + kBorder.size());

  const auto policy = training::parse_policy(bytes, "fuzz.policy");
  if (!policy) return require(!policy.error().message.empty());
  const training::Network& network = policy->network;
  const std::vector<float> features(base::index(network.features()), 1.0F);
  std::vector<float> memory(base::index(network.memory()));
  training::Network::Workspace workspace;
  require(network.run(features.data(), memory.data(), workspace) != nullptr);
}

// Lines of schedules, rows of the store, results of matches.
void check_record(const std::string& text) {
  using namespace tournament;
  if (const auto fixture = parse_fixture(text)) {
    const std::string written = format_fixture(*fixture);
    const auto again = parse_fixture(written);
    require(again.ok() && format_fixture(*again) == written);
  }
  if (const auto outcome = parse_outcome(text)) {
    const std::string written = format_outcome(*outcome);
    const auto again = parse_outcome(written);
    require(again.ok() && format_outcome(*again) == written);
  }
  if (const auto work = parse_work_result(text)) {
    static_cast<void>(parse_outcome(format_outcome(work->outcome)));
  }
  if (const auto result = match::parse_match_result(text)) {
    static_cast<void>(parse_outcome(format_outcome(outcome_of(*result))));
  }
}

}  // namespace

void check_user_file(std::string_view input) {
  google::protobuf::LogSilencer no_complaints;
  if (input.empty()) return;
  const std::string text(input.substr(1));

  switch (input.front()) {
    case 's':
      return check_scenario(text);
    case 'm':
      return check_script(text);
    case 'f':
      return check_formation(text);
    case 'l':
      player::parse_librcsc_formation(text, "fuzz").ok();
      return;
    case 't':
      return check_config(text);
    case 'u':
      return check_tune_config(text);
    case 'p':
      return check_planner_file(text);
    case 'r':
      return check_recording(recording_of(text));
    case 'R':
      return check_recording(text);
    case 'v':
      return check_saved_match(saved_match_of(text));
    case 'V':
      return check_saved_match(text);
    case 'b':
      return check_book(text);
    case 'e':
      return check_record(text);
    case 'y':
      return check_policy(text);
    default:
      return;
  }
}

}  // namespace cls::tests
