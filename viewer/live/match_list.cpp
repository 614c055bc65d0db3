// Tables, the matches as the last one.
#include "viewer/live/match_list.h"

#include <fmt/format.h>

#include "base/text/xml.h"
#include "viewer/page/encoding.h"
#include "viewer/page/viewer_program.h"

namespace cls::viewer {
namespace {

constexpr int kReloadSeconds = 3;

// Columns have fixed widths and rows one line, so nothing moves when cells change.
constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; font: 16px/1.4 system-ui, sans-serif; background: #ffffff; color: #16202a; }
a { color: #0b5fa5; }
@media (prefers-color-scheme: dark) {
  :root { background: #11151a; color: #e8ecf0; }
  a { color: #7cc4f8; }
}
body { max-width: 64rem; margin: 2rem auto; padding: 0 1rem; }
h1 { margin: 0; }
#status { margin: 0.25rem 0 1.5rem; min-height: 1.4em; }
section { margin: 0 0 1.75rem; overflow-x: auto; }
table { border-collapse: collapse; width: 100%; min-width: 44rem; table-layout: fixed; font-variant-numeric: tabular-nums; }
caption { padding: 0.35rem 0; text-align: left; font-weight: 650; }
th, td { height: 1.9rem; padding: 0.2rem 0.3rem; font-size: 0.95rem; text-align: right; border-bottom: 1px solid #8884; overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
thead th { font-size: 0.9rem; font-weight: 600; }
.w { text-align: left; }
.number { width: 4.5rem; }
.score { width: 6rem; text-align: center; }
.state { width: 30%; text-align: left; }
.page { width: 6rem; text-align: left; }
.glance table { width: 22rem; min-width: 0; }
.glance th { width: 10rem; font-weight: 400; text-align: left; }
.glance td { font-weight: 650; text-align: left; }
.state svg { width: 31px; height: 20px; margin-right: 0.6rem; vertical-align: middle; }
.state rect { fill: #2f6b4f; }
.state circle { fill: #ffffff; }
.standings thead th:first-child { width: 2.5rem; }
.standings thead th:nth-child(2) { width: 8rem; }
.standings thead th:last-child { width: 7rem; }
button { font: inherit; }
button:disabled { visibility: hidden; }
)";

// The pitch with the ball, 31 by 20 pixels.
std::string small_pitch(soccer::Vec2 ball) {
  return fmt::format(
      "<svg viewBox=\"-55 -36 110 72\" aria-hidden=\"true\"><rect x=\"-55\" y=\"-36\" "
      "width=\"110\" height=\"72\"/><circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"6\"/></svg>",
      ball.x, ball.y);
}

std::string row(const ListedMatch& match) {
  const std::string score = match.score.empty() ? "–" : base::escape_xml(match.score);
  const std::string link =
      match.has_page ? fmt::format("<a href=\"match/{0}/\" aria-label=\"{1} of match {0}\">{1}</a>",
                                   match.index, match.live ? "live page" : "replay")
                     : "";
  const std::string state = base::escape_xml(match.state);

  return fmt::format(
      "<tr><th scope=\"row\" class=\"number\">{}</th><td>{}</td><td class=\"score\">{}</td>"
      "<td class=\"w\">{}</td><td class=\"state\" title=\"{}\">{}{}</td>"
      "<td class=\"page\">{}</td></tr>\n",
      match.index, base::escape_xml(match.left), score, base::escape_xml(match.right), state,
      match.ball ? small_pitch(*match.ball) : "", state, link);
}

std::string matches_table(const std::vector<ListedMatch>& matches) {
  std::string table =
      "<table>\n<caption>matches</caption>\n<thead><tr><th scope=\"col\" class=\"number\">match"
      "</th><th scope=\"col\">left</th><th scope=\"col\" class=\"score\">score</th>"
      "<th scope=\"col\" class=\"w\">right</th><th scope=\"col\" class=\"state\">state</th>"
      "<th scope=\"col\" class=\"page\">page</th></tr>"
      "</thead>\n<tbody>\n";
  for (const ListedMatch& match : matches) table += row(match);
  return table + "</tbody>\n</table>\n";
}

std::string facts_table(const std::vector<Fact>& facts) {
  if (facts.empty()) return {};
  std::string table =
      "<section class=\"glance\">\n<table>\n<caption>at a glance</caption>\n<thead hidden><tr>"
      "<th scope=\"col\">what</th><th scope=\"col\">value</th></tr></thead>\n<tbody>\n";
  for (const Fact& fact : facts) {
    table += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n",
                         base::escape_xml(fact.name), base::escape_xml(fact.value));
  }
  return table + "</tbody>\n</table>\n</section>\n";
}

std::string head(const MatchList& list) {
  const std::string policy =
      list.running ? fmt::format("script-src {}; connect-src 'self'; ", csp_hash(list_script()))
                   : "";

  std::string head = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; {}style-src {}; "
      "img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n",
      policy, csp_hash(kStyle));

  if (list.running) {
    head += fmt::format("<noscript><meta http-equiv=\"refresh\" content=\"{}\"></noscript>\n",
                        kReloadSeconds);
  }
  return head + fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n",
                            base::escape_xml(list.title), kStyle);
}

}  // namespace

std::string match_list_page(const MatchList& list) {
  std::string page = head(list);
  page += fmt::format("<body{}>\n<main>\n<h1>{}</h1>\n<p id=\"status\" role=\"status\">{}</p>\n",
                      list.running ? " data-running" : "", base::escape_xml(list.title),
                      base::escape_xml(list.status));

  page += facts_table(list.facts);
  for (const std::string& table : list.tables) {
    const bool first = &table == &list.tables.front();
    page += fmt::format("<section{}>\n{}</section>\n", first ? " class=\"standings\"" : "", table);
  }

  page += "<section>\n" + matches_table(list.matches) + "</section>\n</main>\n";
  if (list.running) page += fmt::format("<script>{}</script>\n", list_script());
  return page + "</body>\n</html>\n";
}

}  // namespace cls::viewer
