"""Parallel environments with the interface of gymnasium.vector.VectorEnv. The simulator steps them on all cores."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium.vector import AutoresetMode
from gymnasium.vector.utils import batch_space

from robonewbie.environment import CYCLES_PER_SECOND, RENDER_MODES, EpisodeSeeds, VectorizedTask
from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP, TRUNCATED


class RoboNewbieVectorEnv(gymnasium.vector.VectorEnv, VectorizedTask):
    """Robots in separate worlds.

    By default, the step after the end of an episode begins a new one and ignores the action. With
    ``autoreset_mode=AutoresetMode.SAME_STEP``, the step that ends an episode returns the first observation of the next one, and ``info``
    contains ``final_obs`` and ``final_info``.

    To customise a task, override ``observation``, ``reward`` and ``termination``, which work on arrays:

    >>> class Crouch(RoboNewbieVectorEnv):
    ...     def reward(self, reward, info):
    ...         return -info["height"]
    """

    metadata = {"render_modes": RENDER_MODES, "render_fps": CYCLES_PER_SECOND, "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(
        self,
        task: str = "Walk",
        num_envs: int = 1,
        max_episode_steps: int | None = None,
        reward: str = "",
        render_mode: str | None = None,
        autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP,
        **options: Any,
    ) -> None:
        mode = AutoresetMode(autoreset_mode)
        if mode is AutoresetMode.DISABLED:
            raise ValueError("autoreset_mode DISABLED is not available. Choose NEXT_STEP or SAME_STEP.")
        self.num_envs = num_envs
        self.single_observation_space, self.single_action_space = self._connect(task, num_envs, reward, render_mode, options)
        self.metadata = {**self.metadata, "autoreset_mode": mode}
        self._same_step = mode is AutoresetMode.SAME_STEP
        self._max_steps = max_episode_steps or self.description["longestCycles"]
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._episodes = EpisodeSeeds(num_envs)
        self._steps = np.zeros(num_envs, dtype=int)
        self._done = np.ones(num_envs, dtype=bool)

    @property
    def single_observation_space(self):
        """The observation space of one robot; setting it sets ``observation_space`` as well."""
        return self._space_of_one_robot

    @single_observation_space.setter
    def single_observation_space(self, space):
        self._space_of_one_robot = space
        self.observation_space = batch_space(space, self.num_envs)

    def reset(
        self, *, seed: int | list[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[np.ndarray, dict[str, Any]]:
        if seed is not None:
            self._episodes.begin([seed + i for i in range(self.num_envs)] if np.isscalar(seed) else seed)
        self._change(options)
        self._done[:] = True
        observation = self._reset_episodes(self._done, self._episodes.draw(self._done))
        self._steps[:] = 0
        self._done[:] = False
        return observation, self._info()

    def step(self, actions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, dict[str, Any]]:
        fresh = self._done.copy()
        observation, reward, terminated = self._connection.act(
            np.where(fresh, RESET, STEP), self._episodes.draw(fresh), actions
        )
        truth = self._true_state()
        observation = self._observed(observation)
        reward = np.where(fresh, 0, self.reward(reward, truth))
        terminated = np.asarray(self.termination(terminated, truth), dtype=bool) & ~fresh
        self._steps = np.where(fresh, 0, self._steps + 1)
        truncated = ((self._steps >= self._max_steps) | (self._connection.state == TRUNCATED)) & ~terminated & ~fresh
        done = terminated | truncated
        info = self._info()
        if self._same_step and done.any():
            observation, info = self._begin_again(done, observation, info)
        else:
            self._done = done
        return observation, reward, terminated, truncated, info

    def _begin_again(self, done, observation, last):
        """Resets finished episodes; returns the observations and infos of all robots."""
        final = np.full(self.num_envs, None, dtype=object)
        for i in np.flatnonzero(done):
            final[i] = np.copy(observation[i])
        ended = {name: done.copy() if name.startswith("_") else values for name, values in last.items()}
        observation = self._reset_episodes(done, self._episodes.draw(done))
        self._steps[done] = 0
        info = {**self._info(), "final_obs": final, "_final_obs": done.copy(), "final_info": ended, "_final_info": done.copy()}
        return observation, info

    def _info(self):
        info = {}
        for name, values in self._true_state().items():
            info[name] = values
            info["_" + name] = np.ones(self.num_envs, dtype=bool)
        return info

    def render(self) -> tuple[np.ndarray, ...] | None:
        """Returns an image of each robot if ``render_mode`` is ``"rgb_array"``."""
        if self.render_mode != "rgb_array":
            return None
        return tuple(draw(self._connection.picture(i)) for i in range(self.num_envs))

    def close_extras(self, **kwargs):
        self._connection.close()
