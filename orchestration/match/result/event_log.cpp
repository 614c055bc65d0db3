// One JSON object a line.
#include "orchestration/match/result/event_log.h"

#include <nlohmann/json.hpp>

namespace cls::orchestration::match {

void EventLog::add(int time, std::string_view type, const nlohmann::ordered_json& fields) {
  using Json = nlohmann::ordered_json;
  Json line = {{"schema", "cls.events/1"}, {"seq", next_++}, {"t", time}, {"type", type}};
  line.update(fields);
  sink_.write(line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace cls::orchestration::match
