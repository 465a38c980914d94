"""Command line: train, evaluate and play the walk of a Booster T1."""

import argparse
import sys
from pathlib import Path

SHIPPED = Path(__file__).with_name("t1-walk.policy")


def _arguments(words):
    parser = argparse.ArgumentParser(prog="python -m robonewbie.t1", description="A Booster T1 learns to walk by velocity command.")
    commands = parser.add_subparsers(dest="task", required=True)
    train = commands.add_parser("train", help="train a policy by PPO in MuJoCo")
    train.add_argument("--total-timesteps", type=int, default=4_500_000, help="total number of actions of all robots (default: 4500000)")
    train.add_argument("--n-envs", type=int, default=128, help="number of parallel robots (default: 128)")
    train.add_argument("--seed", type=int, default=1, help="seed of weights and episodes (default: 1)")
    train.add_argument("--out", type=Path, default=Path("t1-walk.policy"), help="file of the policy (default: t1-walk.policy)")
    train.add_argument("--resume", action="store_true", help="resume an interrupted training run")
    evaluate = commands.add_parser("evaluate", help="measure a policy on seeds that training does not use")
    evaluate.add_argument("policy", type=Path, nargs="?", default=SHIPPED, help="file of the policy (default: the one of this package)")
    evaluate.add_argument("--n-envs", type=int, default=64, help="number of robots of each delay (default: 64)")
    play = commands.add_parser("play", help="play a policy on a running RCSSServerMJ")
    play.add_argument("policy", type=Path, nargs="?", default=SHIPPED, help="file of the policy (default: the one of this package)")
    play.add_argument("--server", default="127.0.0.1:60000", help="HOST:PORT of the server (default: 127.0.0.1:60000)")
    play.add_argument("--seconds", type=float, default=20, help="duration (default: 20)")
    play.add_argument("--command", type=float, nargs=3, metavar=("FORWARD", "LEFT", "TURN"), help="constant command in m/s and degrees/s (default: a random one every 3 s)")
    play.add_argument("--starts", type=int, default=1, help="number of starts, each with another heading (default: 1)")
    play.add_argument("--seed", type=int, default=1, help="seed of headings and random commands (default: 1)")
    return parser.parse_args(words)


def _train(wanted):
    from .training import Training

    model = wanted.out.with_name(wanted.out.name + ".zip")
    if model.exists() and not wanted.resume:
        sys.exit(f"A training run already exists in {model}. Resume it with --resume, or choose another file with --out.")
    if wanted.resume and not model.exists():
        sys.exit(f"There is nothing to resume: {model} does not exist. Omit --resume to start a new training run.")
    Training(wanted.out, wanted.total_timesteps, wanted.n_envs, wanted.seed, wanted.resume).run()
    print(f"The policy was written to {wanted.out}.")


def _policy(file):
    from ..evaluate import PlayedPolicy

    return PlayedPolicy(file.read_text(encoding="utf-8"))


def _evaluate(wanted):
    from . import robot
    from .evaluation import report

    policy = _policy(wanted.policy)
    report(lambda observed: policy.act(observed[:, : len(robot.INPUTS)]), wanted.n_envs)


def _play(wanted):
    from .player import play

    host, _, port = wanted.server.rpartition(":")
    act, falls = _policy(wanted.policy).act, 0
    for start in range(wanted.starts):
        heading = 360 * start / wanted.starts
        walked = play(act, (host, int(port)), wanted.seconds, wanted.command, heading, [wanted.seed, start])
        falls += walked["fallen_after"] is not None
        print(f"heading {heading:3.0f}°: " + ", ".join(f"{name} {value}" for name, value in walked.items()), flush=True)
    print(f"{falls} falls in {wanted.starts} starts")


def main(words=None):
    """Runs the command line."""
    wanted = _arguments(words)
    {"train": _train, "evaluate": _evaluate, "play": _play}[wanted.task](wanted)


if __name__ == "__main__":
    main()
