// Reads and writes books: a line of JSON for the book, and one for each situation.
#include "analysis/situations/book_file.h"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

#include "base/index.h"
#include "base/io/byte_source.h"
#include "base/text/json.h"
#include "base/text/json_text.h"
#include "base/text/lines.h"

namespace cls::analysis {
namespace {

using base::Error;
using base::Json;
using base::Result;
using soccer::Vec2;

constexpr const char* kFormat = "cls.book/1";
/// Of lengths, rates and times of player types: no server gives more.
constexpr double kMaxTypeValue = 200.0;
// No ball or player of a match is beyond these.
constexpr double kMaxPosition = 200.0;
constexpr double kMaxSpeed = 20.0;
constexpr double kMaxDegrees = 360.0;
constexpr double kMaxStamina = 1e7;
constexpr int kMaxTime = 1'000'000;
constexpr std::size_t kMaxLogs = 10'000;
constexpr std::size_t kMaxTypes = 128;
constexpr std::size_t kNumbersOfBall = 4;
constexpr std::size_t kNumbersOfPlayer = 5;

// A problem of a line; parse_line() adds its number.
[[noreturn]] void fail(const std::string& what) { throw std::runtime_error(what); }

const Json& member(const Json& object, const char* key) {
  const Json* found = object.find(key);
  if (found == nullptr) fail(fmt::format("'{}' is missing", key));
  return *found;
}

const Json& list(const Json& object, const char* key, std::size_t size) {
  const Json& value = member(object, key);
  if (!value.is_array()) fail(fmt::format("'{}' is not a list", key));
  if (value.size() != size) {
    fail(fmt::format("'{}' has {} elements instead of {}", key, value.size(), size));
  }
  return value;
}

const Json& list_up_to(const Json& object, const char* key, std::size_t max) {
  const Json& value = member(object, key);
  if (!value.is_array()) fail(fmt::format("'{}' is not a list", key));
  if (value.empty() || value.size() > max) {
    fail(fmt::format("'{}' has {} elements; 1 to {} are allowed", key, value.size(), max));
  }
  return value;
}

double number(const Json& value, const char* key, double min, double max) {
  if (!value.is_number()) fail(fmt::format("'{}' has a value that is not a number", key));
  const double read = value.get<double>();
  if (!(read >= min && read <= max)) {
    fail(fmt::format("'{}': {:g} is not between {:g} and {:g}", key, read, min, max));
  }
  return read;
}

int whole(const Json& value, const char* key, int min, int max) {
  if (!value.is_number_integer()) fail(fmt::format("'{}' has a value that is not whole", key));
  return static_cast<int>(number(value, key, min, max));
}

std::string text(const Json& object, const char* key) {
  const Json& value = member(object, key);
  if (!value.is_string()) fail(fmt::format("'{}' is not a text", key));
  return value.get<std::string>();
}

// Values of a list of numbers, one after the other.
class Numbers {
 public:
  Numbers(const Json& list, const char* key) : list_(list), key_(key) {}
  double next(double max) { return number(list_[at_++], key_, -max, max); }
  Vec2 point(double max) {
    const double x = next(max);
    return {x, next(max)};
  }

