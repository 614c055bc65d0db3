// No source, test, doc page or scenario contains a term that docs/glossary.md replaces.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/architecture/source_files.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;

/// A term to avoid. Matches whole words; a leading or trailing '*' also matches inside a word. A
/// lower-case term also matches with a capital first letter.
struct BannedTerm {
  std::string_view term;
  std::string_view instead;
  /// Files where it is allowed: the start of paths.
  std::array<std::string_view, 4> allowed_in{};
  /// A match is allowed inside one of these longer texts: names of the wire or of other programs.
  std::array<std::string_view, 2> allowed_as{};
};

// Never checked: the glossary itself, history, recorded data, the interface with its upstream
// names.
constexpr std::string_view kExcludedPaths[] = {"CHANGELOG.md", "docs/glossary.md", "fixtures/",
                                               "proto/", "tests/architecture/language_test"};

constexpr BannedTerm kBannedTerms[] = {
    // American spelling.
    {"*behaviour*", "behavior"},
    {"*colour*", "color"},
    {"*centre*", "center", {}, {"centre_circle"}},  // accepted in scenarios
    {"metre", "meter"},
    {"metres", "meters"},
    {"kilometre*", "kilometer"},
    {"*neighbour*", "neighbor"},
    {"*defence*",
     "defense",
     {},
     {"\"/shape/defence_x\"", "\"/rating/defence\""}},  // published keys
    {"licence*", "license"},
    {"*analyse*", "analyze"},
    {"*serialise*", "serialize"},
    {"*normalise*", "normalize"},
    {"*initialise*", "initialize"},
    {"*synchronise*", "synchronize"},
    {"*optimise*", "optimize"},
    {"*recognise*", "recognize"},
    {"*favour*", "favor"},
    // Pronouns used as nouns.
    {"nobody",
     "no client, no player, no process",
     {"tests/soccer/protocol_hear_test.cpp"},
     {"nobody_else", "USER=nobody"}},
    {"somebody", "a client, a player, another process"},
    {"everybody", "all players, all clients"},
    {"anybody", "any process, any client", {}, {"(anybody)"}},
    {"whoever", "name the subject"},
    {"of ours", "of cls", {}, {}},
    {"our own", "embedded, own (of cls)"},
    {"our agents", "cls agents"},
    // Paraphrases of standard terms.
    {"told apart", "distinct"},
    {"is told", "receives, is reported"},
    {"are told", "receive, are reported"},
    {"was told", "received, was reported"},
    {"were told", "received, were reported"},
    {"last words", "last output lines"},
    {"goes on", "continues, resumes"},
    {"go on", "continue, resume", {"tests/process/output_log_test.cpp"}},
    {"going on", "continuing"},
    {"carry out", "execute"},
    {"carries out", "executes"},
    {"carried out", "executed"},
    {"carrying out", "executing"},
    {"at once", "immediately; in parallel"},
    {"by itself", "automatically"},
    {"what came of", "result, outcome"},
    {"what becomes of", "result, outcome"},
    {"begin anew", "start over"},
    {"anew", "again"},
    {"let in", "accept"},
    {"lets in", "accepts"},
    {"take leave", "disconnect"},
    {"take leave*", "disconnect"},
    {"held against", "compared with"},
    {"reckon", "compute, predict"},
    {"reckons", "computes, predicts"},
    {"reckoned", "computed, predicted"},
    {"hearsay", "hear messages"},
    {"belief*", "estimate, world model"},
    {"believes", "estimates"},
    {"real server", "rcssserver"},
    {"the real one", "rcssserver"},
    {"foreign team", "external team"},
    {"foreign teams", "external teams"},
    {"foreign server", "external server"},
    {"foreign servers", "external servers"},
    {"foreign guests", "external teams"},
    {"side form", "side"},
    {"side forms", "sides"},
    {"this machine", "the host"},
    {"standing clock", "stopped clock"},
    {"clock stands", "clock is stopped"},
    {"never answers", "sends no reply"},
    {"in mid-match", "during the match"},
    {"row of matches", "fixtures"},
    {"how surely", "confidence"},
    {"play it again", "rerun"},
    {"goalkeeper", "goalie (keepaway: keeper)"},
    // Identifiers.
    {"kMost*", "kMax..."},
    {"kLeast*", "kMin..."},
    {"kLongest*", "kMax..."},
    {"kLargest*", "kMax..."},
    {"kLook", "kPollInterval"},
    {"kLookMs", "kPollIntervalMs"},
    {"kDone", "kOk", {"proxy/", "analysis/", "gamelog/", "tests/gamelog/"}},
    {"kAnswerIsNo", "kFailed"},
    {"mistakes_in", "validate"},
    {"*_brain*", "behavior, policy"},
    {"*Brain", "Behavior, Policy"},
    {"*Chronicle", "Recorder"},
    {"*Desk", "Registry"},
    {"Correspondence", "PlaymakerClient"},
    {"meet_anew", "reregister"},
    {"Foreign*", "External..."},
    {"LoneTeam*", "StandaloneTeam"},
    {"MatchDirector", "MatchHooks"},
    {"ServerTrouble", "ServerErrors"},
    {"ServerNews", "ServerStatus"},
    {"StrengthEstimate", "StaminaEstimate"},
    {"SideFigures", "SideStats"},
    {"Symptom", "DoctorCheck"},
    {"DamageList", "ParseErrors"},
    {"kill_strays", "kill_orphans"},
    {"fetch_children", "reap_children"},
    {"press_on", "escalate"},
    {"left_behind", "recover_results"},
    {"put_back", "requeue"},
    {"door_mark", "listener_mark"},
};

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool starts_with_any(std::string_view path, std::span<const std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(), [&](std::string_view start) {
    return !start.empty() && path.starts_with(start);
  });
}

