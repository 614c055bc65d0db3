"""MAPPO, IPPO or QMIX of BenchMARL on 2v1.

    pip install 'FILE[torch]' benchmarl; python3 benchmarl_mappo.py [mappo|ippo|qmix] [ITERATIONS]
"""
import sys

from benchmarl.algorithms import IppoConfig, MappoConfig, QmixConfig
from benchmarl.experiment import Experiment, ExperimentConfig
from benchmarl.models.mlp import MlpConfig

from cls_gym.adapters.benchmarl import ClsTask

name = sys.argv[1] if len(sys.argv) > 1 else "mappo"
algorithms = {"mappo": MappoConfig, "ippo": IppoConfig, "qmix": QmixConfig}

config = ExperimentConfig.get_from_yaml()
config.max_n_iters = int(sys.argv[2]) if len(sys.argv) > 2 else 40
config.max_n_frames = None
config.on_policy_n_envs_per_worker = config.off_policy_n_envs_per_worker = 32
config.on_policy_collected_frames_per_batch = config.off_policy_collected_frames_per_batch = 3200
config.on_policy_minibatch_size, config.off_policy_train_batch_size = 800, 512
config.on_policy_n_minibatch_iters, config.off_policy_n_optimizer_steps = 8, 50
config.evaluation, config.render, config.loggers, config.create_json = False, False, [], False

task = ClsTask("cls/HFO-2v1-v0", {
    "features": "ego", "actions": "skills", "frame_skip": 4, "max_cycles": 500,
    "reward": {"goal": 5, "advance": 0.05, "approach": 0.05}})
experiment = Experiment(task=task, algorithm_config=algorithms[name].get_from_yaml(),
                        model_config=MlpConfig.get_from_yaml(),
                        critic_model_config=MlpConfig.get_from_yaml(), seed=1, config=config)
experiment.run()
print(f"mean return {experiment.mean_return:.2f} of the last batch")
