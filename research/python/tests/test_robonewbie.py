"""Run with: python -m unittest discover -s research/python/tests"""

import copy
import os
import pickle
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import urllib.request
import warnings
from pathlib import Path
from unittest import mock

import gymnasium
import numpy as np
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode

import robonewbie
from robonewbie import simulator

no_browser = mock.patch("webbrowser.open")


def setUpModule():
    no_browser.start()


def tearDownModule():
    no_browser.stop()


README = Path(__file__).parents[1] / "README.md"
TASKS = ["Stand", "Walk", "Follow", "GetUp", "Kick", "Reach"]


class EnvironmentTest(unittest.TestCase):
    def test_each_task_passes_the_checker(self):
        for task in TASKS:
            with self.subTest(task), warnings.catch_warnings():
                warnings.simplefilter("error")
                # Actions of Walk go to ±4.5, so that the first noise of PPO is small beside that.
                warnings.filterwarnings("default" if task == "Walk" else "error", ".*symmetric and normalized space")
                env = gymnasium.make(f"RoboNewbie/{task}-v1")
                check_env(env.unwrapped)
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
        env = gymnasium.make("RoboNewbie/Stand-v1")
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
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, 'no task "Fly". Available: .*Kick, .*Reach, .*Stand, Walk'):
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

        with self.assertRaisesRegex(robonewbie.RoboNewbieError, 'no measure "joy". Available: .*energy'):
            gymnasium.make("RoboNewbie/Walk-v1", reward="joy")


    def test_info_is_the_true_state(self):
        env = gymnasium.make("RoboNewbie/Kick-v1")
        _, info = env.reset(seed=1)
        self.assertAlmostEqual(info["x"], -2, delta=0.05)
        self.assertAlmostEqual(info["ball_x"], -1.81, delta=0.02)
        self.assertIs(info["fallen"], False)
        self.assertIs(info["is_success"], False)
        env.close()

    def test_start_place_and_heading_keep_the_posture(self):
        for task in ("GetUp", "QuickGetUp", "KickTo"):
            usual, moved = (robonewbie.RoboNewbieEnv(task, **options) for options in ({}, {"x": -3, "y": 1, "heading": 70}))
            _, first = usual.reset(seed=1)
            _, info = moved.reset(seed=1)
            self.assertAlmostEqual(info["heading"], 70, delta=0.01)
            self.assertAlmostEqual(info["x"], -3, delta=0.01)
            for _ in range(10):
                still = np.zeros(usual.action_space.shape)
                first, info = usual.step(still)[-1], moved.step(still)[-1]
            self.assertAlmostEqual(info["tilt"], first["tilt"], delta=0.1, msg=task)
            self.assertAlmostEqual(info["height"], first["height"], delta=0.005, msg=task)
            usual.close()
            moved.close()

    def test_options_change_episodes_and_draw_from_ranges(self):
        env = gymnasium.make("RoboNewbie/Walk-v1", heading=(30, 60), ball_x=2)
        headings = [env.reset(seed=seed)[1]["heading"] for seed in range(5)]
        self.assertTrue(all(29 < heading < 61 for heading in headings))
        self.assertGreater(np.ptp(headings), 3)
        self.assertAlmostEqual(env.reset(seed=0)[1]["heading"], headings[0], delta=1e-9)
        self.assertEqual(env.reset(options={"ball_x": 1})[1]["ball_x"], 1)
        self.assertEqual(env.reset()[1]["ball_x"], 2)
        env.close()
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, '"bal_x". Did you mean ball_x?'):
            gymnasium.make("RoboNewbie/Walk-v1", bal_x=1)
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "ascending range such as"):
            gymnasium.make("RoboNewbie/Walk-v1", x=(1, -1))
        for wrong in ("slippery", (1, 2, 3), None):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, 'option "friction" is .* a pair of numbers'):
                gymnasium.make("RoboNewbie/Walk-v1", friction=wrong)

    def test_delayed_action_acts_later(self):
        def angle_after(delay, steps):
            env = gymnasium.make("RoboNewbie/Reach-v1", delay=delay)
            env.reset(seed=1)
            for _ in range(steps):
                observation, *_ = env.step(np.ones(4, dtype=np.float32))
            index = env.unwrapped.observation_names.index("joint.LEFT_SHOULDER_PITCH")
            env.close()
            return observation[index]

        self.assertAlmostEqual(angle_after(0, 4), angle_after(3, 7), delta=0.05)
        self.assertLess(angle_after(3, 4), angle_after(0, 4) - 5)

    def test_subclass_pays_what_it_wants(self):
        sample = next(code for code in re.findall(r"```python\n(.*?)```", README.read_text(encoding="utf-8"), re.S) if "Crouch" in code)
        self.assertLess(len(sample.splitlines()), 40)
        names = {}
        exec(sample, names)
        env = names["Crouch"]()
        env.reset(seed=1)
        bend = np.array([1.0 if name.endswith("KNEE_PITCH") else 0.0 for name in env.action_names])
        rows = [env.step(-bend) for _ in range(40)]
        self.assertAlmostEqual(rows[0][1], -rows[0][4]["height"])
        self.assertTrue(any(row[2] and not row[4]["fallen"] for row in rows))
        env.close()

    def test_picture_shows_the_robot_on_the_grass(self):
        env = gymnasium.make("RoboNewbie/Walk-v1", render_mode="rgb_array")
        env.reset(seed=1)
        picture = env.render()
        self.assertEqual((picture.shape, picture.dtype), ((360, 480, 3), np.uint8))
        middle = picture[120:240, 180:300].astype(int)
        shirt = (middle[..., 0] > middle[..., 1] + 40) & (middle[..., 0] > middle[..., 2] + 40)
        self.assertGreater(shirt.mean(), 0.02)
        self.assertGreater((picture[..., 1] > picture[..., 0]).mean(), 0.5)
        env.close()
        with self.assertRaisesRegex(ValueError, "Available: human, rgb_array"):
            robonewbie.RoboNewbieEnv("Walk", render_mode="ansi")

    def test_studio_shows_the_robot_in_real_time(self):
        with mock.patch("webbrowser.open") as browser:
            env = gymnasium.make("RoboNewbie/Reach-v1", render_mode="human")
        address = env.unwrapped.studio_address
        (opened,) = browser.call_args.args
        self.assertTrue(opened.startswith("file:"), opened)  # and holds no code, since everybody can read command lines
        with urllib.request.urlopen(address) as page:
            self.assertIn(b"<title>", page.read())
        env.reset(seed=1)
        begin = time.monotonic()
        for _ in range(25):
            env.step(np.zeros(4))
        self.assertGreater(time.monotonic() - begin, 0.25)
        env.close()

    def test_friction_mass_and_noise_are_drawn_for_each_episode(self):
        def force_and_knee(**options):
            env = gymnasium.make("RoboNewbie/Stand-v1", push=0, **options)
            names = env.unwrapped.observation_names
            rows = []
            for seed in (1, 2, 1):
                env.reset(seed=seed)
                for _ in range(100):
                    observation, *_ = env.step(np.zeros(12))
                force = sum(observation[names.index(f"{side}Foot.force.up")] for side in ("left", "right"))
                rows.append((force, observation[names.index("joint.LEFT_KNEE_PITCH")]))
            env.close()
            return rows

        usual, heavy = force_and_knee(), force_and_knee(mass=(1.2, 1.4), friction=(0.5, 2), noise=1)
        self.assertAlmostEqual(usual[0][0], usual[1][0], delta=3)
        self.assertTrue(all(1.15 < row[0] / usual[0][0] < 1.45 for row in heavy))
        self.assertGreater(abs(heavy[0][0] - heavy[1][0]), 1)
        self.assertEqual(heavy[0], heavy[2])
        self.assertNotEqual(heavy[0][1], heavy[1][1])
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "mass=-1.0 is not between 0.1 and 10"):
            gymnasium.make("RoboNewbie/Walk-v1", mass=-1)

    def test_pickled_environment_is_made_again(self):
        env = robonewbie.RoboNewbieEnv("Walk", heading=(0, 40))
        copy = pickle.loads(pickle.dumps(env))
        self.assertEqual(copy.reset(seed=3)[1], env.reset(seed=3)[1])
        env.close()
        copy.close()

    def test_subclass_is_pickled_with_its_own_arguments(self):
        env = Crouch(depth=0.1, heading=(0, 40))
        twin = pickle.loads(pickle.dumps(env))
        deep = copy.deepcopy(env)
        self.assertEqual((twin.depth, deep.depth), (0.1, 0.1))
        self.assertEqual(twin.reset(seed=3)[1], env.reset(seed=3)[1])
        for each in (env, twin, deep):
            each.close()

    def test_videos_play_at_the_speed_of_the_simulation(self):
        env = gymnasium.make("RoboNewbie/GetUp-v1", cycles=5)
        self.assertEqual(env.metadata["render_fps"], 10)
        env.reset(options={"cycles": 2})
        self.assertEqual(env.metadata["render_fps"], 25)
        env.reset()
        self.assertEqual(env.metadata["render_fps"], 10)
        env.close()
        many = gymnasium.make_vec("RoboNewbie/Reach-v1", num_envs=2, cycles=5)
        self.assertEqual(many.metadata["render_fps"], 10)
        many.close()

    def test_cycles_are_one_whole_number(self):
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "cycles=2.5 is not a whole number"):
            robonewbie.RoboNewbieEnv("Walk", cycles=2.5)
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "cycles=2.0..6.0 is a range"):
            robonewbie.RoboNewbieEnv("Walk", cycles=(2, 6))
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "delay=0.0..1.5 is not a whole number"):
            robonewbie.RoboNewbieEnv("Walk", delay=(0, 1.5))
        robonewbie.RoboNewbieEnv("Walk", delay=(0, 2), cycles=2).close()

    def test_observation_of_another_shape_needs_its_space(self):
        class Taller(robonewbie.RoboNewbieEnv):
            def observation(self, observation, info):
                return np.append(observation, info["height"]).astype(np.float32)

        env = Taller("Stand")
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Set the observation space in the constructor"):
            env.reset(seed=1)
        env.observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(env.observation_names) + 1,), np.float32)
        self.assertEqual(env.reset(seed=1)[0].shape, env.observation_space.shape)
        env.close()

    def test_wrong_shape_and_closed_environment_are_told(self):
        env = robonewbie.RoboNewbieEnv("Reach")
        env.reset(seed=1)
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "one number for each of LEFT_SHOULDER_PITCH"):
            env.step(np.zeros(3))
        env.close()
        with self.assertRaisesRegex(robonewbie.RoboNewbieError, "is closed. Create it again"):
            env.step(np.zeros(4))


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


    def test_same_step_returns_the_next_episode_with_the_last_observation_of_the_old_one(self):
        next_step = gymnasium.make_vec("RoboNewbie/Reach-v1", num_envs=2)
        same_step = gymnasium.make_vec("RoboNewbie/Reach-v1", num_envs=2, autoreset_mode=AutoresetMode.SAME_STEP)
        self.assertIs(same_step.metadata["autoreset_mode"], AutoresetMode.SAME_STEP)
        action = np.full((2, 4), 0.2, dtype=np.float32)
        for many in (next_step, same_step):
            many.reset(seed=1)
            for _ in range(99):
                many.step(action)
        final, reward, _, truncated, final_info = next_step.step(action)
        first, *_ = next_step.step(action)
        observation, same_reward, _, same_truncated, info = same_step.step(action)

        np.testing.assert_array_equal(observation, first)
        np.testing.assert_array_equal(np.stack(info["final_obs"]), final)
        np.testing.assert_array_equal(info["final_info"]["x"], final_info["x"])
        np.testing.assert_array_equal(same_reward, reward)
        np.testing.assert_array_equal(same_truncated, truncated)
        next_step.close()
        same_step.close()
        with self.assertRaisesRegex(ValueError, "Choose NEXT_STEP or SAME_STEP"):
            robonewbie.RoboNewbieVectorEnv("Reach", 2, autoreset_mode=AutoresetMode.DISABLED)

    def test_hooks_on_arrays_give_the_episodes_of_single_environments(self):
        many, alone = ManyCrouch(num_envs=2), Crouch()
        many.reset(seed=4)
        alone.reset(seed=4)
        bend = -np.array([1.0 if name.endswith("KNEE_PITCH") else 0.0 for name in alone.action_names], dtype=np.float32)
        terminated = False
        while not terminated:
            observation, reward, terminated, _, _ = alone.step(bend)
            rows = many.step(np.stack([bend, 0 * bend]))
            np.testing.assert_array_equal(rows[0][0], observation)
            self.assertEqual(rows[1][0], reward)
            self.assertEqual(rows[2].tolist(), [terminated, False])
        self.assertEqual(rows[0].shape, many.observation_space.shape)
        many.close()
        alone.close()

    def test_vector_is_pickled_with_its_arguments(self):
        many = ManyCrouch(num_envs=3)
        twin = pickle.loads(pickle.dumps(many))
        np.testing.assert_array_equal(many.reset(seed=1)[0], twin.reset(seed=1)[0])
        many.close()
        twin.close()


