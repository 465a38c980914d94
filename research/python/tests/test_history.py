"""Observations of several actions, and actions that are joint speeds, in all kinds of environments and in Java."""

import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

import robonewbie
from robonewbie import evaluate, simulator, train

try:
    from robonewbie.sb3 import VecEnv
except ImportError:
    VecEnv = None


class HistoryTest(unittest.TestCase):
    def test_observation_is_followed_by_those_of_the_actions_before(self):
        env = robonewbie.RoboNewbieEnv("Stand", push=0, cycles=2, noise=1, history=3)
        self.addCleanup(env.close)
        now = len(env.observation_names) // 3
        first, _ = env.reset(seed=1)
        rows = [first[:now]]
        for _ in range(4):
            observation = env.step(np.full(12, 0.1))[0]
            rows.append(observation[:now])

        self.assertEqual(env.observation_names[now : now + 2], ["joint.NECK_YAW@-1", "joint.NECK_PITCH@-1"])
        self.assertTrue(env.observation_space.contains(observation))
        np.testing.assert_array_equal(first, np.tile(rows[0], 3))
        np.testing.assert_array_equal(observation, np.concatenate(rows[:1:-1]))
        self.assertGreater(np.abs(rows[4] - rows[3]).max(), 0.1)

    def test_history_begins_anew_with_each_episode(self):
        robots = robonewbie.RoboNewbieVectorEnv("Stand", 2, push=0, history=2, max_episode_steps=2)
        self.addCleanup(robots.close)
        robots.reset(seed=1)
        for _ in range(3):
            observation = robots.step(np.full((2, 12), 0.2))[0]
        now, before = np.split(observation, 2, axis=1)
        np.testing.assert_array_equal(now, before)

    @unittest.skipUnless(VecEnv, "stable-baselines3 is not installed")
    def test_same_observations_when_robots_are_reset_in_their_step(self):
        robots = VecEnv("Stand", 2, push=0, cycles=250, history=2)
        self.addCleanup(robots.close)
        robots.reset()
        first = robots.step(np.zeros((2, 12)))[0]
        again, _, done, infos = robots.step(np.zeros((2, 12)))
        self.assertTrue(done.all())
        np.testing.assert_array_equal(*np.split(again, 2, axis=1))
        np.testing.assert_array_equal(np.split(infos[0]["terminal_observation"], 2)[1], np.split(first[0], 2)[0])

    def test_spaces_cannot_be_changed_later(self):
        env = robonewbie.RoboNewbieEnv("Stand")
        self.addCleanup(env.close)
        for option in ("history", "speeds"):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, f"{option} cannot be changed later"):
                env.reset(options={option: 1 if option == "speeds" else 2})

    def test_tasks_that_correct_something_refuse_what_does_not_fit(self):
        for task, options in (("EngineRun", {"history": 2}), ("EngineRun", {"speeds": 1}), ("KickTo", {"speeds": 1})):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, f"Omit the option {next(iter(options))}"):
                robonewbie.RoboNewbieEnv(task, **options)


class SpeedsTest(unittest.TestCase):
    def test_action_is_the_speed_of_a_joint(self):
        env = robonewbie.RoboNewbieEnv("GetUp", speeds=1, true_state=True)
        self.addCleanup(env.close)
        env.reset(seed=1)
        action = np.array([0.1 if name == "LEFT_ARM_ROLL" else 0 for name in env.action_names])
        states = [env.step(action)[-1]["true_state"] for _ in range(10)]
        angles, speeds = (np.array(states)[:, env.true_state_names.index(f"{kind}.LEFT_ARM_ROLL")] for kind in ("joint", "speed"))
        self.assertAlmostEqual(speeds[-1], 35.1, delta=2)
        self.assertAlmostEqual(angles[-1] - angles[4], 5 * 0.02 * 35.1, delta=0.5)
        self.assertEqual(env.description["output"][0], {"name": "speed.LEFT_SHOULDER_PITCH", "unit": "351.77 degrees/s"})

    def test_java_plays_a_policy_of_speeds_and_earlier_observations_as_python_does(self):
        """The head swings, since its speed is that of a spring that pulls to 0, and what it was before."""
        layers = [(np.array([[0.02, -0.06]]), np.array([0.3]), "cut")]
        inputs = [("joint.NECK_YAW", "degrees"), ("joint.NECK_YAW@-2", "degrees")]
        text = train.policy_text("Swing", [], inputs, [("speed.NECK_YAW", "351.77 degrees/s")], 1, layers, cycles=2)
        policy = evaluate.PlayedPolicy(text)
        self.assertEqual(policy.options, {"cycles": 2, "history": 3, "speeds": 1})
        agent = """
            import java.nio.file.Path;
            import org.robonewbie.agent.*;
            import org.robonewbie.agent.policy.file.PolicyFile;
            import org.robonewbie.nao.Joint;

            public class Swing extends Agent {
                private final PolicyPlayer policy = new PolicyPlayer(PolicyFile.read(Path.of("Swing.policy")));

                public static void main(String[] args) { new Swing().run(args); }

                @Override
                protected void think() {
                    System.out.println("Head " + nao.getJointAngle(Joint.NECK_YAW));
                    policy.act(nao);
                }
            }
            """
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "Swing.policy").write_text(text, encoding="utf-8")
            Path(folder, "Swing.java").write_text(agent, encoding="utf-8")
            words = [*simulator._command(), "run", "Swing.java", "--headless", "--fast", "--seconds", "3"]
            told = subprocess.run(words, cwd=folder, check=True, capture_output=True, text=True).stdout
        angles = [float(angle) for angle in re.findall(r"^Head (\S+)", told, re.MULTILINE)]

        # The speed acts one cycle after it was sent, and is sensed another cycle later.
        observed = angles[::2]
        for i in range(3, len(observed) - 2):
            sent = policy.act(np.array([[observed[i], observed[i - 2]]]))[0, 0] * 351.77 * 0.04
            found = angles[2 * i + 3] - angles[2 * i + 1]
            self.assertAlmostEqual(found, sent, delta=1)
        self.assertGreater(max(angles) - min(angles), 4)


if __name__ == "__main__":
    unittest.main()
