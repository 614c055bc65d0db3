"""Actors on a Ray cluster that keep their worlds and record parts of a data set one after the other.

    pip install 'FILE[rllib]' pyarrow
    RAY_ADDRESS=auto python3 ray_actors.py FOLDER [EPISODES]
Each line is "PART NODE PROCESS". A killed actor is started again and plays what its part misses.
"""
import os
import sys

import numpy as np
import ray
from cls_gym import VectorEnv, data
from ray.util import ActorPool

PART = 20


@ray.remote(num_cpus=1, max_restarts=-1, max_task_retries=-1, scheduling_strategy="SPREAD")
class Recorder:
    def __init__(self, folder):
        self.folder, self.weights = folder, np.random.default_rng(1).normal(size=(51, 83))
        self.envs = VectorEnv("cls/HFO-2v1-v0", 10, features="ego", actions="skills",
                              autoreset_mode="disabled", max_cycles=200)

    def policy(self, observations, masks):
        return (observations @ self.weights - 1e9 * (masks == 0)).argmax(axis=1)

    def record(self, first):
        data.record(self.envs, self.policy, PART, self.folder, first=first)
        return f"{first} {ray.get_runtime_context().get_node_id()} {os.getpid()}"


if __name__ == "__main__":
    folder, episodes = os.path.abspath(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 200
    ray.init(log_to_driver=False)
    count = int(ray.cluster_resources()["CPU"])
    actors = ActorPool([Recorder.remote(folder) for _ in range(count)])
    parts = range(0, episodes, PART)
    for line in actors.map_unordered(lambda actor, first: actor.record.remote(first), parts):
        print(line, flush=True)
    print(f"{len(data.files(folder))} episodes")
