"""The best known training settings of each task, which robonewbie.train uses unless its arguments say otherwise."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Settings:
    """Training settings for a task: the number of actions, arguments of robonewbie.train, and options of the task."""

    total_timesteps: int
    arguments: str
    options: tuple = ()

    @property
    def words(self):
        """The arguments for robonewbie.train."""
        options = [word for option in self.options for word in ("--option", option)]
        return ["--total-timesteps", str(self.total_timesteps), *self.arguments.split(), *options]


def _log_std(deviation, inputs=1):
    """Returns the initial log standard deviation for a given deviation of the actions; with gSDE, the noise from all inputs adds up."""
    return math.log(deviation / math.sqrt(inputs))


# Noise that stays constant for several actions (gSDE) makes the consequences of exploration visible. Five epochs instead of PPO's ten
# halve the time spent in Python.
_ENGINE = Settings(
    4_000_000,
    "--n-envs 512 --n-steps 32 --batch-size 4096 --n-epochs 5 --learning-rate 0.001 --gamma 0.99"
    f" --log-std-init {_log_std(0.15, 32)} --sde-sample-freq 8 --net-arch 32 32",
)
TASKS = {
    # One action, the posture of the robot, lasts the whole episode. Cycles after a fall count too.
    "Stand": Settings(
        80_000,
        "--n-envs 512 --n-steps 4 --batch-size 1024 --n-epochs 5 --learning-rate 0.005 --gamma 1 --gae-lambda 1"
        f" --log-std-init {_log_std(0.2)} --net-arch --inputs gyro.(forward|left)",
        ("cycles=500",),
    ),
    "EngineFollow": _ENGINE,
    "EngineRun": _ENGINE,
    "KickTo": Settings(
        300_000,
        "--n-envs 256 --n-steps 60 --batch-size 3840 --n-epochs 5 --learning-rate 0.001 --gamma 1"
        f" --log-std-init {_log_std(0.06, 32)} --sde-sample-freq 60 --net-arch 32 32 --inputs command.*|motion.*",
        ("cycles=5",),
    ),
    "QuickGetUp": Settings(
        1_000_000,
        "--n-envs 256 --n-steps 100 --batch-size 6400 --n-epochs 5 --learning-rate 0.001 --gamma 0.99"
        f" --log-std-init {_log_std(0.1, 9)} --sde-sample-freq 100 --net-arch"
        " --inputs motion.*|gyro.left|accelerometer.(forward|up)",
        ("cycles=2", "friction=0.5..2", "mass=0.9..1.1"),
    ),
    # Stable-Baselines3's own settings but for the number of steps and the batch size; the task does the rest.
    "Walk": Settings(
        4_000_000,
        "--n-envs 128 --n-steps 64 --batch-size 512 --n-epochs 10 --learning-rate 0.0003 --gamma 0.99 --log-std-init 0 --symmetric",
        ("cycles=2", "delay=0..1", "friction=0.8..1.2", "mass=0.95..1.05", "noise=0..0.5"),
    ),
}

# Matches, which robonewbie.selfplay trains.
MATCHES = {
    "Match1v1": Settings(
        920_000,
        "--n-envs 64 --n-steps 32 --batch-size 256 --n-epochs 10 --learning-rate 0.001 --gamma 0.99"
        f" --log-std-init {_log_std(0.6)} --net-arch 32 32 --symmetric",
        ("seconds=60",),
    ),
}
