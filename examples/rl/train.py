#!/usr/bin/env python3
"""Improves policy.txt: changes its weights at random, plays, and keeps what is not worse.

    ./run build
    python3 train.py --rounds 50

A round takes half a minute; Ctrl-C ends it, and policy.txt has the best weights so far. Each round
plays the same seeds with the old and the new weights, so that luck counts for little. The team is named
@NAME@ in cls.toml; the environment variable POLICY names the file that it reads. docs/training.md
of cls has environments for larger policies and faster learning.
"""
import argparse
import json
import os
import random
import subprocess
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
POLICY = os.path.join(HERE, "policy.txt")


def read(path):
    """Lines of the file; weights as lists [action, weight, ...]."""
    with open(path, encoding="utf-8") as file:
        return [line.split() if line.strip() and not line.startswith("#") else line.rstrip("\n")
                for line in file]


def write(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        for line in lines:
            if isinstance(line, list):
                line = f"{line[0]:<8}" + "".join(f" {float(value):6.2f}" for value in line[1:])
            print(line, file=file)


def changed(lines, step, random_source):
    return [[line[0]] + [float(value) + random_source.gauss(0, step) for value in line[1:]]
            if isinstance(line, list) else line for line in lines]


def value(path, options, label):
    """Goals for minus goals against, over all seeds. Prints the score of each match."""
    print(f"{label}:", end="", flush=True)
    total = 0
    for seed in range(1, options.seeds + 1):
        with tempfile.TemporaryDirectory() as folder:
            played = subprocess.run(
                ["cls", "match", "@NAME@", options.opponent, "--seed", str(seed), "--cycles",
                 str(options.cycles), "--dir", os.path.join(folder, "match"), "--json"],
                cwd=HERE, env={**os.environ, "POLICY": path}, capture_output=True, text=True)
        if played.returncode != 0:
            raise SystemExit(played.stderr.strip())
        result = json.loads(played.stdout)
        goals, against = result["left"]["score"], result["right"]["score"]
        print(f"  {goals}:{against}", end="", flush=True)
        total += goals - against
    print(f"  goal difference {total:+}", end="", flush=True)
    return total


def train(options):
    random_source = random.Random(1)
    best = value(POLICY, options, "policy.txt")
    started = time.monotonic()
    for number in range(1, options.rounds + 1):
        with tempfile.TemporaryDirectory() as folder:
            candidate = os.path.join(folder, "policy.txt")
            lines = changed(read(POLICY), options.step, random_source)
            write(candidate, lines)
            found = value(candidate, options, f"\nround {number}/{options.rounds}")
        if found >= best:
            best = found
            write(POLICY, lines)
            print(", stored in policy.txt", end="")
        left = (time.monotonic() - started) / number * (options.rounds - number)
        print(f"  {left / 60:.1f} min left", end="", flush=True)
    print(f"\nbest goal difference: {best:+} over {options.seeds} seeds")


def main():
    parser = argparse.ArgumentParser(description="Trains policy.txt.")
    parser.add_argument("--rounds", type=int, default=20)
    parser.add_argument("--seeds", type=int, default=3, help="matches per round (default: 3)")
    parser.add_argument("--cycles", type=int, default=3000, help="of a match (default: 3000)")
    parser.add_argument("--opponent", default="mock", help="SIDE (default: mock)")
    parser.add_argument("--step", type=float, default=0.3, help="of a change (default: 0.3)")
    options = parser.parse_args()
    try:
        train(options)
    except KeyboardInterrupt:
        raise SystemExit("\ninterrupted; policy.txt has the best weights so far")


if __name__ == "__main__":
    main()
