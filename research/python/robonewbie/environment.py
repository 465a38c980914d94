"""Environment for one robot with the interface of gymnasium.Env, and the base class of all environments."""

from __future__ import annotations

import sys
import webbrowser
from typing import Any

import gymnasium
import numpy as np

from robonewbie.mirror import mirror_of
from robonewbie.picture import draw
from robonewbie.simulator import RESET, SKIP, STEP, TRUNCATED, Connection, RoboNewbieError

SEED_LIMIT = 2**62
RENDER_MODES = ["human", "rgb_array"]
CYCLES_PER_SECOND = 50


class EpisodeSeeds:
    """Generates the seeds of episodes, with a separate random generator for each environment."""

    def __init__(self, count):
        self._generators = [np.random.default_rng() for _ in range(count)]

    def begin(self, seeds):
        """Seeds the generators; ``None`` leaves a generator unchanged."""
        for i, seed in enumerate(seeds):
            if seed is not None:
                self._generators[i] = np.random.default_rng(seed)

    def draw(self, needed):
        """Returns a seed for each environment that a boolean mask selects, and 0 for all others."""
        return np.array([g.integers(SEED_LIMIT) if n else 0 for g, n in zip(self._generators, needed)], dtype=np.int64)


def spaces_of(description):
    """Creates the observation and action spaces from the description of a task."""
    low = np.array([entry["least"] for entry in description["observation"]], dtype=np.float32)
    high = np.array([entry["greatest"] for entry in description["observation"]], dtype=np.float32)
    observation = gymnasium.spaces.Box(low, high, dtype=np.float32)
    limit = description["actionLimit"]
    action = gymnasium.spaces.Box(-limit, limit, (len(description["action"]),), dtype=np.float32)
    return observation, action


def _create(kind, arguments, keywords):
    return kind(*arguments, **keywords)


class SimulatedTask:
    """Base class of all environments: connection to the simulator, episode options, rendering, and pickling.

    Unpickling calls the constructor of the environment's class with the same arguments.
    """

    metadata = {"render_modes": RENDER_MODES, "render_fps": CYCLES_PER_SECOND}

    def __new__(cls, *arguments, **keywords):
        environment = super().__new__(cls)
        environment._constructor = arguments, keywords
        return environment

    def __reduce__(self):
        return _create, (type(self), *self._constructor)

    _physics = None  # that of the simulator

    def _connect(self, task, count, reward, render_mode, options):
        if render_mode is not None and render_mode not in RENDER_MODES:
            raise ValueError(f'There is no render_mode "{render_mode}". Available: {", ".join(RENDER_MODES)}; or omit the argument.')
        self.render_mode = render_mode
        self._task_options = options
        self._changed = False
        self._connection = Connection(task, count, reward, options, self._physics)
        self.description = self._connection.description
        self.observation_names = [entry["name"] for entry in self.description["observation"]]
        self.observation_units = [entry["unit"] for entry in self.description["observation"]]
        self.action_names = self.description["action"]
        self.true_state_names = [entry["name"] for entry in self.description["trueState"]]
        self.true_state_units = [entry["unit"] for entry in self.description["trueState"]]
        self._set_cycles(options)
        self.studio_address = self._show() if render_mode == "human" else None
        return spaces_of(self.description)

    @property
    def observation_mirror(self) -> tuple[np.ndarray, np.ndarray]:
        """Indices and signs that exchange left and right: ``signs * observation[..., indices]`` is the mirrored observation.

        :raises RoboNewbieError: if the task is not symmetric
        """
        return self._mirror(self.observation_names)

    @property
    def action_mirror(self) -> tuple[np.ndarray, np.ndarray]:
        """Indices and signs of the mirrored action, as for ``observation_mirror``."""
        return self._mirror(self.action_names)

    def _mirror(self, names):
        if self.description["motion"]:
            raise RoboNewbieError("The task is not symmetric: its actions correct a motion.")
        if self.description["walk"]:  # quantities of swing leg and support leg are the same on both sides
            return np.arange(len(names)), np.ones(len(names), dtype=np.float32)
        return mirror_of(names)

    def _show(self):
        address, file = self._connection.show(0)
        print(f"Studio: {address}", file=sys.stderr)
        webbrowser.open(file)  # the file hides the access code from command lines, which all users of the computer can read
        return address

    def _change(self, options):
        """Sets options for the next episode, in addition to those of the constructor."""
        if options or self._changed:
            merged = {**self._task_options, **(options or {})}
            self._connection.change(merged)
            self._changed = bool(options)
            self._set_cycles(merged)

    def _set_cycles(self, options):
        self.cycles = int(options.get("cycles", self.description["cycles"]))
        self.metadata = {**self.metadata, "render_fps": CYCLES_PER_SECOND / self.cycles}

    def render(self) -> np.ndarray | None:
        """Returns an image as an array of 360 x 480 x 3 bytes if ``render_mode`` is ``"rgb_array"``."""
        return draw(self._connection.picture(0)) if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        self._connection.close()


def _in_shape(observation, space, robots=()):
    """Returns the observation, which has a row for each robot if ``robots`` contains their number.

    :raises RoboNewbieError: if its shape is not that of the space
    """
    if space.shape is not None and np.shape(observation) != (*robots, *space.shape):
        raise RoboNewbieError(
            f"observation() returned the shape {np.shape(observation)} instead of {(*robots, *space.shape)}. "
            "Set the observation space in the constructor, after super().__init__()."
        )
    return observation