/// True if the match at [at, at + length) lies inside one of the longer texts.
bool is_part_of(std::string_view text, std::size_t at, std::size_t length,
                std::span<const std::string_view> longer) {
  return std::any_of(longer.begin(), longer.end(), [&](std::string_view whole) {
    if (whole.empty()) return false;
    const std::size_t begin = at < whole.size() ? 0 : at - whole.size();
    const std::size_t found = text.substr(0, at + length + whole.size()).find(whole, begin);
    return found != std::string_view::npos && found <= at && at + length <= found + whole.size();
  });
}

/// Positions of `term` in `text`; the first character must match as given.
std::vector<std::size_t> positions_of(std::string_view text, std::string_view core, bool open_start,
                                      bool open_end) {
  std::vector<std::size_t> positions;
  for (std::size_t at = text.find(core); at != std::string_view::npos;
       at = text.find(core, at + 1)) {
    const std::size_t end = at + core.size();
    const bool starts = open_start || at == 0 || !is_word_character(text[at - 1]);
    const bool ends = open_end || end == text.size() || !is_word_character(text[end]);
    if (starts && ends) positions.push_back(at);
  }
  return positions;
}

/// "PATH:LINE: 'TERM': use ..." for each banned term in a file.
std::vector<std::string> find_banned_terms(std::string_view path, std::string_view text) {
  std::vector<std::string> found;
  for (const BannedTerm& banned : kBannedTerms) {
    if (starts_with_any(path, banned.allowed_in)) continue;
    std::string core(banned.term);
    const bool open_start = core.front() == '*';
    if (open_start) core.erase(0, 1);
    const bool open_end = core.back() == '*';
    if (open_end) core.pop_back();
    std::vector<std::size_t> positions = positions_of(text, core, open_start, open_end);
    if (std::islower(static_cast<unsigned char>(core.front())) != 0) {
      core.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(core.front())));
      const auto capital = positions_of(text, core, open_start, open_end);
      positions.insert(positions.end(), capital.begin(), capital.end());
    }
    for (const std::size_t at : positions) {
      if (is_part_of(text, at, core.size(), banned.allowed_as)) continue;
      const auto line = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n') + 1;
      found.push_back(std::string(path) + ":" + std::to_string(line) + ": '" +
                      std::string(text.substr(at, core.size())) + "': use " +
                      std::string(banned.instead));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

bool is_checked(const fs::path& path) {
  static const std::set<std::string> extensions = {".h",     ".cpp", ".inc", ".md",
                                                   ".cmake", ".py",  ".in",  ".json"};
  const std::string name = path.filename().string();
  return extensions.contains(path.extension().string()) || name == "CMakeLists.txt" ||
         name == "Makefile";
}

/// The banned terms of all files, except in build folders and hidden folders.
std::vector<std::string> find_in_tree() {
  std::vector<std::string> found;
  for (const fs::path& file : source_files()) {
    const std::string path = fs::relative(file, source_folder()).generic_string();
    const bool excluded =
        std::any_of(std::begin(kExcludedPaths), std::end(kExcludedPaths),
                    [&](std::string_view start) { return path.starts_with(start); });
    if (excluded || !is_checked(file)) continue;
    const std::string text = read_file(file);
    const auto terms = find_banned_terms(path, text);
    found.insert(found.end(), terms.begin(), terms.end());
  }
  return found;
}

TEST(Language, UsesTermsOfGlossary) {
  constexpr std::size_t kMaxShown = 200;
  const std::vector<std::string> found = find_in_tree();
  std::string report;
  for (std::size_t i = 0; i < std::min(found.size(), kMaxShown); ++i) report += found[i] + "\n";
  EXPECT_TRUE(found.empty()) << found.size() << " banned terms (see docs/glossary.md):\n" << report;
}

TEST(FindBannedTerms, ReportsFileLineAndReplacement) {
  EXPECT_EQ(
      find_banned_terms("cli/x.cpp", "// fine\n// Nobody listens.\n"),
      std::vector<std::string>{"cli/x.cpp:2: 'Nobody': use no client, no player, no process"});
}

TEST(FindBannedTerms, MatchesInsideIdentifiersOnlyWithAsterisk) {
  EXPECT_EQ(find_banned_terms("a.h", "int team_behaviour_of; class RandomBrain;").size(), 2u);
  EXPECT_EQ(find_banned_terms("a.h", "int kMostLogs; int kLooking; int parameter; metrest").size(),
            1u);
}

TEST(FindBannedTerms, RespectsCaseOfIdentifiers) {
  EXPECT_EQ(find_banned_terms("a.h", "enum { kdone, kAnswerisno, chronicle };").size(), 0u);
  EXPECT_EQ(find_banned_terms("cli/a.h", "enum { kDone };").size(), 1u);
}

TEST(FindBannedTerms, AllowsExceptions) {
  EXPECT_EQ(find_banned_terms("a.h", "dead reckoning").size(), 0u);
  EXPECT_EQ(find_banned_terms("a.h", "{\"nobody_else\", ...}").size(), 0u);
  EXPECT_EQ(find_banned_terms("proxy/a.h", "kDone").size(), 0u);
  EXPECT_EQ(find_banned_terms("a.h", "we go on").size(), 1u);
}

}  // namespace
}  // namespace cls::tests
