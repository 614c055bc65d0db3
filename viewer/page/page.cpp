// Assembles pages: policy, program, text for readers without scripts, data. Takes them apart.
#include "viewer/page/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.h"
#include "base/io/byte_source.h"
#include "base/system/version.h"
#include "base/text/find_ignoring_case.h"
#include "base/text/json.h"
#include "base/text/number_text.h"
#include "base/text/replace_all.h"
#include "base/text/xml.h"
#include "gamelog/rcg/rcg_reader.h"
#include "viewer/page/encoding.h"
#include "viewer/page/viewer_program.h"
#include "viewer/stream/chunk.h"

namespace cls::viewer {
namespace {

using analysis::MatchSummary;
using base::Json;

constexpr std::string_view kDoctype = "<!doctype html>";
constexpr std::string_view kDataTag =
    R"(<script type="application/cls-view;base64" id="match" data-length=")";
constexpr std::string_view kEndTag = "</script>";
constexpr std::size_t kMaxStream = std::size_t{512} << 20;

std::string team_name(const analysis::TeamSummary& team) {
  return base::escape_xml(team.name.empty() ? "no team" : team.name);
}

std::string title(const MatchSummary& summary) {
  return fmt::format("{} {} : {} {}", team_name(summary.teams[0]), summary.teams[0].score,
                     summary.teams[1].score, team_name(summary.teams[1]));
}

std::string goal_line(const analysis::GoalSummary& goal) {
  const std::string scorer = goal.unum > 0 ? fmt::format(", player {}", goal.unum) : "";
  return fmt::format("<li>cycle {}: goal for the {} team{}{}</li>\n", goal.cycle,
                     soccer::side_name(goal.side), scorer, goal.own_goal ? " (own goal)" : "");
}

// The text for readers without scripts.
std::string plain_text(const MatchSummary& summary) {
  std::string text = fmt::format("<noscript>\n<h1>{}</h1>\n", title(summary));
  if (summary.penalties) {
    text += fmt::format("<p>Penalty shoot-out {} : {}</p>\n", summary.teams[0].penalty_score,
                        summary.teams[1].penalty_score);
  }

  if (!summary.goals.empty()) {
    text += "<ul>\n";
    for (const analysis::GoalSummary& goal : summary.goals) text += goal_line(goal);
    text += "</ul>\n";
  }

  text += "<p>This page shows the match with JavaScript, which is switched off.</p>\n";
  return text + "</noscript>\n";
}

std::string settings_json(const PageSettings& settings, const LivePaths* live) {
  Json json = {{"schema", "cls.page/1"},
               {"cls", base::kVersion},
               {"at", settings.at ? Json(*settings.at) : Json(nullptr)},
               {"players", settings.players},
               {"live", live != nullptr ? Json(live->stream) : Json(nullptr)}};

  if (live != nullptr && !live->drawings.empty()) json["drawings"] = live->drawings;
  if (!settings.home.empty()) json["home"] = settings.home;
  if (!settings.sides[0].empty()) json["sides"] = settings.sides;
  if (!settings.review.is_null()) json["review"] = settings.review;
  for (const MissedDecision& each : settings.missed) {
    json["missed"].push_back({each.cycle, each.stopped, each.player, each.reason});
  }
  return inert_json(json.dump(-1, true));
}

std::string policy(std::string_view script, bool live) {
  return fmt::format(
      "default-src 'none'; script-src {}; style-src {}; img-src data: blob:; {}base-uri 'none'; "
      "form-action 'none'",
      csp_hash(script), csp_hash(viewer_style()), live ? "connect-src 'self'; " : "");
}

// Everything before the match. `title` is HTML; `live` is null in files.
std::string page_start(const std::string& title, const std::string& without_scripts,
                       std::string_view script, const PageSettings& settings,
                       const LivePaths* live) {
  std::string page(kDoctype);
  page += "\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  page += fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n",
                      policy(script, live != nullptr));
  page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
  page += fmt::format("<meta name=\"generator\" content=\"cls {}\">\n", base::kVersion);

  // Browsers ask servers for an icon, unless there is one.
  if (live != nullptr) page += "<link rel=\"icon\" href=\"data:,\">\n";
  page += fmt::format("<title>{}</title>\n", title);
  page += fmt::format("<style>{}</style>\n</head>\n<body>\n", viewer_style());

  page += without_scripts;
  page += "<div id=\"app\"></div>\n";
  page += fmt::format("<script type=\"application/json\" id=\"settings\">{}</script>\n",
                      settings_json(settings, live));
  page += fmt::format("<script>{}</script>\n", script);
  return page;
}

