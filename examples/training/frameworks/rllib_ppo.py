"""PPO of RLlib: both attackers of 2v1 share a policy with action masks.

    pip install 'FILE[rllib]'; python3 rllib_ppo.py [ITERATIONS, default 20]
"""
import sys

from ray.rllib.algorithms.ppo import PPOConfig
from ray.rllib.core.rl_module.multi_rl_module import MultiRLModuleSpec
from ray.rllib.core.rl_module.rl_module import RLModuleSpec

from cls_gym.adapters.rllib import ClsMultiAgentEnv, MaskedModule
from cls_gym.policy import from_torch

task = {"task": "cls/HFO-2v1-v0", "features": "ego", "actions": "skills", "mask": "observation",
        "frame_skip": 4, "max_cycles": 500,
        "reward": {"goal": 5, "advance": 0.05, "approach": 0.05}}
config = (
    PPOConfig()
    .environment(ClsMultiAgentEnv, env_config=task)
    .env_runners(num_env_runners=0, num_envs_per_env_runner=8)
    .multi_agent(policies={"shared"}, policy_mapping_fn=lambda agent, episode, **_: "shared")
    .rl_module(rl_module_spec=MultiRLModuleSpec(
        rl_module_specs={"shared": RLModuleSpec(module_class=MaskedModule)}))
    .training(train_batch_size_per_learner=4000, minibatch_size=500, num_epochs=6, lr=5e-4,
              gamma=0.99, entropy_coeff=0.01)
    .debugging(seed=1))
algorithm = config.build_algo()
for number in range(int(sys.argv[1]) if len(sys.argv) > 1 else 20):
    result = algorithm.train()["env_runners"]
    print(f"{number + 1:3d}  reward {result.get('episode_return_mean', float('nan')):6.2f}  "
          f"cycles {result.get('episode_len_mean', float('nan')) * 4:5.0f}")
module = algorithm.get_module("shared")
from_torch(ClsMultiAgentEnv(task).env, module.encoder.actor_encoder, module.pi).save("rllib.npz")
print(algorithm.save_to_path())
