"""Records episodes on all machines of a Ray cluster, into a folder that all of them see.

    pip install 'FILE[rllib]' pyarrow; ray start --head (and ray start --address ... elsewhere)
    RAY_ADDRESS=auto python3 ray_record.py FOLDER [EPISODES]
A worker that dies loses the episodes that it plays; the same command plays what is missing.
"""
import os
import sys

import numpy as np
import ray

import cls_gym
from cls_gym import data

PART = 20


@ray.remote(num_cpus=1, max_retries=3, scheduling_strategy="SPREAD")
def record(folder, first):
    envs = cls_gym.VectorEnv("cls/HFO-2v1-v0", 10, features="ego", actions="skills",
                             autoreset_mode="disabled", max_cycles=200)
    weights = np.random.default_rng(1).normal(size=(51, 83))

    def policy(observations, masks):
        return (observations @ weights - 1e9 * (masks == 0)).argmax(axis=1)

    data.record(envs, policy, PART, folder, first=first)
    return ray.get_runtime_context().get_node_id()


if __name__ == "__main__":
    folder = os.path.abspath(sys.argv[1])
    episodes = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    ray.init(log_to_driver=False)
    nodes = ray.get([record.remote(folder, first) for first in range(0, episodes, PART)])
    print(f"{len(data.files(folder))} episodes from {len(set(nodes))} nodes")
