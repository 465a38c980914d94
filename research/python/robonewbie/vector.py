"""Parallel environments with the interface of gymnasium.vector.VectorEnv. The simulator steps them on all cores."""

import gymnasium
import numpy as np
from gymnasium.vector.utils import batch_space

from robonewbie.environment import RENDER_MODES, EpisodeSeeds, SimulatedTask
from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP, TRUNCATED


class RoboNewbieVectorEnv(gymnasium.vector.VectorEnv, SimulatedTask):
    """Robots in separate worlds. The step after the end of an episode begins a new one and ignores the action (next-step autoreset)."""

    metadata = {"render_modes": RENDER_MODES, "render_fps": 50, "autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}

    def __init__(self, task="Walk", num_envs=1, max_episode_steps=None, reward="", render_mode=None, **options):
        self.num_envs = num_envs
        self.single_observation_space, self.single_action_space = self._connect(task, num_envs, reward, render_mode, options)
        self._max_steps = max_episode_steps or self.description["longestCycles"]
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._episodes = EpisodeSeeds(num_envs)
        self._steps = np.zeros(num_envs, dtype=int)
        self._done = np.ones(num_envs, dtype=bool)

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            self._episodes.begin([seed + i for i in range(self.num_envs)] if np.isscalar(seed) else seed)
        self._change(options)
        self._done[:] = True
        observation, _, _ = self._connection.act(RESET, self._episodes.draw(self._done), 0)
        self._steps[:] = 0
        self._done[:] = False
        return observation, self._info()

    def step(self, actions):
        fresh = self._done.copy()
        observation, reward, terminated = self._connection.act(
            np.where(fresh, RESET, STEP), self._episodes.draw(fresh), actions
        )
        reward[fresh] = 0
        terminated[fresh] = False
        self._steps = np.where(fresh, 0, self._steps + 1)
        truncated = ((self._steps >= self._max_steps) | (self._connection.state == TRUNCATED)) & ~terminated
        self._done = terminated | truncated
        return observation, reward, terminated, truncated, self._info()

    def _info(self):
        info = {}
        for name, values in zip(self._connection.truth_names, self._connection.truth.T):
            info[name] = values.astype(bool) if name in ("fallen", "is_success") else values
            info["_" + name] = np.ones(self.num_envs, dtype=bool)
        return info

    def render(self):
        """Returns an image of each robot if ``render_mode`` is ``"rgb_array"``."""
        if self.render_mode != "rgb_array":
            return None
        return tuple(draw(self._connection.picture(i)) for i in range(self.num_envs))

    def close_extras(self, **kwargs):
        self._connection.close()