// `parts`: decisions or drawings of sides.
std::string elements_of(std::string_view kind, std::string_view prefix, const auto& parts) {
  std::string elements;
  for (const auto& [side, packed] : parts) {
    const std::string data = base64(packed);
    elements += fmt::format(
        "<script type=\"application/cls-{0};base64\" id=\"{1}{0}-{2}\" "
        "data-length=\"{3}\">{4}</script>\n",
        kind, prefix, soccer::side_name(side), data.size(), data);
  }
  return elements;
}

// The program with the parts that the page needs.
std::string_view script_of(const PageSettings& settings,
                           const std::vector<PageDecisions>& decisions) {
  if (settings.compared) return comparison_script();
  if (!decisions.empty()) return debugger_script();
  return settings.drawings.empty() ? viewer_script() : drawings_script();
}

}  // namespace

std::string write_page(const MatchSummary& summary, std::string_view stream,
                       const PageSettings& settings, const std::vector<PageDecisions>& decisions) {
  const std::string data = base64(gzip(stream));
  return page_start(title(summary), plain_text(summary), script_of(settings, decisions), settings,
                    nullptr) +
         fmt::format("{}{}\">{}</script>\n{}{}</body>\n</html>\n", kDataTag, data.size(), data,
                     elements_of("decisions", "", decisions), data_elements("", settings.drawings));
}

std::string live_page(const std::string& title, const LivePaths& paths,
                      const PageSettings& settings) {
  return page_start(base::escape_xml(title),
                    "<noscript>\n<p>This page shows a running match with JavaScript, which is "
                    "switched off.</p>\n</noscript>\n",
                    paths.drawings.empty() ? viewer_script() : drawings_script(), settings,
                    &paths) +
         "</body>\n</html>\n";
}

std::string data_elements(std::string_view prefix, const std::vector<PageDrawings>& drawings) {
  return elements_of("drawings", prefix, drawings);
}

std::string inert_json(std::string json) {
  base::replace_all(json, "<", "\\u003c");
  return json;
}

bool looks_like_page(std::string_view start) {
  return base::find_ignoring_case(start.substr(0, kDoctype.size()), kDoctype) == 0;
}

bool looks_like_page_or_stream(std::string_view start) {
  const bool stream = start.starts_with(static_cast<char>(ChunkKind::kHeader)) &&
                      start.find("{\"schema\":\"cls.view/") < kMatchStart;
  return stream || looks_like_page(start);
}

base::Result<StreamMatch> read_page(std::string_view page) {
  // The last tag counts: only data in base64 follow it, while names and programs come before it.
  const std::size_t tag = page.rfind(kDataTag);
  if (!looks_like_page(page) || tag == std::string_view::npos) {
    return base::Error{"an HTML page without a match of cls"};
  }

  std::string_view rest = page.substr(tag + kDataTag.size());
  const std::size_t quote = std::min(rest.find("\">"), rest.size());
  const auto length = base::parse_int(rest.substr(0, quote));
  if (!length || *length < 0 || quote == rest.size()) {
    return base::Error{"corrupt: the size of the match is missing"};
  }

  rest.remove_prefix(quote + 2);
  const std::string_view text = rest.substr(0, std::min(rest.find(kEndTag), rest.size()));
  const std::size_t size = base::index(*length);
  if (text.size() < size) {
    return base::Error{fmt::format("truncated: {} % of the match is there",
                                   100 * std::uint64_t{text.size()} / size)};
  }

  TRY_INIT(const auto packed, from_base64(text));
  TRY_INIT(const auto stream, gunzip(packed, kMaxStream));
  return read_stream(stream);
}

base::Result<StreamMatch> read_page_or_stream(base::InputBuffer& input) {
  std::string bytes;
  for (;;) {
    const std::string_view block = input.take(base::InputBuffer::kMaxLine);
    if (block.empty()) break;
    bytes += block;
    if (bytes.size() > kMaxStream) return base::Error{"too large for a match"};
  }

  auto match = looks_like_page(bytes) ? read_page(bytes) : read_stream(bytes);
  if (match) match->from_page = true;
  return match;
}

base::Result<StreamMatch> read_log_or_page(const std::string& path) {
  TRY_INIT(auto source, base::open_source(path));
  base::InputBuffer input(*source);

  if (!looks_like_page_or_stream(input.peek(kMatchStart))) {
    StreamMatch match;
    match.record = gamelog::read_rcg(input);
    match.ended = true;
    return match;
  }

  auto match = read_page_or_stream(input);
  if (!match) return base::Error{path + ": " + match.error().message};
  return match;
}

}  // namespace cls::viewer
