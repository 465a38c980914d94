"""Vectorised environment for Stable-Baselines3, with all robots in one simulator.

>>> from stable_baselines3 import PPO
>>> from robonewbie.sb3 import VecEnv
>>> PPO("MlpPolicy", VecEnv("RoboNewbie/Walk-v1", 128), n_steps=64, batch_size=512).learn(2_000_000)
"""

from __future__ import annotations

import importlib
import time
from typing import Any

import gymnasium
import numpy as np
from stable_baselines3.common.vec_env import VecEnv as _VecEnv

from robonewbie.environment import EpisodeSeeds, VectorizedTask
from robonewbie.picture import draw
from robonewbie.simulator import STEP, STEP_AND_RESET, TRUNCATED, RoboNewbieError


def _registered(name):
    """Returns the constructor's arguments and the time limit of a registered environment, which ``name`` may prefix with its module."""
    module, colon, environment = name.rpartition(":")
    if colon:
        importlib.import_module(module)
    spec = gymnasium.spec(environment)
    if "task" not in spec.kwargs:
        raise RoboNewbieError(f"{environment} is not a task of the simulator. Wrap it with make_vec_env of Stable-Baselines3.")
    return dict(spec.kwargs), spec.max_episode_steps


class SharedVecEnv(_VecEnv):
    """Base class of environments whose robots share one object."""

    def get_attr(self, attr_name, indices=None):
        return [getattr(self, attr_name)] * len(list(self._get_indices(indices)))

    def set_attr(self, attr_name, value, indices=None):
        self._check_all(indices)
        setattr(self, attr_name, value)

    def env_method(self, method_name, *method_args, indices=None, **method_kwargs):
        """Calls a method of this class once, for all robots, and returns its result for each of them."""
        self._check_all(indices)
        return [getattr(self, method_name)(*method_args, **method_kwargs)] * self.num_envs

    def _check_all(self, indices):
        if set(self._get_indices(indices)) != set(range(self.num_envs)):
            raise RoboNewbieError("The robots share their attributes and methods. Omit the argument indices.")

    def env_is_wrapped(self, wrapper_class, indices=None):
        return [False] * len(list(self._get_indices(indices)))


class VecEnv(SharedVecEnv, VectorizedTask):
    """Robots in separate worlds.

    ``task`` is the name of a task or the id of a registered environment. ``reward`` and ``options`` are those of ``RoboNewbieEnv``. When an
    episode ends, ``infos`` contains its return and length under ``episode``, as from ``Monitor``.
    """

    def __init__(
        self,
        task: str = "Walk",
        num_envs: int = 8,
        reward: str = "",
        render_mode: str | None = None,
        max_episode_steps: int | None = None,
        **options: Any,
    ) -> None:
        if "/" in task:
            registered, limit = _registered(task)
            task = registered.pop("task")
            reward = reward or registered.pop("reward", "")
            options = {**registered, **options}
            max_episode_steps = max_episode_steps or limit
        space, action_space = self._connect(task, num_envs, reward, render_mode, options)
        longest = self.description["longestCycles"]
        self._max_steps = max_episode_steps or longest
        # The simulator resets finished episodes itself unless this class decides on their ends.
        self._two_requests = self._customised or self._max_steps < longest
        self._episodes = EpisodeSeeds(num_envs)
        self._returns = np.zeros(num_envs)
        self._steps = np.zeros(num_envs, dtype=int)
        self._began = time.perf_counter()
        super().__init__(num_envs, space, action_space)
        self._set_cycles(options)  # the base class has replaced the metadata

    @property
    def _space_of_one_robot(self):
        return self.observation_space

    def set_options(self, options: list[dict] | dict | None = None) -> None:
        """Sets options for all episodes that begin from now on, in addition to those of the constructor.

        :raises RoboNewbieError: if a list has different options for different robots
        """
        if isinstance(options, (list, tuple)):
            if any(other != options[0] for other in options):
                raise RoboNewbieError("All robots have the same options. Pass a dictionary, with pairs such as (0.5, 2) for ranges.")
            options = options[0] if options else None
        self._change(options)

    def reset(self) -> np.ndarray:
        self._episodes.begin(self._seeds)
        self._reset_seeds()
        every = np.ones(self.num_envs, dtype=bool)
        observation = self._reset_episodes(every, self._episodes.draw(every))
        self._next = self._episodes.draw(every)
        self._returns[:] = 0
        self._steps[:] = 0
        self.reset_infos = self._connection.infos()
        return observation

    def step_async(self, actions):
        self._actions = actions

    def step_wait(self):
        seeds = self._next
        what = STEP if self._two_requests else STEP_AND_RESET
        observation, reward, terminated = self._connection.act(what, seeds, self._actions)
        truncated = self._connection.state == TRUNCATED
        infos = self._connection.infos()
        self._steps += 1
        if self._two_requests:
            truth = self._true_state()
            observation = self._observed(observation)
            reward = np.asarray(self.reward(reward, truth))
            terminated = np.asarray(self.termination(terminated, truth), dtype=bool)
            truncated |= self._steps >= self._max_steps
        self._returns += reward
        done = terminated | truncated
        if done.any():
            for i in np.flatnonzero(done):
                infos[i]["terminal_observation"] = observation[i].copy()
                infos[i]["TimeLimit.truncated"] = bool(not terminated[i])
                infos[i]["episode"] = self._statistics(i)
            if self._two_requests:
                observation = np.where(done[:, None], self._reset_episodes(done, seeds), observation)
            else:
                observation[done] = self._connection.fresh
            self._next = np.where(done, self._episodes.draw(done), seeds)
            self._returns[done] = 0
            self._steps[done] = 0
        return observation, reward.astype(np.float32), done, infos

    def _statistics(self, i):
        seconds = round(time.perf_counter() - self._began, 6)
        return {"r": float(self._returns[i]), "l": int(self._steps[i]), "t": seconds}

    def close(self):
        self._connection.close()

    def get_images(self):
        return [draw(self._connection.picture(i)) for i in range(self.num_envs)]
