// Sections in the order of interest; the style sheet arranges them in one to three columns.
#include "tournament/site/spectator_page.h"

#include <fmt/format.h>

#include "base/text/xml.h"
#include "tournament/report/report_bracket.h"
#include "viewer/page/encoding.h"
#include "viewer/page/viewer_program.h"
#include "viewer/report/report_page.h"

namespace cls::tournament {
namespace {

using viewer::text_element;

constexpr int kReloadSeconds = 10;
/// Groups of results that are open when the page is loaded.
constexpr std::size_t kOpenGroups = 1;

// Text has a contrast of at least 4.5:1 to what is behind it, in both themes.
constexpr std::string_view kSpectatorStyle = R"(
:root { color-scheme: light dark; --ground: #f2f4f6; --card: #ffffff; --text: #16202a; --muted: #55606b; --line: #8794a1; --faint: #dde2e7; --accent: #0b5fa5; --live: #b3261e; --grass: #2f6b4f;
  font: clamp(15px, 10px + 0.5vw, 22px)/1.4 system-ui, "Noto Sans", "Noto Sans CJK JP", sans-serif; background: var(--ground); color: var(--text); }
@media (prefers-color-scheme: dark) {
  :root { --ground: #0f1317; --card: #181e24; --text: #e8ecf0; --muted: #a3aeb9; --line: #6c7884; --faint: #2c343c; --accent: #7cc4f8; --live: #ff8a80; --grass: #2a5a44; }
}
* { box-sizing: border-box; }
body { margin: 0; }
a { color: var(--accent); }
header { display: flex; flex-wrap: wrap; align-items: baseline; gap: 0 1.5rem; padding: 0.8rem 1rem 0; max-width: 120rem; margin: 0 auto; }
h1 { margin: 0; font-size: 1.6rem; line-height: 1.25; overflow-wrap: anywhere; }
#status { margin: 0; color: var(--muted); }
h2 { margin: 0 0 0.6rem; font-size: 1.1rem; }
h3 { margin: 0; font-size: 0.85rem; font-weight: 600; color: var(--muted); }
main { display: grid; gap: 1rem; padding: 1rem; max-width: 120rem; margin: 0 auto; grid-template-columns: minmax(0, 1fr); align-items: start; }
.column { display: grid; gap: 1rem; grid-template-columns: minmax(0, 1fr); }
section.part { background: var(--card); border: 1px solid var(--faint); border-radius: 0.6rem; padding: 0.9rem 1rem; min-width: 0; }
section.part:empty { display: none; }
.cards { display: grid; gap: 0.8rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 17rem), 1fr)); align-items: start; }
.card { display: block; color: inherit; text-decoration: none; border: 1px solid var(--line); border-radius: 0.5rem; overflow: hidden; max-width: 46rem; container-type: inline-size; }
.card:only-child { max-width: none; }
.card:only-child .pitch { max-height: 75vh; }
a.card:hover, a.card:focus-visible { border-color: var(--accent); box-shadow: 0 0 0 1px var(--accent); }
.card .line { display: grid; grid-template-columns: minmax(0, 1fr) auto minmax(0, 1fr); gap: 0.7rem; align-items: center; padding: 0.5rem 0.7rem; }
.card .name { display: flex; align-items: center; font-size: clamp(0.75rem, 3.7cqi, 1.7rem); font-weight: 650; line-height: 1.2; overflow-wrap: anywhere; }
.card .name:first-child { justify-content: end; text-align: right; }
.card .score { font-size: clamp(1.6rem, 8cqi, 2.8rem); line-height: 1.1; font-weight: 700; font-variant-numeric: tabular-nums; white-space: nowrap; text-align: center; }
/* Names of fifteen characters fit in half of a card; with a score of two digits each between them they need more. */
@container (max-width: 48rem) {
  .card .line { grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); gap: 0.1rem 0.9rem; }
  .card .score { grid-area: 2 / 1 / auto / 3; }
  .card .name:first-child { grid-column: 1; }
  .card .name:last-child { grid-area: 1 / 2; }
}
.card .foot { display: flex; flex-wrap: wrap; gap: 0 1rem; justify-content: space-between; padding: 0.3rem 0.7rem 0.5rem; color: var(--muted); font-size: 0.85rem; font-variant-numeric: tabular-nums; }
.live { color: var(--live); font-weight: 650; }
.live::before { content: ""; display: inline-block; width: 0.55em; height: 0.55em; margin-right: 0.4em; border-radius: 50%; background: currentColor; }
.pitch { display: block; width: 100%; background: var(--grass); }
.pitch path { fill: none; stroke: #ffffff; stroke-opacity: 0.55; stroke-width: 0.4; }
.pitch circle { transition: cx 1s linear, cy 1s linear; }
.pitch g { transition: transform 1s linear; }
.pitch text { font-size: 2.4px; font-weight: 650; text-anchor: middle; stroke: none; }
.pitch .l { fill: #ffd54a; stroke: #1b1b1b; stroke-width: 0.4; }
.pitch .l text { fill: #1b1b1b; }
.pitch .r { fill: #c62828; stroke: #ffffff; stroke-width: 0.4; }
.pitch .r text { fill: #ffffff; }
.pitch .b { fill: #ffffff; stroke: #1b1b1b; stroke-width: 0.4; }
.key { flex: none; display: inline-block; width: 0.62em; height: 0.62em; margin: 0 0.35em; border-radius: 50%; border: 1px solid #1b1b1b; background: #ffd54a; }
.key.r { border-color: var(--text); background: #c62828; }
@media (prefers-reduced-motion: reduce) { .pitch circle, .pitch g { transition: none; } }
.scroll, .bracket { overflow-x: auto; }
.tables { display: grid; gap: 0.9rem 1.6rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 20rem), 1fr)); align-items: start; }
.tables > div { min-width: 0; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; font-size: 0.92rem; }
caption { text-align: left; font-weight: 600; padding: 0 0 0.2rem; font-size: 0.95rem; }
th, td { padding: 0.22rem 0.4rem; text-align: right; font-weight: 400; border-bottom: 1px solid var(--faint); }
th:first-child, td:first-child { padding-left: 0.1rem; }
thead th { color: var(--muted); font-size: 0.82rem; border-bottom-color: var(--line); white-space: nowrap; }
td.w, th.w { text-align: left; overflow-wrap: break-word; }
.standings td.w { width: 100%; min-width: 5.5rem; font-weight: 600; overflow-wrap: anywhere; }
#bracket .bracket:not(:has(.joins)) { flex-wrap: wrap; gap: 0.6rem 0; }
.matches { list-style: none; margin: 0; padding: 0; }
.matches li { display: grid; grid-template-columns: minmax(0, 1fr) minmax(2.8rem, max-content) minmax(0, 1fr); gap: 0 0.5rem; align-items: baseline; padding: 0.28rem 0; border-bottom: 1px solid var(--faint); }
.matches .name { overflow-wrap: anywhere; line-height: 1.25; font-size: 0.88em; }
.matches .name:first-child { text-align: right; }
.matches .score { text-align: center; font-weight: 650; font-variant-numeric: tabular-nums; line-height: 1.25; }
.matches .occasion { grid-column: 1 / -1; text-align: center; color: var(--muted); font-size: 0.8rem; }
.won { font-weight: 650; }
.note { color: var(--muted); margin: 0.5rem 0 0; font-size: 0.9rem; }
summary { cursor: pointer; padding: 0.3rem 0; font-weight: 600; }
details > .tables, details > .matches { margin: 0.3rem 0 0.8rem; }
footer { padding: 0 1rem 1rem; text-align: center; color: var(--muted); font-size: 0.85rem; }
.pause { margin: 0 0 0.5rem; font-weight: 650; }
.winner { margin: 0; font-size: 1.4rem; font-weight: 700; overflow-wrap: anywhere; }
@media (max-width: 899px) {
  .column { display: contents; }
  section.part { order: 2; }
  #now, #next { order: 1; }
}
@media (min-width: 900px) {
  main { grid-template-columns: minmax(0, 1.25fr) minmax(0, 1fr); grid-template-rows: auto 1fr; }
  .column:nth-child(2) { grid-column: 2; grid-row: 1 / 3; }
}
@media (min-width: 1700px) {
  main { grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr) minmax(0, 0.8fr); }
  main:has(.cards) { grid-template-columns: minmax(0, 1.75fr) minmax(0, 1.12fr) minmax(0, 0.83fr); }
  main:not(:has(.cards)) { grid-template-columns: minmax(0, 0.5fr) minmax(0, 1fr) minmax(0, 1fr); }
}
)";

std::string pitch_player(const viewer::GlancePlayer& player, char kind) {
  return fmt::format(
      "<g class=\"{}\" transform=\"translate({:.1f} {:.1f})\"><circle r=\"2\"/>"
      "<text y=\"0.85\">{}</text></g>",
      kind, player.position.x, player.position.y, player.unum);
}

std::string pitch_circle(soccer::Vec2 at, double radius, char kind) {
  return fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", kind, at.x,
                     at.y, radius);
}

// Positions in meters, as the soccer server counts them: y points down.
std::string pitch(const viewer::Glance& glance) {
  std::string text =
      "<svg class=\"pitch\" viewBox=\"-55 -36 110 72\" aria-hidden=\"true\"><path d=\"M-52.5 "
      "-34h105v68h-105zM0 -34v68M-9.15 0a9.15 9.15 0 1 0 18.3 0a9.15 9.15 0 1 0 -18.3 0M-52.5 "
      "-20.16h16.5v40.32h-16.5M52.5 -20.16h-16.5v40.32h16.5\"/>";
  for (const viewer::GlancePlayer& one : glance.left_players) text += pitch_player(one, 'l');
  for (const viewer::GlancePlayer& one : glance.right_players) text += pitch_player(one, 'r');
  return text + pitch_circle(glance.ball, 1.2, 'b') + "</svg>\n";
}

// "12:05" of play at ten cycles a second.
std::string clock_text(int cycle) {
  constexpr int kCyclesPerSecond = 10;
  const int seconds = cycle / kCyclesPerSecond;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

std::string card(const SpectatorMatch& match) {
  // With the color of the team on the pitch.
  const auto name = [&match](const std::string& team, std::string_view key) {
    const std::string color =
        match.glance ? fmt::format("<span class=\"{}\"></span>", key) : std::string();
    return fmt::format("<span class=\"name\">{}{}</span>", color, base::escape_xml(team));
  };
  const char* element = match.has_page ? "a" : "div";
  const std::string link =
      match.has_page ? fmt::format(" href=\"match/{}/\"", match.index) : std::string();

  std::string text = fmt::format(
      "<{} class=\"card\"{}>\n<span class=\"line\">{}<span class=\"score\">{}</span>{}</span>\n",
      element, link, name(match.left, "key"),
      match.score.empty() ? "– : –" : base::escape_xml(match.score), name(match.right, "key r"));
  if (match.glance) text += pitch(*match.glance);

  const std::string clock =
      match.glance
          ? fmt::format("{} · cycle {}", clock_text(match.glance->cycle), match.glance->cycle)
          : std::string("starting");
  text += fmt::format(
      "<span class=\"foot\"><span "
      "class=\"live\">Live</span><span>{}</span><span>{}</span></span>\n",
      clock, base::escape_xml(match.occasion));
  return text + fmt::format("</{}>\n", element);
}

std::string now_content(const SpectatorPage& page) {
  std::string text = "<h2>Now</h2>\n";
  if (!page.winner.empty()) {
    return "<h2>Winner</h2>\n" + text_element("p", page.winner, "winner");
  }
  if (!page.pause.empty()) text += text_element("p", page.pause, "pause");
  if (page.running.empty()) {
    return text + text_element("p",
                               page.over ? "All matches have been played."
                                         : "No match is played at the moment.",
                               "note");
  }
  text += "<div class=\"cards\">\n";
  for (const SpectatorMatch& match : page.running) text += card(match);
  return text + "</div>\n";
}

std::string list_item(const SpectatorMatch& match) {
  std::string score = match.score.empty() ? "–" : base::escape_xml(match.score);
  if (match.has_page) {
    score = fmt::format("<a href=\"match/{0}/\" aria-label=\"Replay: {1} {2} {3}\">{2}</a>",
                        match.index, base::escape_xml(match.left), score,
                        base::escape_xml(match.right));
  }
  std::string text = fmt::format(
      "<li><span class=\"name\">{}</span><span class=\"score\">{}</span>"
      "<span class=\"name\">{}</span>",
      base::escape_xml(match.left), score, base::escape_xml(match.right));
  std::string occasion = match.start;
  if (!occasion.empty() && !match.occasion.empty()) occasion += " · ";
  occasion += match.occasion;
  if (!occasion.empty()) {
    text += fmt::format("<span class=\"occasion\">{}</span>", base::escape_xml(occasion));
  }
  return text + "</li>\n";
}

std::string match_items(const std::vector<SpectatorMatch>& matches) {
  std::string text = "<ul class=\"matches\">\n";
  for (const SpectatorMatch& match : matches) text += list_item(match);
  return text + "</ul>\n";
}

std::string next_content(const SpectatorPage& page) {
  if (page.next.empty()) return {};
  std::string text = "<h2>Next</h2>\n" + match_items(page.next);
  if (page.further > 0) {
    text += text_element("p", fmt::format("and {} more are scheduled", page.further), "note");
  }
  return text;
}

std::string table_boxes(const std::vector<std::string>& tables, std::string_view kind) {
  std::string text = fmt::format("<div class=\"tables {}\">\n", kind);
  // A box that may scroll is in reach of the keys.
  for (const std::string& table : tables) {
    text += fmt::format("<div class=\"scroll\" tabindex=\"0\">\n{}</div>\n", table);
  }
  return text + "</div>\n";
}

std::string details(const std::string& id, const std::string& title, const std::string& content,
                    bool open) {
  return fmt::format("<details id=\"{}\"{}><summary>{}</summary>\n{}</details>\n", id,
                     open ? " open" : "", base::escape_xml(title), content);
}

std::string tables_content(const SpectatorPage& page) {
  if (page.tables.empty() && page.earlier_tables.empty()) return {};
  std::string text = "<h2>Tables</h2>\n" + table_boxes(page.tables, "standings");
  std::size_t number = page.earlier_tables.size();
  for (const auto& group : page.earlier_tables) {
    text += details(fmt::format("tables-{}", number--), group.title,
                    table_boxes(group.content, "standings"), false);
  }
  return text;
}

// Numbered from the first group on, so that a further one changes no earlier id.
std::string results_content(const SpectatorPage& page) {
  if (page.results.empty()) return {};
  std::string text = "<h2>Results</h2>\n";
  for (std::size_t i = 0; i < page.results.size(); ++i) {
    const auto& group = page.results[i];
    text += details(fmt::format("results-{}", page.results.size() - i), group.title,
                    match_items(group.content), i < kOpenGroups);
  }
  return text;
}

std::string part(std::string_view id, std::string_view label, const std::string& content) {
  return fmt::format("<section class=\"part\" id=\"{}\" aria-label=\"{}\">{}</section>\n", id,
                     label, content);
}

std::string status_line(const SpectatorPage& page, const std::string& rest) {
  return fmt::format("<p id=\"status\" role=\"status\" data-rest=\"{}\">{}</p>\n", rest,
                     base::escape_xml(page.status));
}

std::string head(const SpectatorPage& page, const std::string& style) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src {}; "
      "connect-src 'self'; style-src {}; img-src data:; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n"
      "<noscript><meta http-equiv=\"refresh\" content=\"{}\"></noscript>\n"
      "<title>{}</title>\n<style>{}</style>\n</head>\n",
      viewer::csp_hash(viewer::spectator_script()), viewer::csp_hash(style), kReloadSeconds,
      base::escape_xml(page.title), style);
}

}  // namespace

