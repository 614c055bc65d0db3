// Speed of reading, writing and evaluating game logs and text logs: a whole match of 6000 cycles
// (CLS_DATA), else the start of one, repeated to the same length.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <utility>

#include "analysis/results/match_summary.h"
#include "analysis/statistics/match_statistics.h"
#include "analysis/statistics/statistics_json.h"
#include "base/io/byte_sink.h"
#include "base/io/gzip_sink.h"
#include "gamelog/rcg/rcg_reader.h"
#include "gamelog/rcg/record_writer.h"
#include "gamelog/rcl/logged_commands.h"
#include "gamelog/rcl/rcl_reader.h"
#include "tests/support/files.h"

namespace {

using namespace cls::base;
using namespace cls::gamelog;
using namespace cls::analysis;

constexpr std::size_t kWholeMatch = 20'000'000;

// Repeats `log` from the first line that starts with `start` until it has the size of a match.
std::string repeated(const std::string& log, std::string_view start) {
  const std::size_t first = log.find(start);
  std::string result = log;
  while (result.size() < kWholeMatch) result.append(log, first);
  return result;
}

std::string load(const char* ending, std::string_view first_line) {
  const auto path = cls::tests::data(std::string("logs/helios-vs-helios-full") + ending);
  if (path) return cls::tests::read_file(*path);
  return repeated(
      cls::tests::read_file(cls::tests::fixture(std::string("gamelog/match-start") + ending)),
      first_line);
}

const std::string& game_log() {
  static const std::string log = load(".rcg.gz", "(show 1 ");
  return log;
}

const std::string& text_log() {
  static const std::string log = load(".rcl.gz", "1,0\t");
  return log;
}

MatchRecord read(std::string_view log) {
  MemorySource source(log);
  return read_rcg(source);
}

const MatchRecord& record() {
  static const MatchRecord match = read(game_log());
  return match;
}

const RclRecord& text_record() {
  static const RclRecord text = [] {
    MemorySource source(text_log());
    return read_rcl(source);
  }();
  return text;
}

std::string format_log(RcgVersion version) {
  StringSink sink;
  write_rcg(record(), version, sink);
  return sink.bytes();
}

void set_bytes(benchmark::State& bench, std::size_t bytes) {
  bench.SetBytesProcessed(static_cast<std::int64_t>(bench.iterations()) *
                          static_cast<std::int64_t>(bytes));
}

void read_game_log(benchmark::State& bench) {
  const auto version = static_cast<RcgVersion>(bench.range(0));
  const std::string log = version == RcgVersion::kV6 ? game_log() : format_log(version);
  for (auto _ : bench) benchmark::DoNotOptimize(read(log).frames());
  set_bytes(bench, log.size());
}
BENCHMARK(read_game_log)
    ->ArgName("version")
    ->Arg(static_cast<int>(RcgVersion::kV6))
    ->Arg(static_cast<int>(RcgVersion::kV4))
    ->Arg(static_cast<int>(RcgVersion::kJson))
    ->Unit(benchmark::kMillisecond);

// Size of the decompressed log in bytes.
void read_gzip_game_log(benchmark::State& bench) {
  auto memory = std::make_unique<StringSink>();
  const StringSink& compressed = *memory;
  GzipSink sink(std::move(memory));
  sink.write(game_log());
  if (!sink.close()) bench.SkipWithError("gzip");

  for (auto _ : bench) {
    const auto source = decompress(std::make_unique<MemorySource>(compressed.bytes()));
    benchmark::DoNotOptimize(read_rcg(*source).frames());
  }
  set_bytes(bench, game_log().size());
}
BENCHMARK(read_gzip_game_log)->Unit(benchmark::kMillisecond);

void write_game_log(benchmark::State& bench) {
  const auto version = static_cast<RcgVersion>(bench.range(0));
  std::size_t bytes = 0;
  for (auto _ : bench) bytes = format_log(version).size();
  set_bytes(bench, bytes);
}
BENCHMARK(write_game_log)
    ->ArgName("version")
    ->Arg(static_cast<int>(RcgVersion::kV6))
    ->Arg(static_cast<int>(RcgVersion::kJson))
    ->Unit(benchmark::kMillisecond);

void read_text_log(benchmark::State& bench) {
  for (auto _ : bench) {
    MemorySource source(text_log());
    benchmark::DoNotOptimize(read_rcl(source).lines.size());
  }
  set_bytes(bench, text_log().size());
}
BENCHMARK(read_text_log)->Unit(benchmark::kMillisecond);

void summarize_match(benchmark::State& bench) {
  for (auto _ : bench) benchmark::DoNotOptimize(summarize(record(), nullptr).goals.size());
}
BENCHMARK(summarize_match)->Unit(benchmark::kMillisecond);

void compute_match_statistics(benchmark::State& bench) {
  const RclRecord* text = bench.range(0) != 0 ? &text_record() : nullptr;
  for (auto _ : bench) benchmark::DoNotOptimize(compute_statistics(record(), text).passes.size());
}
BENCHMARK(compute_match_statistics)
    ->ArgName("text_log")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);

// Everything that `cls stats --json` does for one match after reading its files.
void whole_statistics(benchmark::State& bench) {
  for (auto _ : bench) {
    const MatchRecord match = read(game_log());
    MemorySource source(text_log());
    const RclRecord text = read_rcl(source);
    const MatchStatistics statistics = compute_statistics(match, &text);
    benchmark::DoNotOptimize(statistics_json(summarize(match, &text), statistics, false).size());
  }
  set_bytes(bench, game_log().size() + text_log().size());
}
BENCHMARK(whole_statistics)->Unit(benchmark::kMillisecond);

}  // namespace