class VectorizedTask(SimulatedTask):
    """Base class of vectorised environments, with hooks that work on arrays.

    Override ``observation``, ``reward`` and ``termination`` to customise a task. Their first argument has a row or a number for each
    robot; ``info`` has an array for each quantity of the true state. ``observation`` may be called twice in a step, the second time after
    finished episodes have been reset, so its result should depend on its arguments only.
    """

    def observation(self, observation: np.ndarray, info: dict[str, np.ndarray]) -> np.ndarray:
        """Returns the observations of all robots. If their shape differs from the task's, set the space in the constructor."""
        return observation

    def reward(self, reward: np.ndarray, info: dict[str, np.ndarray]) -> np.ndarray:
        """Returns the rewards of all robots."""
        return reward

    def termination(self, terminated: np.ndarray, info: dict[str, np.ndarray]) -> np.ndarray:
        """Returns whether the episode of each robot is terminated."""
        return terminated

    @property
    def _customised(self):
        hooks = ("observation", "reward", "termination")
        return any(getattr(type(self), hook) is not getattr(VectorizedTask, hook) for hook in hooks)

    def _true_state(self):
        truth = self._connection.truth
        state = {
            name: values.astype(bool) if name in ("fallen", "is_success") else values
            for name, values in zip(self._connection.truth_names, truth.T)
        }
        return {**state, "true_state": self._connection.true_state} if self.true_state_names else state

    def _reset_episodes(self, selected, seeds):
        """Begins an episode for each robot that a boolean mask selects; returns the observations of all robots."""
        observation, _, _ = self._connection.act(np.where(selected, RESET, SKIP), seeds, 0)
        return self._observed(observation)

    def _observed(self, observation):
        observation = self.observation(observation, self._true_state())
        return _in_shape(observation, self._space_of_one_robot, (self.num_envs,))


class RoboNewbieEnv(SimulatedTask, gymnasium.Env):
    """A task for one robot; a step is a cycle of 20 ms.

    ``observation_names``, ``observation_units`` and ``action_names`` describe the spaces. An action contains a target angle for each
    joint relative to the initial posture: the bound of the action space means ``range_degrees``, an array. With ``speeds=1``, it contains a fraction of each joint's highest
    speed. With ``history=3``, an observation contains those of the two actions before as well.

    ``reward`` is the name of a measure such as ``"energy"`` that replaces the reward of the task. ``options`` change the episodes:
    ``x``, ``y``, ``ball_x``, ``ball_y`` (metres), ``heading`` (degrees), ``push`` (increase in newtons from one push to the next, with one
    push per second), ``delay`` (cycles until an action takes effect), ``cycles`` (per action; default: that of the task), ``noise`` (standard deviation of
    additional noise in joint angles, gyroscope and accelerometer), ``friction``, ``sole_friction`` and ``mass`` (relative to the default),
    ``strength`` (relative torque limit, drawn for each joint), ``com_forward`` and ``com_left`` (metres by which the torso's weight is
    displaced), ``jitter`` (random delay of each action, in cycles) and, for ``Follow`` and similar tasks, ``forward``, ``left`` (m/s) and ``turn`` (degrees/s). Each option is a number, or a pair (low, high) from which each
    episode draws. ``reset(options={...})`` changes only the next episode.

    ``render_mode="human"`` opens the studio, in which the robot moves in real time and can be paused.

    ``info`` contains the most important quantities of the true state. With ``true_state=True``, ``info["true_state"]`` is a vector of all of
    them, for asymmetric critics and rewards: ``true_state_names`` and ``true_state_units`` describe it. To customise a task, override ``observation``, ``reward`` and ``termination``:

    >>> class Crouch(RoboNewbieEnv):
    ...     def reward(self, reward: float, info: dict[str, Any]) -> float:
    ...         return -info["height"]
    """

    def __init__(self, task: str = "Walk", reward: str = "", render_mode: str | None = None, **options: Any) -> None:
        self.observation_space, self.action_space = self._connect(task, 1, reward, render_mode, options)
        if len(self.description["robots"]) > 1:
            raise RoboNewbieError(f"{task} trains several robots. Use robonewbie.parallel.parallel_env(\"{task}\").")
        self.range_degrees = np.array(self.description["rangeDegrees"])

    def observation(self, observation: np.ndarray, info: dict[str, Any]) -> Any:
        """Returns the observation for a step. Override to derive it from the sensor readings or the true state.

        If its shape differs from the task's, set ``observation_space`` in the constructor.
        """
        return observation

    def reward(self, reward: float, info: dict[str, Any]) -> float:
        """Returns the reward for a step. Override to replace the task's reward."""
        return reward

    def termination(self, terminated: bool, info: dict[str, Any]) -> bool:
        """Returns whether the episode is terminated. Override to replace the task's decision."""
        return terminated

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Any, dict[str, Any]]:
        super().reset(seed=seed)
        self._change(options)
        observation, _, _ = self._connection.act(RESET, int(self.np_random.integers(SEED_LIMIT)), 0)
        info = self._info()
        return self._observed(observation[0], info), info

    def step(self, action: np.ndarray) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        action = np.asarray(action, dtype=float)
        if action.shape != self.action_space.shape:
            raise RoboNewbieError(
                f"The action has the shape {action.shape} instead of {self.action_space.shape}: one number for each of "
                f"{', '.join(self.action_names)}."
            )
        observation, reward, terminated = self._connection.act(STEP, 0, action)
        info = self._info()
        return (
            self._observed(observation[0], info),
            float(self.reward(float(reward[0]), info)),
            bool(self.termination(bool(terminated[0]), info)),
            bool(self._connection.state[0] == TRUNCATED),
            info,
        )

    def _observed(self, observation, info):
        return _in_shape(self.observation(observation, info), self.observation_space)

    def _info(self):
        info = self._connection.infos()[0]
        for name in ("fallen", "is_success"):
            info[name] = bool(info[name])
        return info
