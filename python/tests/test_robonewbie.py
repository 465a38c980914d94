"""Run with: python -m unittest discover -s python/tests"""

import os
import subprocess
import sys
import unittest
import warnings
from unittest import mock

import gymnasium
import numpy as np
from gymnasium.utils.env_checker import check_env

import robonewbie
from robonewbie import simulator

TASKS = ["Stand", "Walk", "Kick", "Reach"]


class EnvironmentTest(unittest.TestCase):
    def test_each_task_passes_the_checker(self):
        for task in TASKS:
            with self.subTest(task), warnings.catch_warnings():
                warnings.simplefilter("error")
                env = gymnasium.make(f"RoboNewbie/{task}-v1")
                check_env(env.unwrapped, skip_render_check=True)
                env.close()

    def test_same_seed_gives_the_same_episode(self):
        def episode(seed):
            env = gymnasium.make("RoboNewbie/Stand-v1")
            env.action_space.seed(5)
            rows = [env.reset(seed=seed)[0]]
            for _ in range(80):
                observation, reward, *_ = env.step(env.action_space.sample())
                rows.append(np.append(observation, reward))
            env.close()
            return np.concatenate(rows)

        np.testing.assert_array_equal(episode(3), episode(3))
        self.assertFalse(np.array_equal(episode(3), episode(4)))

    def test_episode_ends_after_its_time(self):
        env = gymnasium.make("RoboNewbie/Reach-v1")
        env.reset(seed=1)
        steps, truncated = 0, False
        while not truncated:
            _, reward, terminated, truncated, _ = env.step(np.zeros(4, dtype=np.float32))
            self.assertFalse(terminated)
            self.assertLess(reward, 0)
            steps += 1
        self.assertEqual(steps, 100)
        self.assertEqual(env.unwrapped.action_names[0], "LEFT_SHOULDER_PITCH")
        self.assertIn("target.up", env.unwrapped.observation_names)
        env.close()

    def test_robot_that_moves_wildly_falls(self):
        env = gymnasium.make("RoboNewbie/Walk-v1")
        env.reset(seed=1)
        action = np.zeros(12, dtype=np.float32)
        for i, name in enumerate(env.unwrapped.action_names):
            action[i] = 1 if name.endswith("HIP_PITCH") else 0
        terminated = truncated = False
        while not (terminated or truncated):
            *_, terminated, truncated, _ = env.step(action)
        self.assertTrue(terminated)
        env.close()

    def test_action_that_is_no_number_is_told(self):
        env = robonewbie.RoboNewbieEnv("Reach")
        env.reset(seed=1)
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "divided by zero"):
            env.step(np.full(4, np.nan, dtype=np.float32))
        env.step(np.zeros(4, dtype=np.float32))
        env.close()

    def test_unknown_task_is_told_with_those_that_exist(self):
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, 'no task "Fly". There are: Kick, Reach, Stand, Walk'):
            robonewbie.RoboNewbieEnv("Fly")


    def test_any_measure_can_be_the_reward(self):
        env = gymnasium.make("RoboNewbie/Walk-v1", reward="distance-walked")
        energy = gymnasium.make("RoboNewbie/Walk-v1", reward="energy")
        env.reset(seed=1)
        energy.reset(seed=1)
        total = cost = 0
        action = np.zeros(12, dtype=np.float32)
        for i in range(40):
            action[:] = 0.2 * np.sin(i / 3)
            total += env.step(action)[1]
            cost += energy.step(action)[1]
        self.assertNotEqual(total, 0)
        self.assertLess(abs(total), 0.5)
        self.assertLess(cost, 0)
        env.close()
        energy.close()

        with self.assertRaisesRegex(robonewbie.RoboNewbieError, 'no measure "joy". There are: .*energy'):
            gymnasium.make("RoboNewbie/Walk-v1", reward="joy")


class VectorTest(unittest.TestCase):
    def test_many_robots_do_the_same_as_each_alone(self):
        many = gymnasium.make_vec("RoboNewbie/Stand-v1", num_envs=4)
        observation, _ = many.reset(seed=10)
        rows = [observation]
        action = np.full((4, 12), 0.05, dtype=np.float32)
        for _ in range(30):
            rows.append(many.step(action)[0])
        many.close()

        with_measure = gymnasium.make_vec("RoboNewbie/Stand-v1", num_envs=2, reward="standing-time")
        with_measure.reset(seed=10)
        np.testing.assert_allclose(with_measure.step(action[:2])[1], [0.02, 0.02])
        with_measure.close()

        for i in range(4):
            alone = gymnasium.make("RoboNewbie/Stand-v1")
            own = [alone.reset(seed=10 + i)[0]] + [alone.step(action[i])[0] for _ in range(30)]
            alone.close()
            np.testing.assert_array_equal([row[i] for row in rows], own)

    def test_episode_that_is_over_begins_anew_in_the_next_step(self):
        many = gymnasium.make_vec("RoboNewbie/Reach-v1", num_envs=2)
        many.reset(seed=1)
        action = np.zeros((2, 4), dtype=np.float32)
        for _ in range(99):
            *_, truncated, _ = many.step(action)
            self.assertFalse(truncated.any())
        *_, truncated, _ = many.step(action)
        self.assertTrue(truncated.all())
        _, reward, _, truncated, _ = many.step(action)
        self.assertFalse(truncated.any())
        np.testing.assert_array_equal(reward, [0, 0])
        many.close()


class ProcessTest(unittest.TestCase):
    def test_simulator_ends_when_python_is_killed(self):
        program = (
            "import os, robonewbie, robonewbie.simulator as s\n"
            "robonewbie.RoboNewbieEnv('Reach')\n"
            "print(s._process.process.pid, flush=True)\n"
            "os.kill(os.getpid(), 9)\n"
        )
        killed = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, check=False)
        self.assertTrue(_ends(int(killed.stdout)))

    def test_missing_program_and_missing_java_are_told(self):
        with mock.patch.dict(os.environ, {"ROBONEWBIE": "/nowhere/robonewbie.jar"}):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Set it to the folder"):
                simulator._command()
        with mock.patch.dict(os.environ, {"ROBONEWBIE": __file__, "PATH": "", "JAVA_HOME": "/nowhere"}):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Install a JDK 17"):
                simulator._java()


def _ends(process):
    """Waits at most ten seconds until a process of another program is gone."""
    code = (
        "import os, sys, time\n"
        "for _ in range(100):\n"
        "    try: os.kill(int(sys.argv[1]), 0)\n"
        "    except ProcessLookupError: sys.exit(0)\n"
        "    try:\n"
        "        if open('/proc/' + sys.argv[1] + '/stat').read().rsplit(')')[1].split()[0] == 'Z': sys.exit(0)\n"
        "    except OSError: pass\n"
        "    time.sleep(0.1)\n"
        "sys.exit(1)\n"
    )
    return subprocess.run([sys.executable, "-c", code, str(process)], check=False).returncode == 0


if __name__ == "__main__":
    unittest.main()
