// Formats the card.
#include "tournament/dataset/data_card.h"

#include <fmt/format.h>

#include <iterator>
#include <set>

#include "tournament/config/config_file.h"

namespace cls::tournament {
namespace {

struct Totals {
  std::int64_t cycles = 0;
  std::set<std::string> versions;
  std::set<std::uint64_t> seeds;
  bool deterministic = true;
};

Totals totals_of(const std::vector<DatasetMatch>& matches) {
  Totals totals;
  for (const DatasetMatch& match : matches) {
    totals.cycles += match.cycles;
    totals.versions.insert(match.version);
    totals.seeds.insert(match.fixture.seed);
    totals.deterministic = totals.deterministic && match.deterministic;
  }
  return totals;
}

constexpr const char* kFiles =
    "## Files\n\n"
    "| file | contents |\n|---|---|\n"
    "| `matches.jsonl` | a line for each match: seed, teams, score, files with size and SHA-256 |\n"
    "| `dataset.toml` | the specification: teams, schedule, settings of the server |\n"
    "| `shards/NNN/NUMBER.view.gz` | full state of each cycle, without loss (cls.view/1) |\n"
    "| `shards/NNN/NUMBER.left.world-models`, `.right.world-models` | for each decision of each "
    "player: its estimates, the reply of its Playmaker, its commands (cls.decisions/1) |\n\n"
    "A folder in `shards` has 1000 matches. `work` is for `cls dataset make` only.\n\n"
    "## Use\n\n"
    "```sh\n"
    "cls convert . --tables tables --format arrow   # frames, events, world models\n"
    "cls convert . --tables csv                     # the CSV tables of the published data sets\n"
    "cls convert shards/000/000001.view.gz 1.rcg    # a game log\n"
    "cls dataset verify .                           # hashes, and a match played again\n"
    "```\n\n"
    "Columns and units: docs/data.md of cls (`cls help data`).\n\n";

constexpr const char* kLicense =
    "## License\n\n"
    "The matches are facts that a program computed; `cls` claims no rights in them. Before you "
    "publish this data set,\nname its license here, and ask the authors of external teams and "
    "Playmakers.\n";

}  // namespace

std::string data_card(const TournamentConfig& config, const std::vector<DatasetMatch>& matches) {
  const Totals totals = totals_of(matches);
  const DatasetSize size = size_of(matches);
  std::string card = fmt::format(
      "# {}\n\nMatches of simulated robot soccer (RoboCup 2D), with what each robot knew beside "
      "what was so.\n\n",
      config.report.name.empty() ? "Data set" : config.report.name);

  const auto out = std::back_inserter(card);
  fmt::format_to(out, "| | |\n|---|---|\n| matches | {}, {} with files |\n| cycles | {} |\n",
                 matches.size(), size.valid, totals.cycles);
  fmt::format_to(out, "| size | {:.1f} MB, {:.2f} MB a match |\n", size.megabytes(),
                 size.megabytes_each());
  fmt::format_to(out, "| seed | {}; {} different seeds of matches, in `matches.jsonl` |\n",
                 config.competition.seed, totals.seeds.size());
  if (const std::string twins = twin_sides(config); !twins.empty()) {
    fmt::format_to(out, "| mirror images | {} |\n", twins);
  }
  fmt::format_to(out, "| cls | {} |\n", fmt::join(totals.versions, ", "));
  fmt::format_to(out, "| same bytes in each run | {} |\n\n",
                 totals.deterministic ? "yes" : "no: a side or the server is not deterministic");

  card += kFiles;
  card += "## How it was made\n\n`cls dataset make dataset.toml DIR`, with this file:\n\n```toml\n";
  card += format_config(config, true);
  return card + "```\n\n" + kLicense;
}

}  // namespace cls::tournament
