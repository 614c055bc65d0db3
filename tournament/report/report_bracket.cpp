// Walks the ties of a bracket.
#include "tournament/report/report_bracket.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "base/text/wrap_text.h"
#include "base/text/xml.h"
#include "league/matches/stage_name.h"

namespace cls::tournament {
namespace {

bool has_bye(const BracketTie& tie) { return tie.entrants[0].bye || tie.entrants[1].bye; }

// Where the entrant was decided: follows winners through ties with a bye, in which they did not
// play.
Entrant origin(const Report& report, Entrant entrant) {
  while (entrant.tie >= 0 && entrant.winner) {
    const BracketTie& tie = report.bracket[base::index(entrant.tie)];
    if (!has_bye(tie)) break;
    entrant = tie.entrants[tie.entrants[0].bye ? 1 : 0];
  }
  return entrant;
}

// The team, or "winner of semi-final 1".
std::string entrant_text(const Report& report, const Entrant& entrant) {
  if (entrant.team) return report.team(*entrant.team);
  if (entrant.bye) return "bye";
  const Entrant from = origin(report, entrant);
  if (from.tie < 0) return "?";
  return fmt::format("{} of {}", from.winner ? "winner" : "loser",
                     report.bracket[base::index(from.tie)].stage);
}

std::vector<ScheduledMatch> matches_of(const Report& report, const BracketTie& tie) {
  std::vector<ScheduledMatch> found;
  std::ranges::copy_if(report.matches, std::back_inserter(found),
                       [&tie](const auto& match) { return match.fixture.stage == tie.stage; });
  return found;
}

// "2:1, 2:2 (4:3 pen)", as `team` sees it.
std::string scores_text(const Report& report, const BracketTie& tie, int team) {
  std::string text;
  for (const ScheduledMatch& match : matches_of(report, tie)) {
    if (!match.outcome) continue;
    text +=
        (text.empty() ? "" : ", ") + score_text(*report.config, match, match.fixture.right == team);
  }
  return text + (tie.by_lot ? ", by lot" : "");
}

// "final: RED beats BLUE 2:1, 0:0", "semi-final 1: RED - winner of quarter-final 2".
std::string tie_text(const Report& report, const BracketTie& tie) {
  Entrant first = tie.entrants[0];
  Entrant second = tie.entrants[1];
  if (tie.winner && second.team == tie.winner) std::swap(first, second);
  std::string text = fmt::format("{}: {} {} {}", tie.stage, entrant_text(report, first),
                                 tie.winner ? "beats" : "-", entrant_text(report, second));
  if (first.team && second.team) text += " " + scores_text(report, tie, *first.team);
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

class Tree {
 public:
  Tree(const Report& report, std::size_t width) : report_(report), width_(width) {}

  std::string text() {
    for (int tie = static_cast<int>(report_.bracket.size()) - 1; tie >= 0; --tie) {
      add(tie, "", "", "");
    }
    return std::move(text_);
  }

 private:
  // `lead` precedes the tie's line, `next` its further lines, `below` the lines of its children.
  void add(int index, const std::string& lead, const std::string& next, const std::string& below) {
    const BracketTie& tie = report_.bracket[base::index(index)];
    if (!visited_.insert(index).second || has_bye(tie)) return;

    constexpr std::size_t kMinWidth = 24;
    std::string lines = base::wrap_text(
        tie_text(report_, tie), std::max(kMinWidth, width_ - std::min(width_, lead.size())));

    std::string separator = lead;
    for (std::size_t end = 0; end != std::string::npos; lines.erase(0, end + 1)) {
      end = lines.find('\n');
      text_ += std::exchange(separator, next) + lines.substr(0, end) + '\n';
      if (end == std::string::npos) break;
    }

    std::vector<int> children;
    for (const Entrant& entrant : tie.entrants) {
      const Entrant from = origin(report_, entrant);
      const bool child = from.tie >= 0 && from.winner;
      if (child && !visited_.contains(from.tie)) children.push_back(from.tie);
    }

    for (const int child : children) {
      const std::string bar = child == children.back() ? "   " : "|  ";
      add(child, below + "|- ", below + bar + "   ", below + bar);
    }
  }

  const Report& report_;
  std::size_t width_;
  std::set<int> visited_;
  std::string text_;
};

// "quarter-finals" of "quarter-final 2", "losers' round 1" of "losers' round 1, tie 3".
std::string round_title(const std::string& stage) {
  for (const char* name : {", quarter-final ", ", semi-final "}) {
    if (const std::size_t at = stage.find(name); at != stage.npos) {
      return stage.substr(0, at + std::string_view(name).size() - 1) + "s";
    }
  }
  if (const std::size_t tie = stage.find(", tie "); tie != std::string::npos) {
    return stage.substr(0, tie);
  }
  for (const char* name : {"quarter-final", "semi-final"}) {
    if (stage.starts_with(name)) return std::string(name) + "s";
  }
  return stage;
}

// The part of the bracket that a round belongs to: rounds of one part stand side by side.
std::string part_of(const Report& report, const std::string& title) {
  if (!report.config->competition.stages.empty()) return parse_stage_name(title).stage;
  for (const char* part : {"winners'", "losers'", "grand final", "third place"}) {
    if (title.starts_with(part)) return part;
  }
  return "";
}

struct Round {
  std::string title;
  std::vector<const BracketTie*> ties;
};

struct Part {
  std::string name;
  std::vector<Round> rounds;
};

std::vector<Part> parts_of(const Report& report) {
  std::vector<Part> parts;
  for (const BracketTie& tie : report.bracket) {
    const std::string title = round_title(tie.stage);
    const std::string name = part_of(report, title);
    auto part = std::ranges::find(parts, name, &Part::name);
    if (part == parts.end()) part = parts.insert(parts.end(), {name, {}});

    if (part->rounds.empty() || part->rounds.back().title != title) {
      part->rounds.push_back({title, {}});
    }
    part->rounds.back().ties.push_back(&tie);
  }
  return parts;
}

// True when no match of an earlier round leads to the tie.
bool starts_here(const Report& report, const BracketTie& tie) {
  return std::ranges::none_of(
      tie.entrants, [&](const Entrant& entrant) { return origin(report, entrant).tie >= 0; });
}

std::string entrant_html(const Report& report, const BracketTie& tie, const Entrant& entrant) {
  const bool won = tie.winner && entrant.team == tie.winner;
  std::string goals;
  for (const ScheduledMatch& match : matches_of(report, tie)) {
    if (!match.outcome || !match.outcome->counts() || !entrant.team) continue;
    const bool left = match.fixture.left == *entrant.team;
    const Outcome& outcome = *match.outcome;
    goals += fmt::format(" {}", left ? outcome.left_score : outcome.right_score);
    if (had_shoot_out(outcome)) {
      const bool adds = rules_of(report.config->competition).adds_shoot_outs;
      goals += fmt::format(fmt::runtime(adds ? "+{}" : " ({} pen)"),
                           left ? *outcome.left_penalties : *outcome.right_penalties);
    }
    if (outcome.forfeit) goals += match.decision ? " (decision)" : " (forfeit)";
  }

  if (tie.by_lot && won) goals += " by lot";

  const char* kind = won ? " class=\"won\"" : entrant.team ? "" : " class=\"open\"";
  return fmt::format("<div{}><span>{}</span><span>{}</span></div>", kind,
                     base::escape_xml(entrant_text(report, entrant)), base::escape_xml(goals));
}

}  // namespace

const char* const kBracketStyle =
    ".bracket{display:flex;overflow-x:auto;margin:.5em 0 1.5em;font-variant-numeric:tabular-nums}"
    ".bracket>section{display:flex;flex-direction:column;min-width:13em}"
    ".bracket h3{margin:0 1.5em .3em 0}"
    ".bracket ul{list-style:none;margin:0;padding:0;flex:1;display:flex;flex-direction:column}"
    ".bracket li{flex:1;display:flex;flex-direction:column;justify-content:center;"
    "position:relative;padding:.3em 1.5em .3em 0}"
    ".bracket li>*{border:1px solid var(--line);padding:.1em .5em;display:flex;"
    "justify-content:space-between;gap:1em;background:var(--ground)}"
    ".bracket li>*+*{border-top:0}"
    ".bracket .won{font-weight:600}.bracket .open{color:var(--muted)}"
    ".bracket .bye{visibility:hidden}"
    ".bracket .joins li:not(.bye)::after{content:\"\";position:absolute;right:.75em;width:.75em;"
    "border:0 solid var(--line);border-right-width:1px;pointer-events:none}"
    ".bracket .joins li:nth-child(odd)::after{top:50%;bottom:0;border-top-width:1px}"
    ".bracket .joins li:nth-child(even)::after{top:0;bottom:50%;border-bottom-width:1px}"
    ".bracket .joined "
    "li:not(.bye,.first)::before{content:\"\";position:absolute;left:-.75em;top:50%;"
    "width:.75em;border-top:1px solid var(--line)}";

std::string bracket_text(const Report& report, std::size_t width) {
  return Tree(report, width).text();
}

std::string bracket_html(const Report& report) {
  std::string text;
  for (const Part& part : parts_of(report)) {
    text += "<div class=\"bracket\">\n";
    for (std::size_t i = 0; i < part.rounds.size(); ++i) {
      const Round& round = part.rounds[i];
      // Lines connect rounds of which the next one has half as many ties.
      const auto halves = [&](std::size_t at) {
        return at + 1 < part.rounds.size() &&
               part.rounds[at].ties.size() == 2 * part.rounds[at + 1].ties.size();
      };

      const bool joined = i > 0 && halves(i - 1);
      text += fmt::format("<section class=\"{}{}\"><h3>{}</h3>\n<ul>\n", halves(i) ? "joins" : "",
                          joined ? " joined" : "", base::escape_xml(round.title));

      for (const BracketTie* tie : round.ties) {
        text += has_bye(*tie)               ? "<li class=\"bye\" aria-hidden=\"true\">"
                : starts_here(report, *tie) ? "<li class=\"first\">"
                                            : "<li>";
        for (const Entrant& entrant : tie->entrants) text += entrant_html(report, *tie, entrant);
        text += "</li>\n";
      }
      text += "</ul></section>\n";
    }
    text += "</div>\n";
  }
  return text;
}

}  // namespace cls::tournament
