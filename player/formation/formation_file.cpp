// The cls-formation format: parser and writer; detection of the format.
#include "player/formation/formation_file.h"

#include <fmt/format.h>

#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/index.h"
#include "player/formation/text_lines.h"

namespace cls::player {
namespace {

using base::Error;
using base::Result;

constexpr std::string_view kHeader = "cls-formation";

/// Partner of each player in the mirror image, by unum - 1.
using Pairs = std::array<std::size_t, soccer::kPlayersPerTeam>;

FormationSample mirrored(const FormationSample& sample, const Pairs& pairs) {
  const auto flip = [](Vec2 v) { return Vec2{v.x, -v.y}; };
  FormationSample other;
  other.ball = flip(sample.ball);
  for (std::size_t i = 0; i < pairs.size(); ++i) other.players[pairs[i]] = flip(sample.players[i]);
  return other;
}

class ClsFormatParser {
 public:
  explicit ClsFormatParser(TextLines& lines) : lines_(lines) {
    std::iota(pairs_.begin(), pairs_.end(), std::size_t{0});
  }

  Result<std::vector<FormationSample>> read() {
    while (lines_.next()) {
      const std::vector<std::string_view> tokens = lines_.tokens();
      TRY(parse_line(tokens));
    }
    TRY(finish_sample());
    return add_mirrored();
  }

 private:
  Result<void> parse_line(const std::vector<std::string_view>& tokens) {
    if (tokens.front() == "mirror" && tokens.size() == 1) {
      mirror_ = true;
      return {};
    }

    if (tokens.front() == "pair") return parse_pair(tokens);
    if (tokens.front() == "ball") {
      TRY(finish_sample());
      const auto point = TextLines::parse_point(tokens, 1, 3);
      if (!point) return lines_.error("expected 'ball X Y'");
      open_ = true;
      sample_ = {};
      placed_ = {};
      sample_.ball = *point;
      return {};
    }

    const std::optional<int> unum = lines_.parse_unum(tokens.front());
    const auto point = TextLines::parse_point(tokens, 1, 3);
    if (!unum || !point) {
      return lines_.error("expected 'ball X Y', 'UNUM X Y', 'pair UNUM UNUM' or 'mirror'");
    }

    if (!open_) return lines_.error("player before the first 'ball X Y'");
    const std::size_t index = base::index(*unum - 1);
    if (std::exchange(placed_[index], true)) {
      return lines_.error(fmt::format("duplicate player {}", *unum));
    }

    sample_.players[index] = *point;
    return {};
  }

  Result<void> parse_pair(const std::vector<std::string_view>& tokens) {
    const auto first = tokens.size() == 3 ? lines_.parse_unum(tokens[1]) : std::nullopt;
    const auto second = tokens.size() == 3 ? lines_.parse_unum(tokens[2]) : std::nullopt;
    if (!first || !second || *first == *second) return lines_.error("expected 'pair UNUM UNUM'");

    const std::size_t a = base::index(*first - 1);
    const std::size_t b = base::index(*second - 1);
    if (pairs_[a] != a || pairs_[b] != b) return lines_.error("player already has a partner");
    pairs_[a] = b;
    pairs_[b] = a;
    return {};
  }

  Result<void> finish_sample() {
    if (!std::exchange(open_, false)) return {};
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      if (!placed_[i]) return lines_.error(fmt::format("missing player {} in the sample", i + 1));
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

Result<std::vector<FormationSample>> parse_samples(std::string_view text, const std::string& name) {
  TextLines lines(text, name);
  if (!lines.next()) return Error{name + ": empty"};
  const std::vector<std::string_view> tokens = lines.tokens();

  if (tokens.front() == kHeader) {
    if (tokens.size() != 2 || tokens[1] != "1") {
      return lines.error("unsupported version; use cls-formation 1");
    }
    return ClsFormatParser(lines).read();
  }
  return parse_librcsc_formation(text, name);
}

}  // namespace

Result<Formation> parse_formation(std::string_view text, const std::string& name) {
  TRY_INIT(auto samples, parse_samples(text, name));
  Result<Formation> formation = Formation::make(std::move(samples));
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

}  // namespace cls::player
