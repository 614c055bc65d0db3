"""MAPPO of skrl on 2v1: pip install 'FILE[torch]' skrl; python3 skrl_mappo.py STEPS"""
import sys

from skrl.memories.torch import RandomMemory
from skrl.models.torch import CategoricalMixin, DeterministicMixin, Model
from skrl.multi_agents.torch.mappo import MAPPO, MAPPO_CFG
from skrl.trainers.torch import SequentialTrainer
from torch import nn

import cls_gym
from cls_gym.adapters.skrl import ClsMultiAgent


def model(kind, sizes, compute, spaces):
    def __init__(self):
        Model.__init__(self, **spaces)
        kind.__init__(self)
        self.net = nn.Sequential(nn.Linear(sizes[0], 64), nn.Tanh(), nn.Linear(64, sizes[1]))
    return type("Net", (kind, Model), {"__init__": __init__, "compute": compute})()


def policy(self, inputs, role=""):
    none = inputs["observations"][:, -self.num_actions:] == 0
    return self.net(inputs["observations"]).masked_fill(none, -1e9), {}


def value(self, inputs, role=""):
    return self.net(inputs["states"]), {}


env = ClsMultiAgent(cls_gym.VectorEnv(
    "cls/HFO-2v1-v0", 32, features="ego", actions="skills", mask="appended", frame_skip=4,
    autoreset_mode="same_step", reward={"goal": 5, "advance": 0.05, "approach": 0.05}))
kinds = ("observation", "state", "action")
spaces = {f"{kind}_space": getattr(env, f"{kind}_space")(env.agents[0]) for kind in kinds}
seen, state, ids = (int(space.shape[0]) if space.shape else space.n for space in spaces.values())
models = {one: {"policy": model(CategoricalMixin, (seen, ids), policy, spaces),
                "value": model(DeterministicMixin, (state, 1), value, spaces)}
          for one in env.agents}
cfg = MAPPO_CFG(rollouts=64, **{f"{name}_kwargs": {one: {} for one in env.agents} for name in (
    "learning_rate_scheduler", *(f"{kind}_preprocessor" for kind in (*kinds[:2], "value")))})
learner = MAPPO(possible_agents=env.agents, models=models, cfg=cfg,
                memories={one: RandomMemory(memory_size=64, num_envs=32) for one in env.agents},
                **{f"{kind}_spaces": getattr(env, f"{kind}_spaces") for kind in kinds})
SequentialTrainer(env=env, agents=learner, cfg={"timesteps": int(sys.argv[1])}).train()
