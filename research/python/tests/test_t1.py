"""The walk of the T1; skipped without MuJoCo and the league's server, training also without Stable-Baselines3."""

import contextlib
import importlib.util
import io
import tempfile
import unittest
from pathlib import Path

import numpy as np

from robonewbie.evaluate import PlayedPolicy

INSTALLED = all(importlib.util.find_spec(name) for name in ("mujoco", "rcsssmj"))
LEARNING = INSTALLED and importlib.util.find_spec("stable_baselines3")

if INSTALLED:
    from robonewbie.t1 import robot
if LEARNING:
    import torch

    from robonewbie.t1 import environment, mirror
    from robonewbie.t1.environment import Variation, WalkingRobots
    from robonewbie.t1.policy import policy_text
    from robonewbie.t1.training import Training


class ShippedPolicyTest(unittest.TestCase):
    def test_java_programs_walk_with_the_same_policy(self):
        root = Path(__file__).parents[3]
        ours = root / "research/python/robonewbie/t1/t1-walk.policy"
        theirs = root / "core/agent/src/main/resources/policies/t1-walk.policy"

        self.assertEqual(ours.read_bytes(), theirs.read_bytes())


@unittest.skipUnless(INSTALLED, "mujoco or rcsssmj is not installed")
class RobotTest(unittest.TestCase):
    def test_tilt_filter_finds_up_while_the_torso_leans(self):
        lean = np.radians(10)
        tilt = robot.TiltFilter()

        for _ in range(400):
            tilt.update(np.zeros((1, 3)), 9.81 * np.array([[-np.sin(lean), 0, np.cos(lean)]]))

        np.testing.assert_allclose(tilt.up, [[-np.sin(lean), 0, np.cos(lean)]], atol=1e-3)

    def test_tilt_filter_follows_the_gyroscope_during_impacts(self):
        tilt = robot.TiltFilter()

        for _ in range(50):
            tilt.update(np.array([[0.0, 20, 0]]), np.array([[0.0, 0, 50]]))

        self.assertAlmostEqual(np.degrees(np.arctan2(-tilt.up[0, 0], tilt.up[0, 2])), 20, delta=0.1)

    def test_gait_begins_with_the_left_foot_and_fades_within_a_stride(self):
        clock, command, rest = robot.GaitClock(), np.array([[0, 0.1, 0]]), np.zeros((1, 3))

        clock.update(rest)
        np.testing.assert_allclose(clock.sine_and_cosine(), [[0, 0]])
        for _ in range(5):
            clock.update(command)
        self.assertGreater(clock.sine_and_cosine()[0, 0], 0.2)
        for _ in range(2 * robot.GAIT_ACTIONS - 4):
            clock.update(command)
        np.testing.assert_allclose(clock.sine_and_cosine(), [[0, 1]], atol=1e-9)
        for _ in range(robot.GAIT_ACTIONS):
            clock.update(rest)
        np.testing.assert_allclose(clock.sine_and_cosine(), [[0, 0]])

    def test_swinging_leg_is_lifted_without_an_action(self):
        targets = robot.target_degrees(np.zeros((2, 12)), np.array([[1, 0], [-0.5, 0]]), np.zeros((2, 3)))

        left, right = targets[:, 11:17] - robot.STANCE_DEGREES[11:17], targets[:, 17:] - robot.STANCE_DEGREES[17:]
        np.testing.assert_allclose(left, [[-14, 1.2, 0, 28, -14, -0.72], [0, -0.6, 0, 0, 0, 0.36]])
        np.testing.assert_allclose(right, [[0, 1.2, 0, 0, 0, -0.72], [-7, -0.6, 0, 14, -7, 0.36]])

    def test_legs_swing_by_command(self):
        targets = robot.target_degrees(np.zeros((1, 12)), np.array([[0, 1]]), np.array([[0.6, 0, 45]]))

        np.testing.assert_allclose(targets[0, 11:17] - robot.STANCE_DEGREES[11:17], [3, -1.6, -6, 0, -2.1, 0.96])
        np.testing.assert_allclose(targets[0, 17:] - robot.STANCE_DEGREES[17:], [-3, -1.6, 6, 0, 2.1, 0.96])

    def test_command_changes_within_half_a_second(self):
        command, wanted = np.zeros((1, 3)), np.array([[0.6, -0.3, 10]])

        command = robot.approached(command, wanted)
        np.testing.assert_allclose(command, [[0.05, -0.025, 3.75]])
        for _ in range(11):
            command = robot.approached(command, wanted)
        np.testing.assert_allclose(command, wanted)

    def test_commands_are_limited_as_in_java(self):
        np.testing.assert_allclose(robot.limited(np.array([[-0.4, 0, 0], [0.6, 0.3, 0], [0.1, 0, 5]])), [[-0.2, 0, 0], [0.3, 0.15, 0], [0.1, 0, 5]])


