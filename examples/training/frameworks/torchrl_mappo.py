"""MAPPO of TorchRL on 2v1: pip install 'FILE[torch]'; python3 torchrl_mappo.py [BATCHES]"""
import sys

import torch
from tensordict.nn import TensorDictModule
from torchrl.collectors import Collector
from torchrl.modules import MLP, MaskedCategorical, MultiAgentMLP, ProbabilisticActor
from torchrl.objectives import ClipPPOLoss

from cls_gym import VectorEnv, policy
from cls_gym.adapters.torchrl import ClsEnv

env = ClsEnv(VectorEnv(
    "cls/HFO-2v1-v0", 32, features="ego", actions="skills", frame_skip=4, max_cycles=500,
    autoreset_mode="disabled", reward={"goal": 5, "advance": 0.05, "approach": 0.05}))
seen, choice = env.observation_spec, env.full_action_spec["agents", "action"]
agents, size = seen["agents", "observation"].shape[-2:]
network = MultiAgentMLP(size, choice.n, agents, centralized=False, share_params=True)
actor = ProbabilisticActor(
    TensorDictModule(network, [("agents", "observation")], [("agents", "logits")]),
    in_keys={"logits": ("agents", "logits"), "mask": ("agents", "action_mask")},
    out_keys=[("agents", "action")], distribution_class=MaskedCategorical, return_log_prob=True)
critic = TensorDictModule(  # a value for each agent of the world
    MLP(seen["state"].shape[-1], (agents, 1), num_cells=[64, 64]), ["state"], ["state_value"])
loss = ClipPPOLoss(actor, critic, entropy_coeff=0.01)
loss.set_keys(reward=("agents", "reward"), action=("agents", "action"), done="ends",
              terminated="falls", value="state_value", sample_log_prob=actor.log_prob_keys[0])
loss.make_value_estimator(gamma=0.99, lmbda=0.95)
adam = torch.optim.Adam(loss.parameters(), 1e-3)
for data in Collector(env, actor, frames_per_batch=3200,
                      total_frames=3200 * int((sys.argv + [60])[1])):
    for key, own in (("done", "ends"), ("terminated", "falls")):  # of agents, as rewards are
        data["next", own] = data["next", key].unsqueeze(-2).expand(*data.shape, agents, 1)
    with torch.no_grad():
        loss.value_estimator(data, params=loss.critic_network_params,
                             target_params=loss.target_critic_network_params)
    for some in torch.randperm(3200).repeat(4).split(800):
        losses = loss(data.reshape(-1)[some]).items()
        sum(value for key, value in losses if key.startswith("loss_")).backward()
        adam.step(), adam.zero_grad()
    last = data["next", "status"][data["next", "done"]]
    print(f"goals {(last == 1).float().mean():.2f} of {len(last)} episodes")
policy.from_torch(env.envs, network).save("torchrl.npz")
