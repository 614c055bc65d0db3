#!/usr/bin/env python3
"""Speed of the example team in each language, with one call per agent and with one per team.

    bench/languages.py [--cls build/bin/cls] [--cycles 2000] [--rounds 3] [LANGUAGE...]

Plays the same match against mock with each language and both services, in turn, and prints a Markdown
table: cycles per second, CPU seconds per 1000 cycles of the Playmaker's program, latency of its
decisions (median player, and 99th percentile of the slowest player; a call for the whole team counts
for each player). The best round counts. Builds the teams first. All must play the same match.
csharp-aot is the team in C# as machine code.
"""
import argparse
import json
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
LANGUAGES = ("python", "javascript", "typescript", "go", "java", "rust", "csharp", "csharp-aot")
SERVICES = {"one per agent": "never", "one per team": "always"}


def commands(language):
    """What builds a team, and what starts it."""
    folder = os.path.join(ROOT, "examples", language.removesuffix("-aot"))
    run = os.path.join(folder, "run")
    if language == "csharp-aot":
        return [run, "publish", "aot"], os.path.join(folder, ".build", "publish", "Team")
    return [run, "build"], run


def play(options, language, batch):
    """result.json of a match and its game log."""
    team = commands(language)[1]
    with tempfile.TemporaryDirectory() as folder:
        played = subprocess.run(
            [options.cls, "match", f"run:exec {team} --port {{port}} --coach", "mock", "--left-name",
             "team", "--seed", "1", "--cycles", str(options.cycles), "--batch", batch,
             "--start-timeout", "60", "--dir", os.path.join(folder, "match"), "--json"],
            capture_output=True, text=True)
        if played.returncode != 0:
            sys.exit(played.stderr)
        with open(os.path.join(folder, "match", "match.rcg"), "rb") as log:
            return json.loads(played.stdout), log.read()


def row(result):
    players = result["left"]["players"]
    program = next(one for one in result["processes"] if one["name"] == "left Playmaker")
    medians = sorted(player["rpc_us"]["p50"] for player in players)
    return {"cycles/s": result["cycles_per_second"],
            "CPU s / 1000 cycles": 1000 * program["cpu_seconds"] / result["cycles"],
            "p50 us": medians[len(medians) // 2],
            "worst p99 us": max(player["rpc_us"]["p99"] for player in players)}


def built(language):
    """Why a team cannot be built here; empty: it is built."""
    made = subprocess.run(commands(language)[0], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if made.returncode == 0:
        return ""
    plain = re.sub(r"\x1b\[[0-9;]*m", "", made.stdout)
    lines = [line.strip() for line in plain.splitlines() if re.search(r"[A-Za-z]", line)]
    errors = [line for line in lines if re.search(r"error|not found", line, re.IGNORECASE)]
    return (errors or lines or [f"exit code {made.returncode}"])[0]


def build(options):
    """The languages that take part, and why each of the others does not."""
    problems = {language: built(language) for language in options.languages or LANGUAGES}
    skipped = {language: why for language, why in problems.items() if why}
    for language, why in skipped.items():
        print(f"skipped {language}: {why}", file=sys.stderr)
    if skipped and (options.languages or len(skipped) == len(problems)):
        sys.exit("no team to compare" if not options.languages else "a named language is missing")
    return [language for language in problems if language not in skipped], skipped


def main():
    parser = argparse.ArgumentParser(description="Compares the example teams.")
    parser.add_argument("languages", nargs="*", metavar="LANGUAGE")
    parser.add_argument("--cls", default=os.path.join(ROOT, "build/bin/cls"))
    parser.add_argument("--cycles", type=int, default=2000)
    parser.add_argument("--rounds", type=int, default=3)
    options = parser.parse_args()
    languages, skipped = build(options)
    best, logs = {}, set()
    for _ in range(options.rounds):
        for language in languages:
            for calls, batch in SERVICES.items():
                result, log = play(options, language, batch)
                logs.add(log)
                found = row(result)
                known = best.get((language, calls))
                if known is None or found["cycles/s"] > known["cycles/s"]:
                    best[language, calls] = found
    names = list(next(iter(best.values())))
    print("| language | calls | " + " | ".join(names) + " |")
    print("|---|---|" + "--:|" * len(names))
    for (language, calls), values in best.items():
        print(f"| {language} | {calls} | " + " | ".join(
            f"{values[name]:.2f}" if values[name] < 10 else f"{values[name]:.0f}"
            for name in names) + " |")
    if skipped:
        print(f"\nNot built here: {', '.join(skipped)}.")
    if len(logs) != 1:
        sys.exit("the languages played different matches")


if __name__ == "__main__":
    main()