class Crouch(robonewbie.RoboNewbieEnv):
    """Ends when the torso has sunk; observes its height as well."""

    def __init__(self, depth=0.05, **keywords):
        super().__init__("Stand", push=0, **keywords)
        self.depth = depth
        self.observation_space = _with_height(self.observation_space)

    def observation(self, observation, info):
        return np.append(observation, info["height"]).astype(np.float32)

    def reward(self, reward, info):
        return -info["height"]

    def termination(self, terminated, info):
        return terminated or info["height"] < 0.36 - self.depth


class ManyCrouch(robonewbie.RoboNewbieVectorEnv):
    """The same as Crouch, for arrays."""

    def __init__(self, depth=0.05, **keywords):
        super().__init__("Stand", push=0, **keywords)
        self.depth = depth
        self.single_observation_space = _with_height(self.single_observation_space)

    def observation(self, observation, info):
        return np.column_stack([observation, info["height"]]).astype(np.float32)

    def reward(self, reward, info):
        return -info["height"]

    def termination(self, terminated, info):
        return terminated | (info["height"] < 0.36 - self.depth)


def _with_height(space):
    return gymnasium.spaces.Box(np.append(space.low, 0), np.append(space.high, 1), dtype=np.float32)


class ProcessTest(unittest.TestCase):
    def test_id_with_the_name_of_the_package_needs_no_import(self):
        def made(name):
            code = f"import gymnasium; print(gymnasium.make('{name}').unwrapped)"
            return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)

        self.assertIn("<RoboNewbieEnv", made("robonewbie:RoboNewbie/Reach-v1").stdout)
        self.assertIn("NamespaceNotFound", made("RoboNewbie/Reach-v1").stderr)

    def test_types_are_part_of_the_package(self):
        self.assertTrue(Path(robonewbie.__file__).with_name("py.typed").exists())

    def test_processes_of_a_program_share_one_simulator(self):
        program = (
            "import multiprocessing, robonewbie\n"
            "def port(_):\n"
            "    env = robonewbie.RoboNewbieEnv('Reach')\n"
            "    number = env._connection._socket.getpeername()[1]\n"
            "    env.close()\n"
            "    return number\n"
            "if __name__ == '__main__':\n"
            "    ports = {port(0)}\n"
            "    with multiprocessing.get_context('spawn').Pool(2) as pool:\n"
            "        ports.update(pool.map(port, [1, 2]))\n"
            "    print(len(ports))\n"
        )
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "program.py")
            file.write_text(program, encoding="utf-8")
            done = subprocess.run(
                [sys.executable, str(file)], stdout=subprocess.PIPE, text=True, check=True, env=_environment_of_a_program()
            )
        self.assertEqual(done.stdout.strip(), "1")

    def test_stopped_simulator_is_told_and_does_not_hang(self):
        with mock.patch.object(simulator, "_TIMEOUT_SECONDS", 1):
            env = robonewbie.RoboNewbieEnv("Reach")
        env.reset(seed=1)
        process = simulator._process.process
        os.killpg(process.pid, signal.SIGSTOP)
        try:
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "has not answered"):
                for _ in range(1000):  # the signal may come a little later
                    env.step(np.zeros(4))
        finally:
            os.killpg(process.pid, signal.SIGCONT)

    def test_simulator_ends_when_python_is_killed(self):
        program = (
            "import os, robonewbie, robonewbie.simulator as s\n"
            "robonewbie.RoboNewbieEnv('Reach')\n"
            "print(s._process.process.pid, flush=True)\n"
            "os.kill(os.getpid(), 9)\n"
        )
        killed = subprocess.run(
            [sys.executable, "-c", program], stdout=subprocess.PIPE, text=True, check=False, env=_environment_of_a_program()
        )
        self.assertTrue(_ends(int(killed.stdout)))

    def test_missing_program_and_missing_java_are_told(self):
        with mock.patch.dict(os.environ, {"ROBONEWBIE": "/nowhere/robonewbie.jar"}):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Set it to the folder"):
                simulator._command()
        with mock.patch.dict(os.environ, {"ROBONEWBIE": __file__, "PATH": "", "JAVA_HOME": "/nowhere"}):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "Install Java 17 or newer"):
                simulator._java()

    @unittest.skipIf(os.name == "nt", "needs a shell script in the place of Java")
    def test_java_that_is_too_old_is_told(self):
        with tempfile.TemporaryDirectory() as home:
            java = Path(home, "bin", "java")
            java.parent.mkdir()
            java.write_text("#!/bin/sh\necho 'openjdk version \"1.8.0_401\"' >&2\n", encoding="utf-8")
            java.chmod(0o755)
            with mock.patch.dict(os.environ, {"JAVA_HOME": home}):
                with self.assertRaisesRegex(robonewbie.RoboNewbieError, r"Java 17 or newer is needed. Found: .* \(8\)"):
                    simulator._java()


def _environment_of_a_program():
    """The environment of a program that shares no simulator with this one."""
    return {name: text for name, text in os.environ.items() if name != "ROBONEWBIE_PORT_FILE"}


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
