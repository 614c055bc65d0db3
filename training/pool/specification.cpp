// Builds the documents from the tables.
#include "training/pool/specification.h"

#include <cmath>
#include <string>

#include "base/text/json.h"

namespace cls::training {
namespace {

using base::Json;

// Floats as the decimals that were written in the tables: -1.2 rather than -1.2000000476837158.
double tidy(float value) { return std::round(static_cast<double>(value) * 1e6) / 1e6; }

Json to_json(const Column& column) {
  return {{"name", column.name},
          {"unit", column.unit},
          {"low", tidy(column.low)},
          {"high", tidy(column.high)}};
}

Json to_json(const Columns& columns) {
  Json list = Json::array();
  for (const Column& column : columns) list.push_back(to_json(column));
  return list;
}

Json to_json(const TaskOption& option) {
  return {{"name", option.name},
          {"default", option.value},
          {"low", option.low},
          {"high", option.high},
          {"summary", option.summary}};
}

Json to_json(const Range& range) {
  return {{"low", range.low}, {"high", range.high}, {"default", range.usual}};
}

Json status_list() {
  Json list = Json::array();
  for (std::size_t i = 0; i < statuses().size(); ++i) {
    const StatusInfo& status = statuses()[i];
    list.push_back({{"number", i},
                    {"name", status.name},
                    {"truncated", status.truncated},
                    {"summary", status.summary}});
  }
  return list;
}

Json reward_list(const std::array<double, kRewardTerms>* weights) {
  Json list = Json::array();
  for (std::size_t i = 0; i < kRewardTerms; ++i) {
    const RewardTerm& term = reward_terms()[i];
    list.push_back({{"name", term.name},
                    {"weight", weights != nullptr ? (*weights)[i] : term.weight},
                    {"unit", term.unit},
                    {"low", term.low},
                    {"high", term.high},
                    {"summary", term.summary}});
  }
  return list;
}

Json action_list(const ActionSet& set) {
  Json list = Json::array();
  for (std::size_t id = 0; id < set.actions.size(); ++id) {
    list.push_back({{"id", id},
                    {"name", set.actions[id].name},
                    {"parameters", to_json(set.actions[id].parameters)}});
  }
  return list;
}

Json describe(const FeatureSet& set) {
  return {{"set", set.name},
          {"version", set.version},
          {"summary", set.summary},
          {"offense_only", set.left_only}};
}

Json describe(const ActionSet& set) {
  const Columns values = set.values();
  return {{"set", set.name},           {"version", set.version},        {"summary", set.summary},
          {"ids", set.actions.size()}, {"values", values.size()},       {"id_low", 0},
          {"items", action_list(set)}, {"value_items", to_json(values)}};
}

Json names_of(const DriverPool& pool) {
  Json names = Json::array();
  for (const DriverShare& share : pool) {
    names.push_back(kDriverNames.name(share.driver));
  }
  return names;
}

Json describe(const std::vector<SenseHead>& heads) {
  Json list = Json::array();
  for (const SenseHead& head : heads) list.push_back({{"name", head.name}, {"items", head.items}});
  return list;
}

Json describe_state(const Setup& setup) {
  return {{"version", setup.state_version},
          {"size", setup.state_columns.size()},
          {"items", to_json(setup.state_columns)}};
}

}  // namespace

Json document_of(const Task& task) {
  Json options = Json::array();
  for (const TaskOption& option : task.options) options.push_back(to_json(option));
  return {{"id", task.id},
          {"version", task.version},
          {"summary", task.summary},
          {"offense", to_json(task.offense)},
          {"defense", to_json(task.defense)},
          {"agents", kAgentsNames.name(task.agents)},
          {"features", task.features},
          {"actions", task.actions},
          {"referee", task.referee},
          {"max_cycles", task.max_cycles},
          {"options", options}};
}

Json document_of(const FeatureSet& set, int teammates, int opponents) {
  Json document = describe(set);
  document["teammates"] = teammates;
  document["opponents"] = opponents;
  document["items"] = to_json(set.columns(teammates, opponents));
  return document;
}

Json document_of(const ActionSet& set) { return describe(set); }

Json catalog() {
  Json task_list = Json::array();
  for (const Task& task : tasks()) task_list.push_back(document_of(task));

  Json features = Json::array();
  for (const FeatureSet* set : feature_sets()) {
    features.push_back(describe(*set));
    features.back()["items_1v1"] = to_json(set->columns(0, 1));
  }

  Json actions = Json::array();
  for (const ActionSet* set : action_sets()) actions.push_back(describe(*set));

  return {{"schema", kCatalogSchema},         {"tasks", task_list},
          {"feature_sets", features},         {"action_sets", actions},
          {"reward_version", kRewardVersion}, {"reward_terms", reward_list(nullptr)},
          {"statuses", status_list()}};
}

Json specification(const Pool& pool) {
  const Setup& setup = pool.setup();
  Json agents = Json::array();
  for (const int slot : setup.cast.agents) agents.push_back(agent_name(slot));

  Json options = Json::object();
  for (std::size_t i = 0; i < setup.task->options.size(); ++i) {
    options[std::string(setup.task->options[i].name)] = pool.config().options[i];
  }

  return {{"schema", "cls.training.spec/1"},
          {"task", setup.task->id},
          {"version", setup.task->version},
          {"half", setup.task->half},
          {"obs", kFidelityNames.name(setup.fidelity)},
          {"num_envs", pool.size()},
          {"threads", pool.threads()},
          {"num_agents", setup.agent_count()},
          {"agents", agents},
          {"offense", setup.cast.left.size()},
          {"defense", setup.cast.right.size()},
          {"features",
           {{"set", setup.features->name},
            {"version", setup.features->version},
            {"size", setup.feature_count()},
            {"items", to_json(setup.feature_columns)}}},
          {"actions", describe(*setup.actions)},
          {"senses", describe(setup.sense_heads)},
          {"state", describe_state(setup)},
          {"reward_version", kRewardVersion},
          {"reward_terms", reward_list(&setup.weights)},
          {"teammates", names_of(setup.teammates)},
          {"opponents", names_of(setup.opponents)},
          {"start", setup.start},
          {"max_cycles", setup.max_cycles},
          {"frame_skip", setup.frame_skip},
          {"until", kUntilNames.name(setup.until)},
          {"expert", kExpertNames.name(setup.expert ? Expert::kPlanner : Expert::kNone)},
          {"autoreset", kAutoresetNames.name(pool.config().autoreset)},
          {"options", options},
          {"statuses", status_list()}};
}

}  // namespace cls::training
