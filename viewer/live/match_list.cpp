// A table.
#include "viewer/live/match_list.h"

#include <fmt/format.h>

#include "base/text/xml.h"
#include "viewer/page/encoding.h"

namespace cls::viewer {
namespace {

constexpr int kReloadSeconds = 3;

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; font: 16px/1.4 system-ui, sans-serif; }
body { max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th, td { padding: 0.35rem 0.6rem; text-align: left; border-bottom: 1px solid #8884; }
td.score { text-align: center; white-space: nowrap; }
td.left { text-align: right; }
)";

std::string row(const ListedMatch& match) {
  const std::string none = match.has_page ? "live" : "–";
  const std::string score = match.score.empty() ? none : match.score;
  const std::string link =
      match.has_page ? fmt::format("<a href=\"match/{}/\" aria-label=\"Watch match {}\">{}</a>",
                                   match.index, match.index, base::escape_xml(score))
                     : base::escape_xml(score);
  return fmt::format(
      "<tr><td>{}</td><td class=\"left\">{}</td><td class=\"score\">{}</td><td>{}</td><td>{}</td>"
      "</tr>\n",
      match.index, base::escape_xml(match.left), link, base::escape_xml(match.right),
      base::escape_xml(match.state));
}

}  // namespace

std::string match_list_page(const std::string& title, const std::vector<ListedMatch>& matches,
                            bool running) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src {}; "
      "img-src data:\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n",
      csp_hash(kStyle));
  if (running) {
    page += fmt::format("<meta http-equiv=\"refresh\" content=\"{}\">\n", kReloadSeconds);
  }
  page += fmt::format(
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<main>\n<h1>{0}</h1>\n"
      "<table>\n<thead><tr><th scope=\"col\">Match</th><th scope=\"col\">Left</th>"
      "<th scope=\"col\">Score</th><th scope=\"col\">Right</th><th scope=\"col\">State</th></tr>"
      "</thead>\n<tbody>\n",
      base::escape_xml(title), kStyle);
  for (const ListedMatch& match : matches) page += row(match);
  return page + "</tbody>\n</table>\n</main>\n</body>\n</html>\n";
}

}  // namespace cls::viewer