 private:
  const Json& list_;
  const char* key_;
  std::size_t at_ = 0;
};

soccer::PlayerType parse_type(const Json& object) {
  if (!object.is_object()) fail("'types' has a value that is not an object");
  soccer::PlayerType type;
  for (const auto& row : soccer::player_type_table()) {
    const std::string key(row.name);
    const Json& value = member(object, key.c_str());
    const double read = number(value, key.c_str(), 0.0, kMaxTypeValue);
    std::visit(
        [&](auto target) {
          using Value = std::remove_reference_t<decltype(type.*target)>;
          if constexpr (std::is_arithmetic_v<Value>) type.*target = static_cast<Value>(read);
        },
        row.member);
  }
  return type;
}

BookLog parse_log(const Json& object) {
  if (!object.is_object()) fail("'logs' has a value that is not an object");
  BookLog log;
  log.name = text(object, "name");
  const Json& teams = list(object, "teams", 2);
  for (std::size_t i = 0; i < log.teams.size(); ++i) {
    if (!teams[i].is_string()) fail("'teams' has a value that is not a text");
    log.teams[i] = teams[i].get<std::string>();
  }
  for (const Json& type : list_up_to(object, "types", kMaxTypes)) {
    log.types.push_back(parse_type(type));
  }
  return log;
}

void parse_header(const Json& object, Book& book) {
  if (const std::string format = text(object, "format"); format != kFormat) {
    fail(fmt::format("format '{}' is unknown; this version reads {}", format, kFormat));
  }
  const Json& seed = member(object, "seed");
  if (!seed.is_number_unsigned()) fail("'seed' has a value that is not whole");
  book.seed = seed.get<std::uint64_t>();
  book.warm_up = whole(member(object, "warm_up"), "warm_up", 0, kMaxWarmUp);
  for (const Json& log : list_up_to(object, "logs", kMaxLogs)) book.logs.push_back(parse_log(log));
}

soccer::PlayMode parse_mode(const std::string& text) {
  const auto mode = soccer::parse_play_mode(text);
  if (!mode) fail(fmt::format("'mode': '{}' is not a play mode", text));
  const bool plays = *mode == soccer::PlayMode::kPlayOn || soccer::is_set_play(*mode);
  if (!plays) fail(fmt::format("'mode': a situation cannot begin in {}", text));
  return *mode;
}

BookStamina parse_stamina(const Json& values, std::size_t types) {
  if (!values.is_array() || values.size() != kNumbersOfPlayer) {
    fail("'players' needs five numbers for each player");
  }
  return {.type = whole(values[0], "players", 0, static_cast<int>(types) - 1),
          .stamina = number(values[1], "players", 0.0, kMaxStamina),
          .effort = number(values[2], "players", 0.0, 1.0),
          .recovery = number(values[3], "players", 0.0, 1.0),
          .capacity = number(values[4], "players", -1.0, kMaxStamina)};
}

BookFrame parse_frame(const Json& values) {
  constexpr std::size_t kSize = kNumbersOfBall + kNumbersOfPlayer * soccer::kPlayersOnPitch;
  if (!values.is_array() || values.size() != kSize) {
    fail(fmt::format("'frames' needs {} numbers for each step", kSize));
  }

  Numbers read(values, "frames");
  BookFrame frame;
  frame.ball = read.point(kMaxPosition);
  frame.ball_velocity = read.point(kMaxSpeed);
  for (BookPlayer& player : frame.players) {
    player.position = read.point(kMaxPosition);
    player.velocity = read.point(kMaxSpeed);
    player.body = read.next(kMaxDegrees);
  }
  return frame;
}

Situation parse_situation(const Json& object, const Book& book) {
  if (!object.is_object()) fail("a situation is an object");
  Situation situation;
  const std::string kind = text(object, "class");
  const auto parsed = parse_situation_class(kind);
  if (!parsed) fail(fmt::format("'class': '{}' is not a class of situations", kind));
  situation.kind = *parsed;

  const int last_log = static_cast<int>(book.logs.size()) - 1;
  situation.log = whole(member(object, "log"), "log", 0, last_log);
  situation.time = whole(member(object, "time"), "time", 0, kMaxTime);

  const Json& score = list(object, "score", 2);
  for (std::size_t i = 0; i < 2; ++i) situation.score[i] = whole(score[i], "score", 0, kMaxTime);
  situation.mode = parse_mode(text(object, "mode"));

  const std::size_t types = book.logs[base::index(situation.log)].types.size();
  const Json& players = list(object, "players", soccer::kPlayersOnPitch);
  for (std::size_t i = 0; i < players.size(); ++i) {
    situation.players[i] = parse_stamina(players[i], types);
  }
  for (const Json& frame : list(object, "frames", base::index(book.warm_up) + 1)) {
    situation.frames.push_back(parse_frame(frame));
  }
  return situation;
}

void parse_line(std::string_view line, Book& book, bool first) {
  const Json object = Json::parse_or_discarded(line);
  if (first) {
    if (!object.is_object()) fail("not a book of situations");
    return parse_header(object, book);
  }

  if (object.is_discarded()) fail("not a line of JSON");
  if (book.situations.size() >= kMaxSituations) {
    fail(fmt::format("more than {} situations", kMaxSituations));
  }
  book.situations.push_back(parse_situation(object, book));
}

void append(std::string& to, Vec2 v) {
  fmt::format_to(std::back_inserter(to), ",{:.6g},{:.6g}", v.x, v.y);
}

std::string format_frame(const BookFrame& frame) {
  std::string numbers;
  append(numbers, frame.ball);
  append(numbers, frame.ball_velocity);
  for (const BookPlayer& player : frame.players) {
    append(numbers, player.position);
    append(numbers, player.velocity);
    fmt::format_to(std::back_inserter(numbers), ",{:.6g}", player.body);
  }
  numbers.front() = '[';
  return numbers + "]";
}

Json json_of(const BookLog& log) {
  Json types = Json::array();
  for (const soccer::PlayerType& type : log.types) {
    Json object = Json::object();
    for (const auto& row : soccer::player_type_table()) {
      std::visit([&](auto member) { object[std::string(row.name)] = type.*member; }, row.member);
    }
    types.push_back(std::move(object));
  }
  return {{"name", log.name}, {"teams", log.teams}, {"types", std::move(types)}};
}

std::string format_situation(const Situation& situation) {
  std::string line = fmt::format(
      "{{\"class\":\"{}\",\"log\":{},\"time\":{},\"score\":[{},{}],\"mode\":\"{}\",\"players\":",
      name(situation.kind), situation.log, situation.time, situation.score[0], situation.score[1],
      soccer::name(situation.mode));

  char before = '[';
  for (const BookStamina& player : situation.players) {
    fmt::format_to(std::back_inserter(line), "{}[{},{:.6g},{:.6g},{:.6g},{:.6g}]", before,
                   player.type, player.stamina, player.effort, player.recovery, player.capacity);
    before = ',';
  }

  line += "],\"frames\":";
  before = '[';
  for (const BookFrame& frame : situation.frames) {
    line += before;
    line += format_frame(frame);
    before = ',';
  }
  return line + "]}\n";
}

}  // namespace

Result<Book> parse_book(std::string_view text) {
  Book book;
  int number = 0;
  for (const std::string_view line : base::lines_of(text)) {
    ++number;
    try {
      parse_line(line, book, number == 1);
    } catch (const std::exception& problem) {
      return Error{fmt::format("line {}: {}", number, problem.what())};
    }
  }
  if (number == 0) return Error{"the file is empty"};
  if (book.situations.empty()) return Error{"the book has no situations"};
  return book;
}

Result<Book> read_book(const std::string& file) {
  TRY_INIT(const auto source, base::open_source(file));
  const std::string text = base::read_all(*source);
  if (!source->error().empty()) return Error{fmt::format("{}: {}", file, source->error())};
  auto book = parse_book(text);
  if (!book) return Error{fmt::format("{}: {}", file, book.error().message)};
  return book;
}

void write_book(const Book& book, base::ByteSink& out) {
  Json header = {{"format", kFormat}, {"seed", book.seed}, {"warm_up", book.warm_up}};
  header["logs"] = Json::array();
  for (const BookLog& log : book.logs) header["logs"].push_back(json_of(log));
  out.write(base::json_line(header) + "\n");
  for (const Situation& situation : book.situations) out.write(format_situation(situation));
}

}  // namespace cls::analysis
