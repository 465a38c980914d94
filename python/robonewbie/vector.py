"""Many robots at once with the interface of gymnasium.vector.VectorEnv; the simulator uses all cores."""

import gymnasium
import numpy as np
from gymnasium.vector.utils import batch_space

from robonewbie.environment import _SEEDS, spaces_of
from robonewbie.simulator import RESET, STEP, Connection


class RoboNewbieVectorEnv(gymnasium.vector.VectorEnv):
    """Robots in worlds of their own. An episode that is over begins anew in the next step, whose action does not count."""

    metadata = {"render_modes": [], "autoreset_mode": gymnasium.vector.AutoresetMode.NEXT_STEP}

    def __init__(self, task="Walk", num_envs=1, max_episode_steps=None, reward="", render_mode=None):
        if render_mode is not None:
            raise ValueError(f"There is no render_mode \"{render_mode}\"; leave it out.")
        self.render_mode = None
        self.num_envs = num_envs
        self._connection = Connection(task, num_envs, reward)
        description = self._connection.description
        self._longest = max_episode_steps or description["longestCycles"]
        self.single_observation_space, self.single_action_space = spaces_of(description)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_names = [entry["name"] for entry in description["observation"]]
        self._randoms = [np.random.default_rng() for _ in range(num_envs)]
        self._steps = np.zeros(num_envs, dtype=int)
        self._done = np.ones(num_envs, dtype=bool)

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            seeds = [seed + i for i in range(self.num_envs)] if np.isscalar(seed) else seed
            for i, own in enumerate(seeds):
                if own is not None:
                    self._randoms[i] = np.random.default_rng(own)
        observation, _, _ = self._connection.act(RESET, self._episodes(), 0)
        self._steps[:] = 0
        self._done[:] = False
        return observation, {}

    def step(self, actions):
        fresh = self._done.copy()
        observation, reward, over = self._connection.act(
            np.where(fresh, RESET, STEP), np.where(fresh, self._episodes(fresh), 0), actions
        )
        reward[fresh] = 0
        over[fresh] = False
        self._steps = np.where(fresh, 0, self._steps + 1)
        truncated = (self._steps >= self._longest) & ~over
        self._done = over | truncated
        return observation, reward, over, truncated, {}

    def _episodes(self, which=None):
        wanted = np.ones(self.num_envs, dtype=bool) if which is None else which
        return np.array([r.integers(_SEEDS) if w else 0 for r, w in zip(self._randoms, wanted)], dtype=np.int64)

    def close_extras(self, **kwargs):
        self._connection.close()