@unittest.skipUnless(LEARNING, "mujoco, rcsssmj or stable-baselines3 is not installed")
class EnvironmentTest(unittest.TestCase):
    def setUp(self):
        torch.set_num_threads(1)

    def _robots(self, *arguments, **named):
        robots = WalkingRobots(*arguments, **named)
        self.addCleanup(robots.close)
        return robots

    def test_robot_stands_without_actions(self):
        robots = self._robots(3, seed=1, variation=Variation.none(), command=(0, 0, 0))
        robots.reset()

        for _ in range(75):
            robots.step_async(np.zeros((3, 12)))
            _, _, done, _ = robots.step_wait()
            self.assertFalse(done.any())

        self.assertTrue((robots.position[:, 2] > 0.6).all())
        self.assertTrue(robots.touch.all())

    def test_fallen_robots_begin_again(self):
        robots = self._robots(4, seed=1)
        robots.reset()
        lying = np.array([1, 0, 1, 0], bool)
        robots.position[lying, 2] = 0.2
        robots.step_async(np.zeros((4, 12)))

        _, _, done, infos = robots.step_wait()

        np.testing.assert_array_equal(done, lying)
        self.assertTrue(infos[0]["episode"]["fallen"])
        self.assertFalse(infos[0]["TimeLimit.truncated"])
        self.assertTrue((robots.position[:, 2] > 0.6).all())

    def test_equal_seeds_give_equal_episodes(self):
        actions = np.random.default_rng(7).uniform(-0.3, 0.3, (40, 5, 12))
        observed = []
        for seed in (1, 1, 2):
            robots = self._robots(5, seed=seed)
            robots.reset()
            for action in actions:
                robots.step_async(action)
                last, *_ = robots.step_wait()
            observed.append(last)

        np.testing.assert_array_equal(observed[0], observed[1])
        self.assertFalse(np.array_equal(observed[0], observed[2]))

    def test_mirrored_actions_give_mirrored_observations(self):
        robots = [self._robots(1, 1, Variation.none(1), command=(0.2, side * 0.1, side * 10), restart=False) for side in (1, -1)]
        inputs, input_signs = mirror.mirror_of_inputs()
        critic = np.array([0, 1, 2, 3, 4, 5, 7, 6, 8, 9, 10])  # the feet change sides
        indices = np.append(inputs, environment.INPUTS + critic)
        signs = np.append(input_signs, [1, -1, -1, 1, -1, *[1] * 6])
        action_indices, action_signs = mirror.mirror_of_action()
        random = np.random.default_rng(3)
        for one in robots:
            one.reset()
            one.angles[:] = np.radians(robot.STANCE_DEGREES)
            one.clock.amplitude[:] = 1
            one.state[:, -29:] = 0
        robots[1].clock.actions[:] = robot.GAIT_ACTIONS // 2
        for _ in range(10):
            action = random.uniform(-0.5, 0.5, (1, 12))
            robots[0].step_async(action)
            robots[1].step_async(action[:, action_indices] * action_signs)
            (first, reward, *_), (second, mirrored_reward, *_) = (one.step_wait() for one in robots)

            np.testing.assert_allclose(first[:, indices] * signs, second, atol=0.1)
            np.testing.assert_allclose(reward, mirrored_reward, atol=0.01)


@unittest.skipUnless(LEARNING, "mujoco, rcsssmj or stable-baselines3 is not installed")
class TrainingTest(unittest.TestCase):
    def test_training_is_resumed_and_its_file_plays_the_same_actions(self):
        with tempfile.TemporaryDirectory() as folder:
            out = Path(folder) / "walk.policy"
            first = Training(out, total=100, robots=2)
            self.assertEqual(first.model.num_timesteps, 0)
            with contextlib.redirect_stdout(io.StringIO()) as printed:
                first.run()
            self.assertIn("1280 actions: reward", printed.getvalue())

            again = Training(out, total=3000, robots=2, resume=True)
            self.addCleanup(again.model.env.close)
            self.assertEqual(again.model.num_timesteps, 1280)

            observed = np.random.default_rng(1).normal(0, 3, (100, environment.INPUTS + environment.PRIVILEGED)).astype(np.float32)
            clipped = observed.clip(-robot.OBSERVATION_LIMIT, robot.OBSERVATION_LIMIT)
            wanted, _ = again.model.predict(clipped, deterministic=True)
            np.testing.assert_allclose(PlayedPolicy(out.read_text("utf-8")).act(observed[:, : environment.INPUTS]), wanted, atol=1e-3)
            indices, signs = mirror.mirror_of_inputs()
            action_indices, action_signs = mirror.mirror_of_action()
            clipped[:, : environment.INPUTS] = clipped[:, indices] * signs
            mirrored, _ = again.model.predict(clipped, deterministic=True)
            np.testing.assert_allclose(mirrored, wanted[:, action_indices] * action_signs, atol=1e-5)
            self.assertEqual(policy_text(again.model, []).count("\ninput "), environment.INPUTS)
            self.assertTrue(out.with_name("walk.policy.csv").exists())


if __name__ == "__main__":
    unittest.main()
