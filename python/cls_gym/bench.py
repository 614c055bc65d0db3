"""Measures the speed of environments: python3 -m cls_gym.bench [TASK ...]

World steps per second with random actions of a fixed seed, through VectorEnv (`python`) and
through the engine alone (`engine`): calls of the same functions without spaces, copies and infos.
The share is the median over rounds that measure both in turn. `reset` is the time of a reset with
its first observation, in microseconds per world.
"""
from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from typing import Any, Dict, List

import numpy as np

import cls_gym


def random_actions(envs: cls_gym.VectorEnv, count: int) -> List[Any]:
    """Batches of random actions."""
    envs.action_space.seed(1)
    return [envs.action_space.sample() for _ in range(count)]


def _python(envs: cls_gym.VectorEnv, actions: List[Any], steps: int) -> float:
    start = time.perf_counter()
    for number in range(steps):
        envs.step(actions[number % len(actions)])
    return time.perf_counter() - start


def _engine(envs: cls_gym.VectorEnv, steps: int) -> float:
    """The engine with the actions that its buffers hold, ended episodes reset as above."""
    pool = envs._worlds.pool  # noqa: SLF001
    seeds = np.arange(envs.num_envs, dtype=np.uint64)
    start = time.perf_counter()
    for _ in range(steps):
        pool.step()
        ended = pool.terminated | pool.truncated
        if ended.any():
            pool.reset(ended, seeds)
    return time.perf_counter() - start


def _reset(envs: cls_gym.VectorEnv, count: int) -> float:
    """Seconds of a reset of all worlds."""
    pool = envs._worlds.pool  # noqa: SLF001
    seeds = np.arange(envs.num_envs, dtype=np.uint64)
    start = time.perf_counter()
    for _ in range(count):
        pool.reset(None, seeds)
        seeds += np.uint64(envs.num_envs)
    return (time.perf_counter() - start) / count


def measure(task: str, obs: str, num_envs: int, threads: int, rounds: int,
            seconds: float) -> Dict[str, Any]:
    """One row of the table."""
    envs = cls_gym.VectorEnv(task, num_envs, obs=obs, threads=threads,
                             autoreset_mode="same_step")
    actions = random_actions(envs, 64)
    envs.reset(seed=1)
    took, steps = 0.0, 8
    while took < seconds / 4:  # also warms up
        steps *= 2
        took = _python(envs, actions, steps)
    steps = max(1, int(steps * seconds / took))
    python, engine, resets = [], [], []
    for _ in range(rounds):
        python.append(steps * num_envs / _python(envs, actions, steps))
        engine.append(steps * num_envs / _engine(envs, steps))
        resets.append(1e6 * _reset(envs, 10) / num_envs)
        envs.reset(seed=1)
    agents = len(envs.spec_of_task.agents)
    envs.close()
    return {"task": task, "obs": obs, "num_envs": num_envs, "threads": threads, "agents": agents,
            "python": statistics.median(python), "engine": statistics.median(engine),
            "reset_us": statistics.median(resets),
            "share": statistics.median(p / e for p, e in zip(python, engine))}


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m cls_gym.bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tasks", nargs="*", metavar="TASK",
                        default=["cls/HFO-1v0-v0", "cls/HFO-2v2-v0"],
                        help="ids (default: 1v0 and 2v2)")
    parser.add_argument("--obs", choices=("full_state", "world_model"), default="full_state",
                        help="what agents know (default: full_state)")
    parser.add_argument("--num-envs", type=int, default=64, metavar="N")
    parser.add_argument("--threads", type=int, default=1, metavar="T")
    parser.add_argument("--rounds", type=int, default=5, metavar="N")
    parser.add_argument("--seconds", type=float, default=1.0, metavar="S",
                        help="of each measurement")
    parser.add_argument("--json", action="store_true", help="print a JSON document")
    options = parser.parse_args()
    rows = []
    if not options.json:
        print(f"{'task':<28} {'N':>4} {'T':>2} {'python/s':>10} {'engine/s':>10} "
              f"{'share':>6} {'reset':>6}")
    for task in options.tasks:
        row = measure(task, options.obs, options.num_envs, options.threads, options.rounds,
                      options.seconds)
        rows.append(row)
        if not options.json:
            print(f"{task:<28} {row['num_envs']:>4} {row['threads']:>2} {row['python']:>10.0f} "
                  f"{row['engine']:>10.0f} {row['share']:>6.2f} {row['reset_us']:>6.1f}",
                  flush=True)
    if options.json:
        json.dump({"schema": "cls.training.bench/1", "rows": rows}, sys.stdout, indent=2)
        print()
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (cls_gym.EngineError, ImportError) as error:
        sys.exit(f"cls_gym.bench: {error}")
