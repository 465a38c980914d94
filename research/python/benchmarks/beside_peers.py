"""Compares the speed of RoboNewbie, MuJoCo and Gymnasium, measured in turn: ``python research/python/benchmarks/beside_peers.py``.

Needs ``pip install ./research/python "gymnasium[mujoco]"``. All values are processor time in microseconds, summed over all
processes. Other load on the machine affects them less than it affects elapsed time, and affects all rows alike. The result is the median
over the rounds.
"""

import argparse
import json
import os
import statistics
import subprocess
import time
from pathlib import Path

import gymnasium
import mujoco
import numpy as np

import robonewbie
from robonewbie import simulator

HERE = Path(__file__).resolve().parent
ROBOTS = 64
CYCLE_SECONDS = 0.02
LIMBS = {"he": 2, "lae": 4, "lle": 6, "rle": 6, "rae": 4}  # in the order of the Java enum Joint


def spent(process=None):
    """Returns the processor time used so far by this process, plus that of another one if given, in seconds."""
    own = time.process_time_ns() / 1e9
    if process is None:
        return own
    fields = Path(f"/proc/{process}/stat").read_text(encoding="ascii").rsplit(")", 1)[1].split()
    return own + (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def mujoco_steps(integrator, timestep, steps=12_000):
    """Returns the time that MuJoCo needs for 20 ms of its humanoid, whose joints keep moving, most of the time on the ground."""
    path = Path(gymnasium.__file__).parent / "envs" / "mujoco" / "assets" / "humanoid.xml"
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.integrator, model.opt.timestep = integrator, timestep
    data = mujoco.MjData(model)
    actions = np.random.default_rng(1).uniform(-0.4, 0.4, (steps, model.nu))
    before = spent()
    for i, action in enumerate(actions):
        if i % 400 == 0:
            mujoco.mj_resetData(model, data)
        data.ctrl[:] = action
        mujoco.mj_step(model, data)
    return (spent() - before) * 1e6 / steps * CYCLE_SECONDS / timestep


def mujoco_nao(steps=20_000):
    """Returns the time that MuJoCo needs for 20 ms of the exported NAO, which moves like the robot in TrialSpeed.java."""
    model = mujoco.MjModel.from_xml_path(robonewbie.model_path("nao0"))
    data = mujoco.MjData(model)
    names = [f"{limb}{i + 1}" for limb, count in LIMBS.items() for i in range(count)]
    motors = [model.actuator(name).id for name in names]
    joints = np.arange(model.nu)
    substeps = round(CYCLE_SECONDS / model.opt.timestep)
    before = spent()
    for i in range(steps):
        if i % 250 == 0:
            mujoco.mj_resetData(model, data)
        data.ctrl[motors] = np.radians(10 * np.cos((i + 1) / 8 + joints))
        mujoco.mj_step(model, data, substeps)
    return (spent() - before) * 1e6 / steps


def humanoid(steps=2000):
    """Returns the time that Gymnasium's Humanoid-v5 needs for 20 ms with random actions."""
    env = gymnasium.make("Humanoid-v5")
    env.reset(seed=1)
    env.action_space.seed(1)
    seconds = env.unwrapped.dt
    before = spent()
    for _ in range(steps):
        _, _, over, late, _ = env.step(env.action_space.sample())
        if over or late:
            env.reset()
    used = spent() - before
    env.close()
    return used * 1e6 / steps * CYCLE_SECONDS / seconds


def robots(task, sway, steps=250, warm_up=2000):
    """Returns the time per robot for a step of 64 robots through Python; ``sway`` is the largest action."""
    env = gymnasium.make_vec(f"RoboNewbie/{task}-v1", num_envs=ROBOTS)
    env.reset(seed=1)
    random = np.random.default_rng(1)
    process = simulator._process.process.pid
    java = _java_below(process)

    def act(count):
        for _ in range(count):
            env.step(random.uniform(-sway, sway, env.action_space.shape).astype(np.float32))

    act(warm_up)
    before = spent(java)
    act(steps)
    used = spent(java) - before
    env.close()
    return used * 1e6 / steps / ROBOTS


def _java_below(process):
    """Returns the Java process, which the launcher may have started as its child."""
    children = Path(f"/proc/{process}/task/{process}/children").read_text(encoding="ascii").split()
    return _java_below(int(children[0])) if children else process


def java(*words):
    """Runs a command of RoboNewbie and returns what it prints."""
    return subprocess.run([*simulator._command(), *words], capture_output=True, text=True, check=True).stdout


def trial():
    """Returns the times for a step and a reset without Python."""
    return json.loads(java("run", str(HERE / "TrialSpeed.java")))


def measure():
    """Measures one round; yields the name and the value of each row."""
    yield "MuJoCo's mj_step, Humanoid, RK4 of 3 ms", mujoco_steps(mujoco.mjtIntegrator.mjINT_RK4, 0.003)
    yield "the same, Euler of 5 ms", mujoco_steps(mujoco.mjtIntegrator.mjINT_EULER, 0.005)
    yield "MuJoCo's mj_step, our NAO, 4 steps of 5 ms", mujoco_nao()
    alone = trial()
    yield "engine: one moving robot, no camera", alone["step"]
    yield "Gymnasium's Humanoid-v5, random actions", humanoid()
    yield "through Python: 64 robots on their feet, moving", robots("Walk", 0.05)
    yield "through Python: 64 robots, random actions with falls", robots("Walk", 1)
    yield "reset to a settled start", alone["reset"]


def main(words=None):
    """Runs the measurements and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, help="how often all is measured (3)")
    wanted = parser.parse_args(words)
    rows = {}
    for _ in range(wanted.rounds):
        for name, figure in measure():
            rows.setdefault(name, []).append(figure)
    print("| per 20 ms, processor time | µs, median | of the rounds |\n|---|---|---|")
    for name, figures in rows.items():
        print(f"| {name} | {statistics.median(figures):.0f} | {', '.join(f'{figure:.0f}' for figure in figures)} |")


if __name__ == "__main__":
    main()