std::string spectator_page(const SpectatorPage& page, const std::string& rest) {
  const std::string style = std::string(kSpectatorStyle) + kBracketStyle;
  std::string text = head(page, style);
  text += fmt::format("<body>\n<header><h1>{}</h1>{}</header>\n<main>\n",
                      base::escape_xml(page.title), status_line(page, rest));

  const std::string statistics =
      page.statistics.empty() ? "" : "<h2>Statistics</h2>\n" + table_boxes(page.statistics, "");
  text += "<div class=\"column\">\n" + part("now", "Now", now_content(page)) + "</div>\n";
  text +=
      "<div class=\"column\">\n" + part("tables", "Tables", tables_content(page)) +
      part("bracket", "Bracket", page.bracket.empty() ? "" : "<h2>Bracket</h2>\n" + page.bracket) +
      "</div>\n";
  text += "<div class=\"column\">\n" + part("next", "Next", next_content(page)) +
          part("results", "Results", results_content(page)) +
          part("statistics", "Statistics", statistics) + "</div>\n";

  return text + fmt::format("</main>\n<script>{}</script>\n</body>\n</html>\n",
                            viewer::spectator_script());
}

std::string spectator_now(const SpectatorPage& page, const std::string& rest) {
  return status_line(page, rest) + part("now", "Now", now_content(page));
}

}  // namespace cls::tournament
