"""Writes episodes in LeRobot's data set format, version 3 (needs ``pip install pyarrow pandas``).

Rollouts of an environment:

>>> env = RecordEpisodes(gymnasium.make("RoboNewbie/Walk-v1"), "walks", task="Walk ahead.")
>>> # run a policy in env
>>> env.close()

Data sets of ``robonewbie record``: ``python -m robonewbie.lerobot dataset games``. Each robot in each run becomes an episode. The
reward is 1 for a goal by the robot's team, and -1 for a goal by the other team.
"""

import json
import sys
from collections import defaultdict
from pathlib import Path

import gymnasium
import numpy as np
import pandas as pd
import pyarrow as pa
import pyarrow.parquet as pq

from robonewbie import parquet

FRAMES_PER_SECOND = 50
_FRAMES_PER_FILE = 100_000
_FILE = "chunk-{chunk:03d}/file-{file:03d}.parquet"
_FILES_PER_CHUNK = 1000


class EpisodeWriter:
    """Writes episodes to a folder. Files are written atomically; ``meta/info.json`` is written by ``close``."""

    def __init__(self, folder, observation_names, action_names, frames_per_second=FRAMES_PER_SECOND):
        self._folder = Path(folder)
        if self._folder.exists() and any(self._folder.iterdir()):
            raise FileExistsError(f"{folder} is not empty. Name another folder, or delete it first.")
        self._names = {"observation.state": list(observation_names), "action": list(action_names)}
        self._rate = frames_per_second
        self._tasks = {}
        self._episodes = []
        self._waiting = []
        self._frames = 0
        self._files = 0
        self._statistics = defaultdict(_Statistics)

    def add(self, task, observations, actions, rewards, dones):
        """Adds an episode with a row for each frame: the observation, the action, its reward, and whether it ended the episode."""
        count = len(actions)
        if not count:
            return
        columns = {
            "observation.state": np.asarray(observations, dtype=np.float32).reshape(count, -1),
            "action": np.asarray(actions, dtype=np.float32).reshape(count, -1),
            "next.reward": np.asarray(rewards, dtype=np.float32),
            "next.done": np.asarray(dones, dtype=bool),
            "timestamp": (np.arange(count) / self._rate).astype(np.float32),
            "frame_index": np.arange(count),
            "episode_index": np.full(count, len(self._episodes)),
            "index": self._frames + np.arange(count),
            "task_index": np.full(count, self._tasks.setdefault(task, len(self._tasks))),
        }
        self._waiting.append(columns)
        self._episodes.append(
            {
                "episode_index": len(self._episodes),
                "tasks": [task],
                "length": count,
                "data/chunk_index": self._files // _FILES_PER_CHUNK,
                "data/file_index": self._files % _FILES_PER_CHUNK,
                "dataset_from_index": self._frames,
                "dataset_to_index": self._frames + count,
                "meta/episodes/chunk_index": 0,
                "meta/episodes/file_index": 0,
            }
        )
        self._frames += count
        for name, values in columns.items():
            self._statistics[name].add(values)
        if sum(len(part["index"]) for part in self._waiting) >= _FRAMES_PER_FILE:
            self._write_file()

    def _write_file(self):
        columns = {name: np.concatenate([part[name] for part in self._waiting]) for name in self._waiting[0]}
        table = pa.table({name: _array(values) for name, values in columns.items()})
        path = "data/" + _FILE.format(chunk=self._files // _FILES_PER_CHUNK, file=self._files % _FILES_PER_CHUNK)
        _write(table, self._folder / path)
        self._waiting = []
        self._files += 1

    def close(self):
        """Writes the remaining frames and the metadata."""
        if self._waiting:
            self._write_file()
        meta = self._folder / "meta"
        _write(pa.Table.from_pylist(self._episodes), meta / "episodes" / _FILE.format(chunk=0, file=0))
        pd.DataFrame({"task_index": list(self._tasks.values())}, index=list(self._tasks)).to_parquet(meta / "tasks.parquet")
        stats = {name: statistics.summary() for name, statistics in self._statistics.items()}
        (meta / "stats.json").write_text(json.dumps(stats, indent=2), encoding="utf-8")
        (meta / "info.json").write_text(json.dumps(self._info(), indent=2), encoding="utf-8")

    def _info(self):
        def feature(kind, size=1, names=None):
            return {"dtype": kind, "shape": [size], "names": names}

        features = {name: feature("float32", len(names), names) for name, names in self._names.items()}
        features.update({"next.reward": feature("float32"), "next.done": feature("bool"), "timestamp": feature("float32")})
        features.update({name: feature("int64") for name in ("frame_index", "episode_index", "index", "task_index")})
        return {
            "codebase_version": "v3.0",
            "robot_type": "nao",
            "total_episodes": len(self._episodes),
            "total_frames": self._frames,
            "total_tasks": len(self._tasks),
            "chunks_size": _FILES_PER_CHUNK,
            "data_files_size_in_mb": 100,
            "video_files_size_in_mb": 200,
            "fps": self._rate,
            "splits": {"train": f"0:{len(self._episodes)}"},
            "data_path": "data/chunk-{chunk_index:03d}/file-{file_index:03d}.parquet",
            "video_path": None,
            "features": features,
        }


class _Statistics:
    """Running statistics of a column."""

    def __init__(self):
        self._count, self._sum, self._squares, self._min, self._max = 0, 0, 0, np.inf, -np.inf

    def add(self, values):
        rows = values.reshape(len(values), -1).astype(float)
        self._count += len(rows)
        self._sum = self._sum + rows.sum(axis=0)
        self._squares = self._squares + (rows**2).sum(axis=0)
        self._min = np.minimum(self._min, rows.min(axis=0))
        self._max = np.maximum(self._max, rows.max(axis=0))

    def summary(self):
        mean = self._sum / self._count
        std = np.sqrt(np.maximum(self._squares / self._count - mean**2, 0))
        numbers = {"min": self._min, "max": self._max, "mean": mean, "std": std}
        return {**{name: value.tolist() for name, value in numbers.items()}, "count": [self._count]}


def _array(values):
    if values.ndim == 1:
        return pa.array(values)
    return pa.FixedSizeListArray.from_arrays(pa.array(values.ravel()), values.shape[1])


def _write(table, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(".part")
    pq.write_table(table, part)
    part.replace(path)


class RecordEpisodes(gymnasium.Wrapper):
    """Wrapper that records all episodes of a RoboNewbie environment in a folder, which is complete after ``close``."""

    def __init__(self, env, folder, task="", frames_per_second=None):
        super().__init__(env)
        inner = env.unwrapped
        rate = frames_per_second or round(FRAMES_PER_SECOND / getattr(inner, "cycles", 1))
        self._writer = EpisodeWriter(folder, inner.observation_names, inner.action_names, rate)
        self._task = task or getattr(env.spec, "id", None) or type(inner).__name__
        self._rows = []
        self._last = None

    def reset(self, **keywords):
        self._end()
        self._last, info = self.env.reset(**keywords)
        return self._last, info

    def step(self, action):
        observation, reward, terminated, truncated, info = self.env.step(action)
        self._rows.append((self._last, np.array(action), reward, terminated or truncated))
        self._last = observation
        return observation, reward, terminated, truncated, info

    def _end(self):
        if self._rows:
            self._writer.add(self._task, *zip(*self._rows))
        self._rows = []

    def close(self):
        if self._writer is not None:
            self._end()
            self._writer.close()
            self._writer = None
        super().close()


def convert(folder, target):
    """Converts a data set of ``robonewbie record`` to LeRobot's format. Missing numbers become 0."""
    folder = Path(folder)
    known = parquet.description(folder)
    of_cycles, of_events = (known["tables"][name]["columns"] for name in ("cycles", "events"))
    columns = [column["name"] for column in of_cycles if column["kind"] == "decimal"]
    actions = [name for name in columns if name.startswith("command_")]
    sensors = ("sensed_", "gyro_", "accelerometer_", "left_foot_", "right_foot_", "ball_")
    observations = [name for name in columns if name.startswith(sensors)]
    writer = EpisodeWriter(target, observations, actions)
    for file in sorted(folder.glob(known["tables"]["cycles"]["files"])):
        cycles = parquet.read(file, of_cycles).to_pandas()
        events = parquet.read(folder / "events" / file.name, of_events).to_pandas()
        for (run, team, _), rows in cycles.groupby(["run", "team", "number"], sort=True):
            goals = np.zeros(int(cycles.cycle.max()) + 1)
            of_run = events[events.run == run]
            for cycle, event in zip(of_run.cycle, of_run.event):
                if event.startswith("goal "):
                    goals[min(cycle, len(goals) - 1)] += 1 if event.endswith(f" {team}") else -1
            rewards = np.add.reduceat(goals, rows.cycle.to_numpy())[1:] if len(rows) > 1 else np.zeros(0)
            state = rows[observations].fillna(0).to_numpy()[:-1]
            done = np.arange(1, len(rows)) == len(rows) - 1
            writer.add(known["agent"], state, rows[actions].to_numpy()[1:], rewards, done)
    writer.close()


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("Usage: python -m robonewbie.lerobot FOLDER-OF-ROBONEWBIE-RECORD NEW-FOLDER")
    convert(*sys.argv[1:])
