"""Many T1 that learn to walk by command, in MuJoCo, with the interface of Stable-Baselines3.

All robots are stepped by one call of ``mujoco.rollout``. What differs between episodes: friction, delay of the motors, pushes, noise,
commands, where the head looks, and the first posture.
"""

from dataclasses import dataclass, replace

import gymnasium
import mujoco
import numpy as np
from mujoco import rollout
from stable_baselines3.common.vec_env import VecEnv

from . import robot

COMMAND_ACTIONS = round(3 / robot.ACTION_SECONDS)
EPISODE_ACTIONS = round(15 / robot.ACTION_SECONDS)
STEPS = robot.STEPS_PER_CYCLE * robot.CYCLES_PER_ACTION
FALLEN_HEIGHT = 0.45  # of the torso
FALLEN_COSINE = 0.5
INPUTS = len(robot.INPUTS)
PRIVILEGED = 11  # quantities that only the critic observes, see mirror.py


@dataclass(frozen=True)
class Variation:
    """Ranges of what differs between episodes."""

    delay_cycles: tuple = (0, 2)
    friction: tuple = (0.5, 1.5)
    push: float = 0.3  # m/s, about every 4 s
    noise: float = 1.0  # of all sensors
    head_degrees: float = 50
    start_speed: float = 0.3  # m/s
    standing: float = 0.12  # share of commands
    strictness: float = 1.0  # from 0, where nearly any motion in the wanted direction pays, to 1

    def eased(self, share):
        """Returns ranges for the beginning of the training, when all that makes walking hard is multiplied by a share up to 1."""
        share = min(1, share)
        shortest, longest = self.delay_cycles
        return replace(
            self,
            delay_cycles=(shortest, shortest + round(share * (longest - shortest))),
            friction=tuple(1 + share * (friction - 1) for friction in self.friction),
            push=share * self.push,
            noise=share * self.noise,
            head_degrees=share * self.head_degrees,
            start_speed=share * self.start_speed,
            strictness=share * self.strictness,
        )

    @staticmethod
    def none(delay_cycles=0):
        """Returns what is nearest to the server: a robot at rest, without pushes and noise."""
        return Variation((delay_cycles,) * 2, (1, 1), 0, 0, 0, 0)


