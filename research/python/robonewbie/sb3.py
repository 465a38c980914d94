"""Vectorised environment for Stable-Baselines3, with all robots in one simulator.

>>> from stable_baselines3 import PPO
>>> from robonewbie.sb3 import VecEnv
>>> PPO("MlpPolicy", VecEnv("Walk", 16)).learn(100_000)
"""

import numpy as np
from stable_baselines3.common.vec_env import VecEnv as _VecEnv

from robonewbie.environment import EpisodeSeeds, SimulatedTask
from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP_AND_RESET


class VecEnv(_VecEnv, SimulatedTask):
    """Robots in separate worlds. ``reward`` and ``options`` are those of ``RoboNewbieEnv``."""

    def __init__(self, task="Walk", num_envs=8, reward="", render_mode=None, **options):
        observation_space, action_space = self._connect(task, num_envs, reward, render_mode, options)
        self._episodes = EpisodeSeeds(num_envs)
        super().__init__(num_envs, observation_space, action_space)

    def reset(self):
        self._episodes.begin(self._seeds)
        self._reset_seeds()
        self._reset_options()
        every = np.ones(self.num_envs, dtype=bool)
        observation, _, _ = self._connection.act(RESET, self._episodes.draw(every), 0)
        self._next = self._episodes.draw(every)
        self.reset_infos = self._infos()
        return observation

    def step_async(self, actions):
        self._actions = actions

    def step_wait(self):
        seeds = self._next
        observation, reward, terminated = self._connection.act(STEP_AND_RESET, seeds, self._actions)
        infos = self._infos()
        done = self._connection.state > 0
        if done.any():
            for i in np.flatnonzero(done):
                infos[i]["terminal_observation"] = observation[i].copy()
                infos[i]["TimeLimit.truncated"] = bool(not terminated[i])
            observation[done] = self._connection.fresh
            self._next = np.where(done, self._episodes.draw(done), seeds)
        return observation, reward.astype(np.float32), done, infos

    def _infos(self):
        names = self._connection.truth_names
        return [dict(zip(names, row)) for row in self._connection.truth.tolist()]

    def close(self):
        self._connection.close()

    def get_images(self):
        return [draw(self._connection.picture(i)) for i in range(self.num_envs)]

    def get_attr(self, attr_name, indices=None):
        return [getattr(self, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name, value, indices=None):
        setattr(self, attr_name, value)

    def env_method(self, method_name, *method_args, indices=None, **method_kwargs):
        raise AttributeError(f"The robots of this environment have no method {method_name}.")

    def env_is_wrapped(self, wrapper_class, indices=None):
        return [False] * len(list(self._get_indices(indices)))
