"""Data sets in the format of LeRobot, read by its own package if it is installed, else with pyarrow; skipped without pyarrow and pandas."""

import json
import tempfile
import unittest
from pathlib import Path

import gymnasium
import numpy as np

import robonewbie  # noqa: F401 registers the tasks

try:
    import pandas as pd

    from robonewbie.lerobot import EpisodeWriter, RecordEpisodes, convert
except ImportError:
    pd = None

try:
    from lerobot.datasets.lerobot_dataset import LeRobotDataset
except ImportError:
    LeRobotDataset = None


@unittest.skipUnless(pd is not None, "pyarrow or pandas is not installed")
class LeRobotTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def rolled_out(self):
        env = RecordEpisodes(gymnasium.make("RoboNewbie/Reach-v1"), self.folder / "reach", task="Bring the hand there.")
        kept = []
        for seed in (1, 2, 3):
            observation, _ = env.reset(seed=seed)
            over = False
            while not over:
                action = env.action_space.sample()
                kept.append((observation, action))
                observation, reward, terminated, truncated, _ = env.step(action)
                kept[-1] += (reward,)
                over = terminated or truncated
        env.close()
        return kept

    def test_frames_are_what_the_robot_saw_did_and_earned(self):
        kept = self.rolled_out()

        frames = pd.read_parquet(self.folder / "reach" / "data")
        episodes = pd.read_parquet(self.folder / "reach" / "meta" / "episodes")
        stats = json.loads((self.folder / "reach" / "meta" / "stats.json").read_text(encoding="utf-8"))

        np.testing.assert_array_equal(np.stack(frames["observation.state"]), [row[0] for row in kept])
        np.testing.assert_array_equal(np.stack(frames["action"]), [row[1] for row in kept])
        np.testing.assert_allclose(frames["next.reward"], [row[2] for row in kept], rtol=1e-6)
        self.assertEqual(list(np.flatnonzero(frames["next.done"])), [99, 199, 299])
        self.assertEqual(list(episodes["dataset_to_index"]), [100, 200, 300])

        slow = RecordEpisodes(gymnasium.make("RoboNewbie/Reach-v1", cycles=5), self.folder / "slow")
        slow.reset(seed=1)
        slow.step(np.zeros(4, dtype=np.float32))
        slow.close()
        info = json.loads((self.folder / "slow" / "meta" / "info.json").read_text(encoding="utf-8"))
        self.assertEqual((info["fps"], info["total_frames"]), (10, 1))
        np.testing.assert_allclose(stats["action"]["mean"], np.mean([row[1] for row in kept], axis=0), atol=1e-6)
        np.testing.assert_allclose(stats["action"]["std"], np.std([row[1] for row in kept], axis=0), atol=1e-6)

    def test_episodes_of_the_same_actions_differ_in_what_is_drawn_from_the_seed(self):
        drawn = {"friction": (0.5, 2), "mass": (0.9, 1.1), "x": (-4, 0), "heading": (-180, 180)}
        env = RecordEpisodes(gymnasium.make("RoboNewbie/GetUp-v1", **drawn), self.folder / "falls")
        places = []
        for seed in (1, 2, 1):
            _, info = env.reset(seed=seed)
            places.append((info["x"], info["heading"]))
            for _ in range(30):
                env.step(np.zeros(20, dtype=np.float32))
        env.close()

        first, second, again = (np.stack(f) for _, f in pd.read_parquet(self.folder / "falls" / "data").groupby("episode_index")["observation.state"])
        np.testing.assert_array_equal(first, again)
        self.assertGreater(np.abs(first - second).max(), 1)
        self.assertGreater(abs(places[0][0] - places[1][0]), 0.1)
        for outside in ({"x": -14}, {"ball_y": (0, 5)}):
            with self.assertRaisesRegex(robonewbie.RoboNewbieError, "is not between"):
                gymnasium.make("RoboNewbie/GetUp-v1", **outside)

    @unittest.skipUnless(LeRobotDataset, "lerobot is not installed")
    def test_lerobot_reads_it(self):
        kept = self.rolled_out()

        frames = LeRobotDataset("robonewbie/reach", root=self.folder / "reach")

        self.assertEqual((len(frames), frames.num_episodes, frames.fps), (300, 3, 50))
        np.testing.assert_array_equal(frames[150]["observation.state"].numpy(), kept[150][0])
        np.testing.assert_array_equal(frames[150]["action"].numpy(), kept[150][1])
        self.assertEqual(frames[150]["task"], "Bring the hand there.")
        self.assertTrue(bool(frames[199]["next.done"]))

    def test_recorded_games_become_episodes_of_each_robot(self):
        source = self.folder / "dataset"
        for part in ("cycles", "events"):
            (source / part).mkdir(parents=True)
        names = ["sensed_neck_yaw", "ball_distance", "command_neck_yaw", "true_neck_yaw"]
        kinds = {"run": "whole", "cycle": "whole", "team": "text", "number": "whole", "event": "text"}

        def described(name, *columns):
            return {"files": name + "/run-*.csv", "columns": [{"name": c, "kind": kinds.get(c, "decimal")} for c in columns]}

        tables = [described("cycles", "run", "cycle", "team", "number", *names), described("events", "run", "cycle", "event")]
        (source / "dataset.json").write_text(json.dumps({"agent": "Me", "tables": dict(zip(("cycles", "events"), tables))}))
        rows = [(1, cycle, team, 1, cycle, None, 10 * cycle, 0) for cycle in range(5) for team in ("A", "B")]
        rows += [(2, cycle, "A", 1, -cycle, None, 0, 0) for cycle in range(3)]
        file = "run-00001-to-00002.csv"
        pd.DataFrame(rows, columns=["run", "cycle", "team", "number", *names]).to_csv(source / "cycles" / file, index=False)
        goals = {"run": [1, 2], "cycle": [3, 1], "event": ["goal left A", "goal right B"]}
        pd.DataFrame(goals).to_csv(source / "events" / file, index=False)

        convert(source, self.folder / "games")

        frames = pd.read_parquet(self.folder / "games" / "data")
        self.assertEqual(list(frames["next.reward"]), [0, 0, 1, 0, 0, 0, -1, 0, -1, 0])
        np.testing.assert_array_equal(np.stack(frames["observation.state"])[:4], [[0, 0], [1, 0], [2, 0], [3, 0]])
        np.testing.assert_array_equal(np.stack(frames["action"])[:4, 0], [10, 20, 30, 40])
        self.assertEqual(list(np.flatnonzero(frames["next.done"])), [3, 7, 9])
        with self.assertRaisesRegex(FileExistsError, "Name another folder"):
            EpisodeWriter(self.folder / "games", [], [])


if __name__ == "__main__":
    unittest.main()
