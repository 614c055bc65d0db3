#!/usr/bin/env python3
"""Training steps side by side: this build and, optionally, another one.

    bench/training.py                                  build/lib alone
    bench/training.py --base OTHER/lib/libcls_training.so    alternating with another build

Prints a table, medians over the rounds: world steps per second of processor time of the engine,
with masks and the features and actions of the examples. Environment, optional:
    CLS_BENCH_BASE      a binary bin/cls of another build, whose library is beside it in lib/
"""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BENCH = ROOT / "python/cls_gym/bench.py"
LIBRARY = "libcls_training.so"
NAME_WIDTH = 40


def options():
    beside = os.environ.get("CLS_BENCH_BASE", "")
    base = str(pathlib.Path(beside).resolve().parent.parent / "lib" / LIBRARY) if beside else ""
    parser = argparse.ArgumentParser(description="Training steps of two builds, side by side.")
    parser.add_argument("--library", dest="engine", metavar="LIBRARY",
                        default=str(ROOT / "build/lib" / LIBRARY),
                        help="library to measure")
    parser.add_argument("--base", default=base, help="library to compare with")
    parser.add_argument("--rounds", type=int, default=5, help="of each row (default: 5)")
    return parser.parse_args()


def cases():
    """Name and arguments of cls_gym.bench."""
    for num_envs in (1, 64, 1024):
        for task in ("cls/HFO-1v0-v0", "cls/HFO-2v2-v0", "cls/Match-v0"):
            yield (f"{task} N={num_envs}",
                   [task, "--num-envs", str(num_envs), "--threads", "1", "--seconds", "0.2"])
    world_model = ["cls/Match-v0", "--num-envs", "64", "--threads", "1", "--obs", "world_model"]
    yield "cls/Match-v0 N=64, world model", world_model
    yield ("cls/Match-v0 N=64, world model, planner", [*world_model, "--opponent", "planner"])


def package_of(library):
    """The folder of the cls_gym of that build: another one may not fit its interface."""
    beside = pathlib.Path(library).resolve().parent.parent / "python"
    return beside if (beside / "cls_gym").exists() else ROOT / "python"


def steps(library, arguments):
    """Steps per second of processor time."""
    # The program of this tree, because that of an older package has fewer options.
    program = f"import runpy; runpy.run_path({str(BENCH)!r}, run_name='__main__')"
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    environment = {**os.environ, "CLS_TRAINING_LIBRARY": library,
                   "PYTHONPATH": str(package_of(library))}
    done = subprocess.run([python, "-c", program, *arguments, "--rounds", "1", "--json"],
                          env=environment, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"bench/training.py: {done.stderr.strip()}")
    return json.loads(done.stdout)["rows"][0]["engine_cpu"]


def main():
    chosen = options()
    libraries = [chosen.engine] + ([chosen.base] if chosen.base else [])
    for library in libraries:
        if not os.path.exists(library):
            sys.exit(f"bench/training.py: no {library}; build cls_training_shared first")
    print(f"{'training, steps per CPU second':<{NAME_WIDTH}} {'this':>10}"
          + (f" {'base':>10} {'ratio':>6}" if chosen.base else ""))
    for name, arguments in cases():
        figures = [[steps(library, arguments) for library in libraries]
                   for _ in range(chosen.rounds)]
        medians = [statistics.median(column) for column in zip(*figures)]
        line = f"{name:<{NAME_WIDTH}} " + " ".join(f"{one:>10.0f}" for one in medians)
        if chosen.base:
            line += f" {statistics.median(new / old for new, old in figures):>6.2f}"
        print(line, flush=True)


if __name__ == "__main__":
    main()