class WalkingRobots(VecEnv):
    """Vectorised environment. An action is a vector of 12 numbers, see :func:`robonewbie.t1.robot.target_degrees`.

    The observation consists of the inputs of the policy and of quantities for the critic that a real robot cannot measure.

    :param command: constant command (forward, left, turn) instead of random ones
    :param restart: whether fallen robots begin a new episode, and all after 15 s
    """

    def __init__(self, robots, seed=0, variation=Variation(), command=None, restart=True, threads=0):
        self.variation, self.restart, self._fixed = variation, restart, command
        self._random = np.random.default_rng(seed)
        self.model = mujoco.MjModel.from_xml_string(robot.scene_text())
        self._models = [mujoco.MjModel.from_xml_string(robot.scene_text()) for _ in range(robots)]
        self._data = [mujoco.MjData(self.model) for _ in range(max(1, threads))]
        self._rollout = rollout.Rollout(nthread=threads)
        self._colliding = np.flatnonzero(self.model.geom_priority)
        self._sensors = {self.model.sensor(i).name: slice(a := self.model.sensor_adr[i], a + self.model.sensor_dim[i]) for i in range(self.model.nsensor)}
        self._stance_height = self._height_of_stance()
        infinite = np.full(INPUTS + PRIVILEGED, np.inf, np.float32)
        super().__init__(robots, gymnasium.spaces.Box(-infinite, infinite), gymnasium.spaces.Box(-1, 1, (12,), np.float32))
        self._create_arrays(robots)
        self._begin(np.arange(robots))

    def _height_of_stance(self):
        data = self._data[0]
        mujoco.mj_resetData(self.model, data)
        data.qpos[7:] = np.radians(robot.STANCE_DEGREES)
        mujoco.mj_forward(self.model, data)
        sole = data.geom("left_foot").xpos[2] - self.model.geom("left_foot").size[2]
        return data.qpos[2] - sole

    def _create_arrays(self, count):
        nq = self.model.nq
        self.state = np.zeros((count, 1 + nq + self.model.nv))
        # Views of the state. Linear velocity is in the world's frame, angular velocity in the torso's.
        self.position, self.orientation, self.angles = self.state[:, 1:4], self.state[:, 4:8], self.state[:, 8 : 1 + nq]
        self.velocity, self.rotation = self.state[:, 1 + nq : 4 + nq], self.state[:, 4 + nq : 7 + nq]
        self.actions = np.zeros(count, int)  # since the beginning of the episode
        self.previous = np.zeros((count, 12))
        self._last_targets = np.tile(np.radians(robot.STANCE_DEGREES), (count, 1))
        self.command = np.zeros((count, 3))  # on the way to the wanted one
        self.wanted = np.zeros((count, 3))
        self.moved = np.zeros((count, 3))  # velocity during the last action: forward, left, turn
        self.mean_velocity = np.zeros((count, 3))  # the same, smoothed
        self.delay = np.zeros(count, int)
        self.friction = np.ones(count)
        self.head = np.zeros((count, 2))
        self.head_goal = np.zeros((count, 2))
        self.load, self.touch = np.ones((count, 2)), np.ones((count, 2), bool)  # force on each foot, and whether there is some
        self.foot_height = np.zeros((count, 2))
        self.fallen = np.zeros(count, bool)
        self.tilt, self.clock = robot.TiltFilter(count), robot.GaitClock(count)
        self._gyro, self._leg_degrees, self._leg_speeds = np.zeros((count, 3)), np.zeros((count, 12)), np.zeros((count, 12))
        self._return = np.zeros(count)

    # ---- Episodes

    def _begin(self, which):
        """Begins new episodes of some robots, given by their indices."""
        count, vary, random = len(which), self.variation, self._random
        degrees = np.tile(robot.STANCE_DEGREES, (count, 1))
        degrees[:, robot.FIRST_LEG_MOTOR :] += random.normal(0, 1, (count, 12)) * (1 + vary.noise)
        self.state[which] = 0
        self.position[which, 2] = self._stance_height + 0.005
        self.orientation[which, 0] = 1
        self.angles[which] = np.radians(degrees)
        self.velocity[which, :2] = self._any_direction(vary.start_speed, count)
        self.actions[which] = 0 if count < self.num_envs else random.integers(0, COMMAND_ACTIONS, count) * self.restart
        for array in (self.command, self.previous, self.mean_velocity, self.head, self._gyro, self._leg_speeds, self._return):
            array[which] = 0
        self._last_targets[which] = np.radians(robot.STANCE_DEGREES)
        self.touch[which] = True
        self.fallen[which] = False
        self._leg_degrees[which] = degrees[:, robot.FIRST_LEG_MOTOR :]
        self.tilt.up[which] = [0, 0, 1]
        self.delay[which] = random.integers(vary.delay_cycles[0], vary.delay_cycles[1] + 1, count)
        self.friction[which] = random.uniform(*vary.friction, count)
        for i in which:
            self._models[i].geom_friction[self._colliding, 0] = self.friction[i]
        self._draw_commands(which)
        self.clock.amplitude[which] = 0
        self.clock.actions[which] = 0

    def _any_direction(self, longest, count):
        angle, length = self._random.uniform(0, 2 * np.pi, count), self._random.uniform(0, longest, count)
        return np.column_stack([length * np.cos(angle), length * np.sin(angle)])

    def _draw_commands(self, which):
        count, random = len(which), self._random
        drawn = random.uniform(0.2, 1, (count, 3)) * robot.MAX_COMMAND * random.choice([-1, 1], (count, 3), p=[0.4, 0.6])
        drawn *= random.uniform(size=(count, 3)) < 0.6  # so that each component is often used alone
        drawn *= (random.uniform(size=count) > self.variation.standing)[:, None]
        drawn = robot.limited(drawn)
        self.wanted[which] = drawn if self._fixed is None else self._fixed
        self.head_goal[which] = random.uniform(-1, 1, (count, 2)) * self.variation.head_degrees * [1, 0.4]

    # ---- Interface of Stable-Baselines3

    def reset(self):
        self._begin(np.arange(self.num_envs))
        return self._observation()

    def step_async(self, actions):
        self._action = np.clip(actions, -1, 1).astype(float)

    def step_wait(self):
        action = self._action
        place, heading = self.position[:, :2].copy(), self.heading()
        unstable = self._move(action)
        self._measure_velocity(place, heading)
        reward = self._reward(action)
        self.previous = action
        self.actions += 1
        up = 1 - 2 * (self.orientation[:, 1] ** 2 + self.orientation[:, 2] ** 2)
        self.fallen = unstable | (up < FALLEN_COSINE) | (self.position[:, 2] < FALLEN_HEIGHT)
        reward = np.where(unstable, 0, reward) - self.fallen
        late = self.actions >= EPISODE_ACTIONS
        self._return += reward
        renewed = np.flatnonzero(self.actions % COMMAND_ACTIONS == 0)
        if len(renewed):
            self._draw_commands(renewed)
        self.command = robot.approached(self.command, self.wanted)
        self.clock.update(self.command)
        observed = self._observation()
        done = (self.fallen | late) & self.restart
        infos = [{} for _ in range(self.num_envs)]
        which = np.flatnonzero(done)
        if len(which):
            for i in which:
                infos[i] = {
                    "terminal_observation": observed[i],
                    "TimeLimit.truncated": bool(late[i] and not self.fallen[i]),
                    "episode": {"r": self._return[i], "l": int(self.actions[i]), "fallen": bool(self.fallen[i]), "t": 0},
                }
            self._begin(which)
            observed[which] = self._observation()[which]
        return observed, reward.astype(np.float32), done, infos

    def close(self):
        self._rollout.close()

    def get_attr(self, attr_name, indices=None):
        return [getattr(self, attr_name, None)] * self.num_envs

    def set_attr(self, attr_name, value, indices=None):
        raise NotImplementedError

    def env_method(self, method_name, *arguments, indices=None, **named):
        raise NotImplementedError

    def env_is_wrapped(self, wrapper_class, indices=None):
        return [False] * self.num_envs

    # ---- Physics

    def _move(self, action):
        """Steps the physics for the time of an action, and returns which robots became unstable."""
        self.head += np.clip(self.head_goal - self.head, -4, 4)
        targets = self._targets(action)
        delayed = np.arange(STEPS) < robot.STEPS_PER_CYCLE * self.delay[:, None]
        sequence = np.where(delayed[:, :, None], self._last_targets[:, None], targets[:, None])
        self._last_targets = targets
        states, sensors = self._rollout.rollout(self._models, self._data, self.state, np.ascontiguousarray(sequence))
        self.state[:] = states[:, -1]
        unstable = ~np.isfinite(self.state).all(axis=1) | (np.abs(self.velocity).max(axis=1) > 50)
        self.state[unstable] = 0
        self.orientation[unstable, 0] = 1
        self._push()
        for cycle in range(1, robot.CYCLES_PER_ACTION + 1):
            self._sense(np.nan_to_num(sensors[:, cycle * robot.STEPS_PER_CYCLE - 1]))
        return unstable

    def _targets(self, action):
        degrees = robot.target_degrees(action, self.clock.sine_and_cosine(), self.command)
        degrees[:, :2] += self.head
        return np.radians(degrees)

    def _push(self):
        pushed = self._random.uniform(size=self.num_envs) < 0.01
        self.velocity[:, :2] += self._any_direction(self.variation.push, self.num_envs) * pushed[:, None]

    def _sense(self, sensors):
        """Takes over the sensor readings of a cycle."""

        def noisy(values, deviation):
            return values + self._random.normal(0, 1, values.shape) * deviation * self.variation.noise

        count = len(robot.MOTORS)
        first = self._sensors["q_hj1"].start
        angles = np.degrees(sensors[:, first : first + count])
        speeds = np.degrees(sensors[:, first + count : first + 2 * count])
        self._gyro = noisy(np.degrees(sensors[:, self._sensors["torso_gyro"]]), 2)
        self._leg_degrees = noisy(angles[:, robot.FIRST_LEG_MOTOR :], 0.3)
        self._leg_speeds = noisy(speeds[:, robot.FIRST_LEG_MOTOR :], 5)
        self.tilt.update(self._gyro, noisy(sensors[:, self._sensors["torso_acc"]], 0.3))
        feet = ("left", "right")
        self.load = np.concatenate([sensors[:, self._sensors[f"{side}_touch"]] for side in feet], axis=1)
        self.touch = self.load > 1
        soles = [sensors[:, self._sensors[f"{side}_foot"].stop - 1] - self.model.geom(f"{side}_foot").size[2] for side in feet]
        self.foot_height = np.column_stack(soles)

    def heading(self):
        """Returns the direction of each torso in radians."""
        w, x, y, z = self.orientation.T
        return np.arctan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))

    def true_up(self):
        """Returns the direction of up in the torso's frame, forward and left."""
        w, x, y, z = self.orientation.T
        return np.column_stack([2 * (x * z - w * y), 2 * (y * z + w * x)])

    def _measure_velocity(self, place, heading):
        # From places, because velocities at the ends of actions, which are at the same phases of each stride, are not those in between.
        x, y = (self.position[:, :2] - place).T
        turn = (self.heading() - heading + np.pi) % (2 * np.pi) - np.pi
        cosine, sine = np.cos(heading), np.sin(heading)
        self.moved = np.column_stack([cosine * x + sine * y, cosine * y - sine * x, np.degrees(turn)]) / robot.ACTION_SECONDS
        self.mean_velocity += 0.15 * (self.moved - self.mean_velocity)

    # ---- Learning

    def _reward(self, action):
        # In shares of the largest command, so that a small command counts nearly as much as a large one.
        velocity, wanted = self.mean_velocity / robot.MAX_COMMAND, self.command / robot.MAX_COMMAND
        size = np.linalg.norm(wanted, axis=1)
        direction = wanted / np.maximum(size, 1e-6)[:, None]
        along = (velocity * direction).sum(axis=1)
        aside = np.linalg.norm(velocity - along[:, None] * direction, axis=1)
        paid = np.clip(along, -0.5, size) - np.maximum(0, along - size)
        reward = 0.5 + 3 * paid / np.maximum(size, 0.5) - (0.1 + 0.9 * self.variation.strictness) * aside
        reward -= 3 * (self.true_up() ** 2).sum(axis=1) + 0.02 * (self.rotation[:, :2] ** 2).sum(axis=1)
        reward -= 0.02 * ((action - self.previous) ** 2).sum(axis=1) + 0.01 * (action**2).sum(axis=1)
        return 0.1 * (reward + 0.6 * self._reward_of_steps())

    def _reward_of_steps(self):
        """Rewards a foot that carries no weight and is lifted when it is its turn, and a foot on the ground at any time."""
        sine = self.clock.sine_and_cosine()[:, 0]
        swinging = np.column_stack([sine > 0.2, sine < -0.2])
        share = self.load / np.maximum(1, self.load.sum(axis=1, keepdims=True))
        lifted = 0.5 - share + 0.5 * np.clip(self.foot_height / 0.04, 0, 1)
        return np.where(swinging, lifted, 0).sum(axis=1) - self.variation.strictness * ~self.touch.any(axis=1)

    def _observation(self):
        inputs = robot.observation(
            self.tilt.up, self._gyro, self._leg_degrees, self._leg_speeds, self.previous, self.command, self.clock.sine_and_cosine()
        )
        privileged = [
            self.mean_velocity / [0.5, 0.5, 60],
            self.true_up() * 3,
            (self.position[:, 2:] - self._stance_height) * 10,
            self.touch,
            self.foot_height.mean(axis=1, keepdims=True) * 10,
            self.friction[:, None] - 1,
            self.delay[:, None] - 1,
        ]
        return np.concatenate([inputs, np.clip(np.concatenate(privileged, axis=1), -5, 5)], axis=1).astype(np.float32)
