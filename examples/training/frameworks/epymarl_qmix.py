"""QMIX or MAPPO of EPyMARL on 2v1, from a clone of the repository uoe-agents/epymarl of GitHub.

    pip install 'FILE[torch]' pyyaml; python3 epymarl_qmix.py epymarl/src [qmix|mappo]
"""
import logging
import pathlib
import sys
import types

import torch
import yaml

from cls_gym.adapters.smac import SmacEnv

source = pathlib.Path(sys.argv[1])
name = sys.argv[2] if len(sys.argv) > 2 else "qmix"
steps = int(sys.argv[3]) if len(sys.argv) > 3 else 200_000
sys.path.insert(0, str(source))
# The package of StarCraft that it imports first is not needed.
sys.modules.setdefault("smaclite", types.ModuleType("smaclite"))
sys.modules["envs.smaclite_wrapper"] = types.SimpleNamespace(SMACliteWrapper=None)

import envs  # noqa: E402
import run  # noqa: E402
from utils.logging import Logger  # noqa: E402

envs.REGISTRY["cls"] = SmacEnv
config = {"seed": 1}
for file in ("default", f"algs/{name}"):
    config.update(yaml.safe_load((source / f"config/{file}.yaml").read_text()))
config.update(env="cls", t_max=steps, use_cuda=False, unique_token=name, device="cpu",
              reward_scalarisation="mean", env_args={
                  "task": "cls/HFO-2v1-v0", "seed": 1, "features": "ego", "actions": "skills",
                  "frame_skip": 4, "max_cycles": 500,
                  "reward": {"goal": 5, "advance": 0.05, "approach": 0.05}})
logging.basicConfig(level=logging.INFO, format="%(message)s")
torch.manual_seed(1)
run.run_sequential(types.SimpleNamespace(**config), Logger(logging.getLogger()))
