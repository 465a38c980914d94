"""Trains a policy for matches by PPO against a pool of policies: zero actions, policy files, and frozen snapshots of itself.

    python -m robonewbie.selfplay Match1v1
    python -m robonewbie.selfplay Match1v1 --opponent other.policy --total-timesteps 2000000 --resume

Arguments and files are those of robonewbie.train. Each match draws its opponent from the pool. When the policy scores enough in its last
matches, a snapshot of it joins the pool, as a file in the folder TASK.policy.pool. TASK.policy.elo.csv has the Elo ratings from all matches
played, where zero actions have 1000. At the end, the policy plays 100 new matches against each of the pool.
"""

from __future__ import annotations

import csv
import dataclasses
from collections import deque
from pathlib import Path
from typing import Any

import numpy as np

from robonewbie import train
from robonewbie.evaluate import FIRST_SEED, PlayedPolicy
from robonewbie.matches import Matches
from robonewbie.network import Gru
from robonewbie.sb3 import SharedVecEnv
from robonewbie.settings import MATCHES
from robonewbie.simulator import RoboNewbieError

ZERO = "zero actions"
FIRST_ELO = 1000
ELO_STEP = 4
GAMES = 100
ENOUGH = 0.65  # mean score of the last matches for which a snapshot joins the pool
WIN, DRAW, LOSS = 1, 0.5, 0
COLUMNS = ("player", "elo", "won", "drawn", "lost")


@dataclasses.dataclass
class Player:
    """A policy, or None for zero actions, with its rating and the results of its matches."""

    name: str
    policy: PlayedPolicy | None = None
    elo: float = FIRST_ELO
    won: int = 0
    drawn: int = 0
    lost: int = 0

    def act(self, observation: np.ndarray, names: list[str]) -> Any:
        """Returns a row of actions for each row of observations, whose columns have the given names.

        :raises RoboNewbieError: if the policy observes something else
        """
        if not self.policy:
            return 0
        missing = [name for name in self.policy.inputs if name not in names]
        if missing:
            raise RoboNewbieError(f"{self.name} observes {', '.join(missing)}, which robots of this task do not. Choose a policy for this task.")
        return self.policy.act(observation[..., [names.index(name) for name in self.policy.inputs]])

    def count(self, score: float) -> None:
        """Counts a match: 1 if it is won, 0.5 if drawn, 0 if lost."""
        self.won += score == WIN
        self.drawn += score == DRAW
        self.lost += score == LOSS


def played(player: Player, file: Path) -> Player:
    """Gives a player the policy in a file.

    :raises RoboNewbieError: if it is recurrent
    """
    policy = PlayedPolicy(file.read_text(encoding="utf-8"))
    if any(isinstance(layer, Gru) for layer in policy.layers):
        raise RoboNewbieError(f"{file} is recurrent. Opponents are policies without a memory.")
    player.policy = policy
    return player


def rate(player: Player, opponent: Player, score: float) -> None:
    """Moves both ratings by a match (A. Elo, The Rating of Chessplayers, 1978); that of zero actions is the zero point and stays."""
    expected = 1 / (1 + 10 ** ((opponent.elo - player.elo) / 400))
    player.elo += ELO_STEP * (score - expected)
    if opponent.name != ZERO:
        opponent.elo -= ELO_STEP * (score - expected)
    player.count(score)
    opponent.count(1 - score)


class Games(SharedVecEnv):
    """Matches as an environment of Stable-Baselines3: one team learns, the left one in every other match, and a player of the pool is the other.

    ``on_result`` is called with the opponent and the score of each match that is over. The robots of a team are successive rows.
    """

    def __init__(self, task: str, num_matches: int, pool: list[Player], on_result: Any, seed: int = 0, **options: Any) -> None:
        self.matches = Matches(task, num_matches, **options)
        self.pool, self._on_result = pool, on_result
        self._random = np.random.default_rng(seed)
        agents = self.matches.agents
        sides = [[i for i, agent in enumerate(agents) if agent.startswith("left") == left] for left in (True, False)]
        if len(sides[0]) != len(sides[1]):
            raise RoboNewbieError(f"The teams of {task} differ in size.")
        odd = np.arange(num_matches) % 2
        self._match = np.arange(num_matches)[:, None]
        self._own, self._other = np.array(sides)[odd], np.array(sides)[1 - odd]
        self._opponents = self._drawn(num_matches)
        for name in ("description", "observation_names", "action_names", "observation_mirror", "action_mirror", "cycles", "render_mode"):
            setattr(self, name, getattr(self.matches, name))
        super().__init__(num_matches * len(sides[0]), self.matches.observation_space(agents[0]), self.matches.action_space(agents[0]))

    def _drawn(self, count):
        return self._random.integers(len(self.pool), size=count)

    def _of(self, robots, by_agent):
        """Returns the rows of the given robots of each match."""
        return np.stack(list(by_agent.values()), axis=1)[self._match, robots]

    def _mine(self, by_agent):
        values = self._of(self._own, by_agent)
        return values.reshape(self.num_envs, *values.shape[2:])

    def reset(self):
        self._observed, _ = self.matches.reset(seed=self._seeds[: self.matches.num_matches])
        self._reset_seeds()
        return self._mine(self._observed)

    def step_async(self, actions):
        all_actions = np.zeros((self.matches.num_matches, len(self.matches.agents), self.action_space.shape[0]))
        all_actions[self._match, self._own] = actions.reshape(*self._own.shape, -1)
        for i in np.unique(self._opponents):
            met = np.flatnonzero(self._opponents == i)
            seen = self._of(self._other, self._observed)[met]
            all_actions[met[:, None], self._other[met]] = self.pool[i].act(seen, self.observation_names)
        self._actions = {agent: all_actions[:, i] for i, agent in enumerate(self.matches.agents)}

    def step_wait(self):
        self._observed, *outcome, infos = self.matches.step(self._actions)
        reward, terminated, truncated = map(self._mine, outcome)
        last, scored = (self._mine({agent: info[name] for agent, info in infos.items()}) for name in ("final_obs", "is_success"))
        done = terminated | truncated
        notes = [{} for _ in done]
        for row in np.flatnonzero(done):
            score = WIN if scored[row] else LOSS if terminated[row] else DRAW
            notes[row] = {"terminal_observation": last[row], "TimeLimit.truncated": not terminated[row], "score": score}
            match, number = divmod(row, self._own.shape[1])
            if number == 0:
                self._on_result(self.pool[self._opponents[match]], score)
                self._opponents[match] = self._drawn(1)[0]
        return self._mine(self._observed), reward.astype(np.float32), done, notes

    def close(self):
        self.matches.close()


