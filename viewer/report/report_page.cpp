// Style and elements.
#include "viewer/report/report_page.h"

#include <fmt/format.h>

#include "base/text/xml.h"

namespace cls::viewer {
namespace {

// Text and lines have a contrast of at least 4.5:1 (text) and 3:1 (lines) to the ground.
constexpr std::string_view kReportStyle =
    ":root{color-scheme:light dark;--text:#1b1b1b;--muted:#5c5c5c;--ground:#fff;--line:#8a8a8a;"
    "--faint:#e2e2e2;--accent:#0b5cad}"
    "@media(prefers-color-scheme:dark){:root{--text:#e8e8e8;--muted:#a8a8a8;--ground:#161616;"
    "--line:#858585;--faint:#333;--accent:#7db8f2}}"
    "body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:72em;padding:0 1em;"
    "color:var(--text);background:var(--ground)}"
    "h1{margin:0 0 .2em;line-height:1.2}h2{margin:1.8em 0 .4em;font-size:1.25em}"
    "h2::first-letter{text-transform:uppercase}"
    "h3{font-size:.9em;font-weight:600;color:var(--muted)}"
    "a{color:var(--accent)}.head p{margin:.1em 0;color:var(--muted)}"
    ".head .state{color:var(--text);font-size:1.1em}"
    ".note{color:var(--muted);max-width:50em;margin:.3em 0 0;font-size:.9em}"
    ".scroll{overflow-x:auto}"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums}"
    "caption{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}"
    "th,td{padding:.25em .7em;text-align:right;border-bottom:1px solid var(--faint);"
    "font-weight:400;white-space:nowrap}"
    "thead th{border-bottom:2px solid var(--line);font-weight:600;color:var(--muted)}"
    ".w{text-align:left}tbody tr:hover{background:var(--faint)}"
    ".long td.w{white-space:normal;overflow-wrap:break-word}"
    ".dense{font-size:.85em}.dense th,.dense td{padding:.2em .55em}"
    "svg{max-width:100%;height:auto;display:block;margin-bottom:.8em}svg "
    "text{fill:var(--text);font-size:13px}"
    "pre{overflow-x:auto;border:1px solid var(--faint);padding:.6em .8em;font-size:.85em}"
    "footer{margin-top:2em;color:var(--muted);font-size:.85em}"
    ".chart-box{overflow-x:auto;min-width:0}.chart-box svg{min-width:510px}"
    ".charts{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,510px),1fr));gap:1."
    "2em}"
    ".charts svg{width:100%;margin:0;border-radius:6px}"
    "iframe{width:100%;height:46em;border:1px solid var(--faint);border-radius:6px}"
    "@media print{:root{--text:#000;--muted:#333;--ground:#fff;--line:#666;--faint:#ccc;"
    "--accent:#000}body{margin:0;max-width:none;font-size:10pt}"
    "iframe,#replay{display:none}.scroll,.bracket,pre{overflow:visible}pre{white-space:pre-wrap;"
    "overflow-"
    "wrap:anywhere}"
    "h2{break-after:avoid}tr,li,svg{break-inside:avoid}}";

}  // namespace

std::string_view report_style() { return kReportStyle; }

std::string text_element(std::string_view tag, std::string_view text, std::string_view kind) {
  if (text.empty()) return {};
  const std::string attribute = kind.empty() ? "" : fmt::format(" class=\"{}\"", kind);
  return fmt::format("<{0}{1}>{2}</{0}>\n", tag, attribute, base::escape_xml(text));
}

std::string commands_box(std::string_view commands) {
  return fmt::format("<pre tabindex=\"0\">{}</pre>\n", base::escape_xml(commands));
}

std::string chart_box(std::string_view label, std::string_view svg) {
  return fmt::format(
      "<div class=\"chart-box\" tabindex=\"0\" role=\"region\" aria-label=\"Chart: "
      "{}\">\n{}</div>\n",
      base::escape_xml(label), svg);
}

std::string table_box(std::string_view title, const base::Table& table, std::string_view kind) {
  return fmt::format(
      "<div class=\"{}\" tabindex=\"0\" role=\"region\" aria-label=\"{}\">\n{}</div>\n", kind,
      base::escape_xml(title), table.format_html(title));
}

std::string table_section(std::string_view title, const base::Table& table, std::string_view note,
                          std::string_view kind) {
  if (table.empty()) return {};
  return text_element("h2", title) + table_box(title, table, kind) +
         text_element("p", note, "note");
}

}  // namespace cls::viewer
