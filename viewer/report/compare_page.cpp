// Adds a match and a document to a page.
#include "viewer/report/compare_page.h"

#include <fmt/format.h>

#include "base/text/json.h"
#include "viewer/page/encoding.h"
#include "viewer/stream/chunk_writer.h"

namespace cls::viewer {
namespace {

using base::Json;

std::string stream_of(const gamelog::MatchRecord& record) {
  return write_stream(record, StreamForm{}, "");
}

std::string document_of(const gamelog::MatchRecord& first, const ComparedMatch& a,
                        const gamelog::MatchRecord& second, const ComparedMatch& b) {
  Json json = {{"names", {a.summary->file, b.summary->file}}};
  const auto difference = first_difference(first, second);
  json["first"] = nullptr;
  if (difference) {
    json["first"] = {{"frame", difference->frame}, {"text", difference_text(difference)}};
  }

  json["events"] = Json::array();
  for (const LoneEvent& event : lone_events(*a.statistics, *b.statistics)) {
    json["events"].push_back(
        {{"match", event.match}, {"cycle", event.cycle}, {"text", event.text}});
  }

  const std::vector<std::vector<std::string>> rows = difference_rows(a, b);
  json["columns"] = rows.front();
  json["rows"] = std::vector(rows.begin() + 1, rows.end());
  return inert_json(json.dump(-1, true));
}

}  // namespace

std::string compare_page(const gamelog::MatchRecord& first, const ComparedMatch& a,
                         const gamelog::MatchRecord& second, const ComparedMatch& b,
                         const std::array<std::vector<PageDrawings>, 2>& drawings) {
  const std::string other = base64(gzip(stream_of(second)));
  std::string page =
      write_page(*a.summary, stream_of(first), {.drawings = drawings[0], .compared = true});

  const std::size_t end = page.rfind("</body>");
  page.insert(end, data_elements("other-", drawings[1]));
  page.insert(end, fmt::format("<script type=\"application/cls-view;base64\" id=\"other\" "
                               "data-length=\"{}\">{}</script>\n"
                               "<script type=\"application/json\" id=\"differences\">{}</script>\n",
                               other.size(), other, document_of(first, a, second, b)));
  return page;
}

}  // namespace cls::viewer