class SelfPlay(train.Training):
    """Training run against a pool. Its ratings are in a table beside the policy, and the snapshots in a folder."""

    def __init__(self, wanted):
        self.out, self.folder = wanted.out, wanted.out.with_name(wanted.out.name + ".pool")
        self.learner, self.pool = Player("the policy"), [Player(ZERO)]
        self._scores = deque(maxlen=2 * GAMES)
        if wanted.resume:
            self._read_ratings()
        known = [player.name for player in self.pool]
        self.pool += [played(Player(str(file)), file) for file in wanted.opponent if str(file) not in known]
        super().__init__(wanted)

    def _robots(self):
        return Games(self.wanted.task, self.wanted.n_envs, self.pool, self._result, self.wanted.seed, **self.wanted.options)

    def _result(self, opponent, score):
        rate(self.learner, opponent, score)
        self._scores.append(score)

    def _compare_with_zero_actions(self):
        """They are in the pool."""

    def save(self):
        """Writes the policy and the checkpoint, freezes a snapshot if the policy has scored enough, and writes the ratings."""
        super().save()
        if len(self._scores) >= GAMES and np.mean(self._scores) >= ENOUGH:
            self._freeze()
        self._replace(".elo.csv", self._write_ratings)
        print("  " + ", ".join(f"{player.name} {player.elo:.0f}" for player in [self.learner, *self.pool]), flush=True)

    def _freeze(self):
        self.folder.mkdir(exist_ok=True)
        file = self.folder / f"{self.model.num_timesteps}.policy"
        file.write_text(self.text(), encoding="utf-8")
        self.pool.append(played(Player(str(file), elo=self.learner.elo), file))
        self._scores.clear()

    def _write_ratings(self, file):
        rows = [dataclasses.astuple(dataclasses.replace(player, policy=None)) for player in [self.learner, *self.pool]]
        lines = [COLUMNS, *([name, f"{elo:.1f}", *games] for name, _, elo, *games in rows)]
        file.write("".join(",".join(map(str, line)) + "\n" for line in lines).encode("utf-8"))

    def _read_ratings(self):
        with open(self._beside(".elo.csv"), newline="", encoding="utf-8") as file:
            for row in csv.DictReader(file):
                games = {name: int(row[name]) for name in COLUMNS[2:]}
                player = Player(row["player"], None, float(row["elo"]), **games)
                if player.name == self.learner.name:
                    self.learner = player
                elif player.name == ZERO:
                    self.pool[0] = player
                else:
                    self.pool.append(played(player, Path(player.name)))


def play(task: str, policy: PlayedPolicy, opponent: Player, games: int = GAMES, first_seed: int = FIRST_SEED, **options: Any) -> Player:
    """Plays new matches, half of them from each side, and returns a player with the results of the policy."""
    result, ended = Player("the policy", policy), np.zeros(games, dtype=bool)
    robots = Games(task, games, [opponent], lambda _, score: None, **options)
    robots.seed(first_seed)
    observation = robots.reset()
    mates = robots.num_envs // games
    while not ended.all():
        robots.step_async(result.act(observation, robots.observation_names))
        observation, _, done, notes = robots.step_wait()
        for match in np.flatnonzero(done[::mates]):
            if not ended[match]:
                ended[match] = True
                result.count(notes[match * mates]["score"])
    robots.close()
    return result


def main(words: list[str] | None = None) -> None:
    """Runs the command line."""
    parser = train.argument_parser("selfplay", MATCHES, GAMES)
    parser.add_argument("--opponent", type=Path, action="append", default=[], metavar="FILE", help="policy file that joins the pool")
    training = train.trained(SelfPlay, train.arguments(words, parser, MATCHES))
    wanted = training.wanted
    if wanted.n_eval_episodes > 0:
        policy = PlayedPolicy(wanted.out.read_text(encoding="utf-8"))
        for opponent in training.pool:
            result = play(wanted.task, policy, opponent, wanted.n_eval_episodes, **wanted.options)
            print(f"against {opponent.name}: won {result.won}, drawn {result.drawn}, lost {result.lost}", flush=True)


if __name__ == "__main__":
    main()
