"""Compares the speed of RoboNewbie, MuJoCo and Gymnasium, measured in turn: ``python research/python/benchmarks/beside_peers.py``.

Needs ``pip install "./research/python[mujoco]"``. All values are processor time in microseconds, summed over all threads and
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
import mujoco.rollout
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


def humanoid_model(integrator, timestep):
    """Returns MuJoCo's humanoid."""
    path = Path(gymnasium.__file__).parent / "envs" / "mujoco" / "assets" / "humanoid.xml"
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.integrator, model.opt.timestep = integrator, timestep
    return model


def humanoid_controls(model, episodes, steps=400):
    """Returns random controls for each step of each episode."""
    return np.random.default_rng(1).uniform(-0.4, 0.4, (episodes, steps, model.nu))


def nao_controls(model, episodes, cycles=250):
    """Returns target speeds for each step of each episode: the robot moves as in TrialSpeed.java."""
    names = [f"{limb}{i + 1}" for limb, count in LIMBS.items() for i in range(count)]
    speeds = np.zeros((cycles, model.nu))
    cycle = np.arange(1, cycles + 1)[:, None]
    speeds[:, [model.actuator(name).id for name in names]] = np.radians(10 * np.cos(cycle / 8 + np.arange(model.nu)))
    return np.tile(np.repeat(speeds, round(CYCLE_SECONDS / model.opt.timestep), axis=0), (episodes, 1, 1))


def mj_step(model, controls):
    """Returns the time that MuJoCo needs for 20 ms, in episodes from the initial state, and the mean number of contacts."""
    data = mujoco.MjData(model)
    used, contacts = 0, 0
    for episode in controls:
        mujoco.mj_resetData(model, data)
        before = spent()
        for control in episode:
            data.ctrl[:] = control
            mujoco.mj_step(model, data)
            contacts += data.ncon
        used += spent() - before
    steps = controls.shape[0] * controls.shape[1]
    return used * 1e6 / steps * CYCLE_SECONDS / model.opt.timestep, contacts / steps


def rollout(model, controls):
    """Returns the time that mujoco.rollout needs for 20 ms of each episode, with a thread for each processor."""
    data = mujoco.MjData(model)
    start = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
    mujoco.mj_getState(model, data, start, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    threads = [mujoco.MjData(model) for _ in range(os.cpu_count())]
    before = spent()
    mujoco.rollout.rollout(model, threads, np.tile(start, (len(controls), 1)), controls)
    steps = controls.shape[0] * controls.shape[1]
    return (spent() - before) * 1e6 / steps * CYCLE_SECONDS / model.opt.timestep


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
    """Returns the time per robot for a cycle of 64 robots through Python; ``sway`` is the largest action, as a share of its bound."""
    env = gymnasium.make_vec(f"RoboNewbie/{task}-v1", num_envs=ROBOTS, cycles=1)
    env.reset(seed=1)
    random = np.random.default_rng(1)
    process = simulator._process.process.pid
    java = _java_below(process)

    def act(count):
        for _ in range(count):
            env.step((env.action_space.high * random.uniform(-sway, sway, env.action_space.shape)).astype(np.float32))

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


def of_mujoco(name, model, controls):
    """Yields the rows of a model in MuJoCo."""
    used, contacts = mj_step(model, controls)
    yield f"MuJoCo's `mj_step`, {name} ({contacts:.1f} contacts)", used
    yield f"`mujoco.rollout`, {name}", rollout(model, controls)


def measure():
    """Measures one round; yields the name and the value of each row."""
    for name, integrator, timestep in (
        ("RK4 of 3 ms", mujoco.mjtIntegrator.mjINT_RK4, 0.003),
        ("Euler of 5 ms", mujoco.mjtIntegrator.mjINT_EULER, 0.005),
    ):
        model = humanoid_model(integrator, timestep)
        yield from of_mujoco(f"Humanoid, {name}", model, humanoid_controls(model, 60))
    model = mujoco.MjModel.from_xml_path(robonewbie.model_path())
    yield from of_mujoco(f"our NAO, {model.opt.timestep * 1000:g} ms", model, nao_controls(model, 80))
    alone = trial()
    yield "engine: one moving robot, no camera", alone["step"]
    yield "Gymnasium's `Humanoid-v5`, random actions", humanoid()
    yield "through Python: 64 robots on their feet, moving", robots("Walk", 0.05)
    yield "through Python: 64 robots, random actions with falls", robots("Walk", 1)
    yield "reset to a settled start", alone["reset"]


def main(words=None):
    """Runs the measurements and prints the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3, help="how often all is measured (3)")
    wanted = parser.parse_args(words)
    rows, load = {}, []
    for _ in range(wanted.rounds):
        for name, figure in measure():
            rows.setdefault(name, []).append(figure)
        load.append(os.getloadavg()[0])
    print("| per 20 ms, processor time | µs, median | of the rounds |\n|---|---|---|")
    for name, figures in rows.items():
        print(f"| {name} | {statistics.median(figures):.0f} | {', '.join(f'{figure:.0f}' for figure in figures)} |")
    print(f"\nmujoco {mujoco.__version__}, Gymnasium {gymnasium.__version__}, load {min(load):.1f} to {max(load):.1f}")


if __name__ == "__main__":
    main()
