"""Training of the T1's walk by PPO."""

import csv
import os
import time

import numpy as np
import torch
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback

from ..symmetry import SymmetricPolicy
from . import environment, mirror, robot
from .environment import WalkingRobots
from .policy import policy_text

SEEDS_APART = 10_000_000
EASY_ACTIONS = 1_500_000  # until all that varies does so fully


class Training:
    """Training run. The checkpoint (.zip) and the learning curve (.csv) are written beside the policy.

    :param out: path of the policy
    :param total: total number of actions of all robots
    """

    COLUMNS = ("actions", "reward", "seconds", "fallen", "deviation", "processor_seconds")

    def __init__(self, out, total, robots=128, seed=1, resume=False, learning_rate=3e-4, variation=environment.Variation()):
        torch.set_num_threads(1)
        self.out, self.total, self.learning_rate, self._seed, self._robots = out, total, learning_rate, seed, robots
        self._variation = variation
        model = PPO.load(self._beside(".zip"), device="cpu") if resume else None
        # The seed alone would repeat the first episodes.
        self._world = WalkingRobots(robots, SEEDS_APART * seed + (model.num_timesteps if resume else 0), variation)
        if resume:
            self.model = model
            self.model.set_env(self._world)
        else:
            self.model = PPO(SymmetricPolicy, self._world, **settings(seed))

    def _beside(self, ending):
        return self.out.with_name(self.out.name + ending)

    def run(self):
        """Trains until the total number of actions is reached."""
        progress = Progress(self)
        while self.model.num_timesteps < self.total:
            rate = self.learning_rate * max(0.05, 1 - self.model.num_timesteps / self.total)
            self.model.lr_schedule = lambda _, rate=rate: rate
            self._world.variation = self._variation.eased(self.model.num_timesteps / EASY_ACTIONS)
            self.model.learn(10 * self._robots * self.model.n_steps, callback=progress, reset_num_timesteps=False)
            self._save()
            progress.report()

    def _save(self):
        part = self._beside(".zip.part")
        with open(part, "wb") as file:
            self.model.save(file)
        os.replace(part, self._beside(".zip"))
        self.out.write_text(self.text(), encoding="utf-8", newline="\n")

    def text(self):
        """Returns the policy in its file format."""
        command = f"python -m robonewbie.t1 train --total-timesteps {self.total} --n-envs {self._robots} --seed {self._seed}"
        return policy_text(self.model, [f"learned by: {command}", f"after {self.model.num_timesteps} actions"])

    def add_to_curve(self, row):
        """Appends a row to the learning curve."""
        curve = self._beside(".csv")
        new = not curve.exists()
        with open(curve, "a", newline="", encoding="utf-8") as file:
            lines = csv.writer(file, lineterminator="\n")
            lines.writerows([self.COLUMNS, row] if new else [row])


def settings(seed):
    """Returns the parameters of PPO, which are the defaults of Stable-Baselines3 where none are given."""
    actor = list(range(environment.INPUTS))
    return {
        "n_steps": 64,
        "batch_size": 512,
        "seed": seed,
        "device": "cpu",
        "policy_kwargs": {
            "actor": actor,
            "mirrors": (mirror.mirror_of_inputs(), mirror.mirror_of_action()),
            "critic": list(range(environment.INPUTS + environment.PRIVILEGED)),
            "net_arch": {"pi": [48, 48], "vf": [128, 64]},
            "log_std_init": -1.4,
        },
    }


class Progress(BaseCallback):
    """Collects the episodes since the last report."""

    def __init__(self, training):
        super().__init__()
        self._training = training
        self._first = training.model.num_timesteps
        self._began = time.monotonic(), time.process_time()
        self._episodes = []

    def _on_step(self):
        self._episodes += [info["episode"] for info in self.locals["infos"] if "episode" in info]
        return True

    def report(self):
        """Prints a line and adds it to the learning curve."""
        episodes, self._episodes = self._episodes, []
        if not episodes:
            return
        actions = self.model.num_timesteps
        wall, processor = time.monotonic() - self._began[0], time.process_time() - self._began[1]
        reward, length, fallen = (np.mean([episode[name] for episode in episodes]) for name in ("r", "l", "fallen"))
        seconds, deviation = length * robot.ACTION_SECONDS, float(self.model.policy.log_std.detach().exp().mean())
        self._training.add_to_curve([actions, f"{reward:.2f}", f"{seconds:.2f}", f"{fallen:.3f}", f"{deviation:.3f}", f"{processor:.0f}"])
        left = max(0, self._training.total - actions) * wall / (actions - self._first) / 60
        print(
            f"{actions:9d} actions: reward {reward:6.2f} in {seconds:5.2f} s, {fallen:4.0%} fell, deviation {deviation:.3f}; "
            f"{processor:.0f} s of processor time, {left:.0f} min left",
            flush=True,
        )
