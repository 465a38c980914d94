"""One robot with the interface of gymnasium.Env."""

import sys
import webbrowser

import gymnasium
import numpy as np

from robonewbie.picture import draw
from robonewbie.simulator import RESET, STEP, TRUNCATED, Connection, RoboNewbieError

_SEEDS = 2**62
RENDER_MODES = ["human", "rgb_array"]


class EpisodeSeeds:
    """Draws the seeds of episodes, for each of several robots from a chance of its own."""

    def __init__(self, robots):
        self._randoms = [np.random.default_rng() for _ in range(robots)]

    def begin(self, seeds):
        """Seeds each chance; ``None`` lets one go on."""
        for i, seed in enumerate(seeds):
            if seed is not None:
                self._randoms[i] = np.random.default_rng(seed)

    def draw(self, wanted):
        """Returns a seed for each robot that is wanted, 0 for the others."""
        return np.array([r.integers(_SEEDS) if w else 0 for r, w in zip(self._randoms, wanted)], dtype=np.int64)


def spaces_of(description):
    """Makes the spaces of observation and action from what the simulator tells."""
    low = np.array([entry["least"] for entry in description["observation"]], dtype=np.float32)
    high = np.array([entry["greatest"] for entry in description["observation"]], dtype=np.float32)
    observation = gymnasium.spaces.Box(low, high, dtype=np.float32)
    action = gymnasium.spaces.Box(-1.0, 1.0, (len(description["action"]),), dtype=np.float32)
    return observation, action


def checked_render_mode(mode):
    """Refuses a way to render that does not exist."""
    if mode is not None and mode not in RENDER_MODES:
        raise ValueError(f'There is no render_mode "{mode}". There are: {", ".join(RENDER_MODES)}, or leave it out.')
    return mode


def show(connection):
    """Opens the studio in the browser with the first environment of a connection; returns the address of its page."""
    address, file = connection.show(0)
    print(f"Studio: {address}", file=sys.stderr)
    webbrowser.open(file)  # every user of the computer can read the browser's command line, so that it holds no code
    return address


class RoboNewbieEnv(gymnasium.Env):
    """A task for one robot; one step is a cycle of 20 ms.

    ``observation_names``, ``observation_units`` and ``action_names`` say what the numbers are. An action is, for each joint,
    the angle to go to: -1 to 1 times ``range_degrees`` from the first posture.

    ``reward`` is the name of a measure such as ``"energy"``; without it the task decides what it pays. ``options`` change the
    episodes: ``x``, ``y`` (metres), ``heading`` (degrees), ``ball_x``, ``ball_y``, ``push`` (newtons by which pushes once per
    second get harder), ``delay`` (cycles until an action acts), ``cycles`` (how many an action lasts, 1), ``noise`` (standard deviation of errors on top of joint angles,
    gyro and accelerometer), ``friction`` and ``mass`` (1 is the usual), and for ``Follow`` and its like
    ``forward``, ``left`` (m/s) and ``turn`` (degrees/s). Each is a number, or a pair (low, high) from which each
    episode draws its own. ``reset(options={...})`` changes the episode that begins.

    ``render_mode="human"`` opens the studio, where the robot moves in real time; its page can stop the clock.

    ``info`` is the true state. For a task of your own, override ``observation``, ``reward`` and ``termination``:

    >>> class Crouch(RoboNewbieEnv):
    ...     def reward(self, reward, info):
    ...         return -info["height"]
    """

    metadata = {"render_modes": RENDER_MODES, "render_fps": 50}

    def __init__(self, task="Walk", reward="", render_mode=None, **options):
        self.render_mode = checked_render_mode(render_mode)
        self._made_of = {"task": task, "reward": reward, "render_mode": render_mode, **options}
        self._options = options
        self._changed = False
        self._connection = Connection(task, 1, reward, options)
        description = self._connection.description
        if len(description["robots"]) > 1:
            raise RoboNewbieError(f"In {task} several robots learn. Use robonewbie.parallel.parallel_env(\"{task}\").")
        self.observation_space, self.action_space = spaces_of(description)
        self.observation_names = [entry["name"] for entry in description["observation"]]
        self.observation_units = [entry["unit"] for entry in description["observation"]]
        self.action_names = description["action"]
        self.range_degrees = description["rangeDegrees"]
        self.cycles = options.get("cycles", 1)
        self.studio_address = show(self._connection) if render_mode == "human" else None

    def observation(self, observation, info):
        """Returns the observation of a step; a subclass may derive it from what the robot senses or from the true state."""
        return observation

    def reward(self, reward, info):
        """Returns the reward of a step; a subclass may replace that of the task."""
        return reward

    def termination(self, terminated, info):
        """Returns whether the episode is terminated; a subclass may decide otherwise than the task."""
        return terminated

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        if options or self._changed:
            self._connection.change({**self._options, **(options or {})})
            self._changed = bool(options)
        episode = int(self.np_random.integers(_SEEDS))
        observation, _, _ = self._connection.act(RESET, episode, 0)
        info = self._info()
        return self.observation(observation[0], info), info

    def step(self, action):
        action = np.asarray(action, dtype=float)
        if action.shape != self.action_space.shape:
            raise RoboNewbieError(
                f"The action has the shape {action.shape} instead of {self.action_space.shape}: one number for each of "
                f"{', '.join(self.action_names)}."
            )
        observation, reward, terminated = self._connection.act(STEP, 0, action)
        info = self._info()
        return (
            self.observation(observation[0], info),
            float(self.reward(float(reward[0]), info)),
            bool(self.termination(bool(terminated[0]), info)),
            bool(self._connection.state[0] == TRUNCATED),
            info,
        )

    def _info(self):
        info = {name: float(value) for name, value in zip(self._connection.truth_names, self._connection.truth[0])}
        for name in ("fallen", "is_success"):
            info[name] = bool(info[name])
        return info

    def render(self):
        """Returns a picture as an array of 360 x 480 x 3 bytes if ``render_mode`` is ``"rgb_array"``."""
        return draw(self._connection.picture(0)) if self.render_mode == "rgb_array" else None

    def close(self):
        self._connection.close()

    def __getstate__(self):
        """A pickled environment is made again by the process that reads it."""
        return self._made_of

    def __setstate__(self, made_of):
        self.__init__(**made_of)
