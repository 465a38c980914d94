"""Self-play in matches; skipped where Stable-Baselines3 is not installed."""

import contextlib
import csv
import io
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from robonewbie import RoboNewbieError
from robonewbie.matches import Matches

try:
    from robonewbie import selfplay
except ImportError:
    selfplay = None

BASELINES = Path(__file__).parents[1] / "baselines"


class MatchesTest(unittest.TestCase):
    def test_many_matches_are_the_same_as_each_alone(self):
        together = Matches("Match2v2", 3, seconds=1)
        seen, _ = together.reset(seed=5)
        self.assertEqual(seen["right_2"].shape, (3, 13))
        self.assertEqual(together.observation_space("left_1").shape, (13,))
        actions = {agent: np.full((3, 3), 0.5) for agent in together.agents}
        for _ in range(5):
            seen, rewards, terminated, truncated, infos = together.step(actions)
        together.close()
        alone = Matches("Match2v2", 1, seconds=1)
        alone.reset(seed=7)
        for _ in range(5):
            last = alone.step({agent: values[2:] for agent, values in actions.items()})
        alone.close()

        self.assertTrue(truncated["left_1"].all())
        self.assertFalse(terminated["left_1"].any())
        for agent in actions:
            np.testing.assert_array_equal(infos[agent]["final_obs"][2:], last[-1][agent]["final_obs"])
            np.testing.assert_array_equal(seen[agent][2:], last[0][agent])
            np.testing.assert_array_equal(rewards[agent][2:], last[1][agent])
        self.assertGreater(np.abs(infos["left_1"]["final_obs"] - seen["left_1"]).max(), 0.01)  # of the next match

    def test_each_robot_needs_an_action(self):
        matches = Matches("Match1v1", 2)
        matches.reset(seed=1)
        with self.assertRaisesRegex(RoboNewbieError, "no action for right_1"):
            matches.step({"left_1": np.zeros((2, 3))})
        matches.close()


@unittest.skipUnless(selfplay, "stable-baselines3 is not installed")
class SelfPlayTest(unittest.TestCase):
    def test_learner_plays_from_both_sides_and_the_pool_is_its_opponent(self):
        forward = mock.Mock(inputs=["ball.left", "fallen"])
        forward.act = lambda seen: np.tile([1.0, 0, 0], (*seen.shape[:-1], 1))
        scores = []
        for pool, moved in (([selfplay.Player("zero actions")], "learner"), ([selfplay.Player("forward", forward)], "other")):
            games = selfplay.Games("Match1v1", 2, pool, lambda opponent, score: scores.append(score), seconds=4)
            games.seed(1)
            first = games.reset()
            for _ in range(19):
                last, _, done, _ = games.step(np.tile([float(moved == "learner"), 0, 0], (2, 1)))
            opponent = games.observation_names.index("opponent1.forward")
            truth = games.matches._connection.truth[:, 0].reshape(2, 2)  # x of left and right
            games.step(np.zeros((2, 3)))
            games.close()
            with self.subTest(moved):
                self.assertTrue((last[:, opponent] < first[:, opponent] - 0.01).all())
                left_learner, right_learner = truth
                mover = (left_learner[0], -right_learner[1]) if moved == "learner" else (-left_learner[1], right_learner[0])
                stander = (-left_learner[1], right_learner[0]) if moved == "learner" else (left_learner[0], -right_learner[1])
                self.assertTrue((np.array(mover) > np.array(stander) + 1).all())
        self.assertEqual(scores, [0.5] * 4)
        with self.assertRaisesRegex(RoboNewbieError, "walker observes gyro.left, which robots of this task do not"):
            selfplay.Player("walker", mock.Mock(inputs=["gyro.left"])).act(first, games.observation_names)

    def test_ratings_follow_the_results_and_zero_actions_stay(self):
        learner, other, zero = (selfplay.Player(name) for name in ("the policy", "x.policy", "zero actions"))
        for _ in range(20):
            selfplay.rate(learner, other, 1)
            selfplay.rate(other, zero, 0.5)

        self.assertGreater(learner.elo, other.elo + 50)
        self.assertEqual((zero.elo, zero.drawn, learner.won, other.lost), (1000, 20, 20, 20))

    def test_recurrent_opponent_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "memory.policy")
            file.write_text("policy 1 Match1v1\nlayer 1 1 linear gru\n1 1 1 1\n1 1 1 1\n1 1 1 1\n", encoding="utf-8")
            with self.assertRaisesRegex(RoboNewbieError, "is recurrent"):
                selfplay.played(selfplay.Player("memory"), file)

    def test_trains_freezes_snapshots_and_resumes(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.multiple(selfplay, ENOUGH=0.4, GAMES=4), contextlib.redirect_stdout(io.StringIO()) as told:
            out = Path(folder, "my.policy")
            words = ["Match1v1", "--n-envs", "4", "--n-steps", "8", "--batch-size", "16", "--net-arch", "4", "--option", "seconds=1", "--out", str(out)]
            selfplay.main([*words, "--total-timesteps", "64", "--n-eval-episodes", "2"])
            self.assertEqual({file.name for file in Path(folder, "my.policy.pool").iterdir()}, {"32.policy", "64.policy"})
            self.assertRegex(told.getvalue(), r"against zero actions: won 0, drawn 2, lost 0\n.*\nagainst .*my.policy.pool.64.policy: won 0, drawn 2, lost 0\n$")
            before = _ratings(out)
            selfplay.main([*words, "--total-timesteps", "128", "--resume", "--n-eval-episodes", "0"])

            after = _ratings(out)
            self.assertEqual(list(after)[:4], list(before))
            self.assertGreater(int(after["the policy"]["drawn"]), int(before["the policy"]["drawn"]))
            self.assertEqual(float(after["zero actions"]["elo"]), 1000)
            self.assertTrue(re.match("policy 1 Match1v1\n# learned by: python -m robonewbie.selfplay Match1v1 ", out.read_text(encoding="utf-8")))


def _ratings(out):
    with open(f"{out}.elo.csv", newline="", encoding="utf-8") as file:
        return {row["player"]: row for row in csv.DictReader(file)}


if __name__ == "__main__":
    unittest.main()
