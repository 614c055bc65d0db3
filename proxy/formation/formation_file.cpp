// Our own form of formation files, the choice of the form, and the writer.
#include "proxy/formation/formation_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "proxy/formation/foreign_formation.h"
#include "proxy/formation/text_lines.h"

namespace cls::proxy {
namespace {

using base::Error;
using base::Result;
using soccer::Vec2;

constexpr std::string_view kHeader = "cls-formation";

/// Who stands in for whom on the other side of the pitch, by unum - 1.
using Pairs = std::array<std::size_t, soccer::kPlayersPerTeam>;

FormationSample mirrored(const FormationSample& sample, const Pairs& pairs) {
  const auto flip = [](Vec2 v) { return Vec2{v.x, -v.y}; };
  FormationSample other;
  other.ball = flip(sample.ball);
  for (std::size_t i = 0; i < pairs.size(); ++i) other.players[pairs[i]] = flip(sample.players[i]);
  return other;
}

class OwnFormReader {
 public:
  explicit OwnFormReader(TextLines& lines) : lines_(lines) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) pairs_[i] = i;
  }

  Result<std::vector<FormationSample>> read() {
    while (lines_.next()) {
      const std::vector<std::string_view> words = lines_.words();
      if (const Result<void> done = take(words); !done) return done.error();
    }
    if (const Result<void> done = finish_sample(); !done) return done.error();
    return add_mirrored();
  }

 private:
  Result<void> take(const std::vector<std::string_view>& words) {
    if (words.front() == "mirror" && words.size() == 1) {
      mirror_ = true;
      return {};
    }
    if (words.front() == "pair") return take_pair(words);
    if (words.front() == "ball") {
      if (const Result<void> done = finish_sample(); !done) return done;
      const auto point = words.size() == 3 ? lines_.point(words[1], words[2]) : std::nullopt;
      if (!point) return lines_.error("expected 'ball X Y'");
      open_ = true;
      sample_ = {};
      placed_ = {};
      sample_.ball = *point;
      return {};
    }
    const std::optional<int> unum = lines_.unum(words.front());
    const auto point = words.size() == 3 ? lines_.point(words[1], words[2]) : std::nullopt;
    if (!unum || !point) {
      return lines_.error("expected 'ball X Y', 'UNUM X Y', 'pair UNUM UNUM' or 'mirror'");
    }
    if (!open_) return lines_.error("a player before the first 'ball X Y'");
    const auto index = static_cast<std::size_t>(*unum - 1);
    if (std::exchange(placed_[index], true)) {
      return lines_.error(fmt::format("player {} for the second time", *unum));
    }
    sample_.players[index] = *point;
    return {};
  }

  Result<void> take_pair(const std::vector<std::string_view>& words) {
    const auto first = words.size() == 3 ? lines_.unum(words[1]) : std::nullopt;
    const auto second = words.size() == 3 ? lines_.unum(words[2]) : std::nullopt;
    if (!first || !second || *first == *second) return lines_.error("expected 'pair UNUM UNUM'");
    const auto a = static_cast<std::size_t>(*first - 1);
    const auto b = static_cast<std::size_t>(*second - 1);
    if (pairs_[a] != a || pairs_[b] != b) return lines_.error("a player has one partner only");
    pairs_[a] = b;
    pairs_[b] = a;
    return {};
  }

  Result<void> finish_sample() {
    if (!std::exchange(open_, false)) return {};
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (!placed_[i]) return lines_.error(fmt::format("a sample without player {}", i + 1));
    }
    samples_.push_back(sample_);
    return {};
  }

  Result<std::vector<FormationSample>> add_mirrored() {
    const std::size_t written = mirror_ ? samples_.size() : 0;
    for (std::size_t i = 0; i < written; ++i) {
      if (samples_[i].ball.y != 0.0) samples_.push_back(mirrored(samples_[i], pairs_));
    }
    return std::move(samples_);
  }

  TextLines& lines_;
  Pairs pairs_{};
  bool mirror_ = false;
  bool open_ = false;
  FormationSample sample_;
  std::array<bool, soccer::kPlayersPerTeam> placed_{};
  std::vector<FormationSample> samples_;
};

Result<std::vector<FormationSample>> read_samples(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  if (!lines.next()) return Error{name + ": empty"};
  const std::vector<std::string_view> words = lines.words();
  if (words.front() == kHeader) {
    if (words.size() != 2 || words[1] != "1") {
      return lines.error("only version 1 of cls-formation is known");
    }
    return OwnFormReader(lines).read();
  }
  return read_foreign_formation(text, name);
}

}  // namespace

Result<Formation> parse_formation(std::string_view text, const std::string& name) {
  Result<std::vector<FormationSample>> samples = read_samples(text, name);
  if (!samples) return samples.error();
  Result<Formation> formation = Formation::make(std::move(*samples));
  if (!formation) return Error{name + ": " + formation.error().message};
  return formation;
}

std::string format_formation(const Formation& formation) {
  std::string text = fmt::format("{} 1\n", kHeader);
  for (const FormationSample& sample : formation.samples()) {
    text += fmt::format("\nball {} {}\n", sample.ball.x, sample.ball.y);
    for (std::size_t i = 0; i < sample.players.size(); ++i) {
      text += fmt::format("  {} {} {}\n", i + 1, sample.players[i].x, sample.players[i].y);
    }
  }
  return text;
}

}  // namespace cls::proxy
