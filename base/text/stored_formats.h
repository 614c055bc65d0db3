// Versions of the formats of files that cls writes and reads again, if they have no other place.
// A newer one must read the older ones; fixtures/formats has a file of each.
#pragma once

namespace cls::base {

constexpr const char* kMatchSchema = "cls.match/1";        ///< result.json
constexpr const char* kScenarioSchema = "cls.scenario/1";  ///< scenario files
constexpr int kConfigSchema = 1;                           ///< cls.toml, plan.toml
constexpr int kTuneSchema = 1;                             ///< tune.toml
constexpr int kPlannerSchema = 1;                          ///< parameters of the planner
constexpr int kStoreSchema = 2;                            ///< tournament.db

}  // namespace cls::base
