"""Fits motors and contacts of the exported NAO to recordings of a real rcssserver3d, and prints what is left between the worlds.

    python fit_mujoco.py              a table of the errors of the exported model, beside those of a model that is not fitted
    python fit_mujoco.py --search     search for better parameters, about ten minutes; continues where it was interrupted

Each recording is replayed command by command in MuJoCo. Errors are root mean squares over all cycles: of the joint angles in degrees, of the
torso's position in millimetres and of its tilt in degrees.
"""

import argparse
import gzip
import json
import re
import subprocess
import tempfile
from pathlib import Path

import mujoco
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
RECORDINGS = ROOT / "workshop/src/main/resources/org/robonewbie/workshop/fidelity/recordings"
STATE = Path("fit_mujoco.json")
CYCLE_SECONDS = 0.02
COMMAND = re.compile(r"\((\w+) (-?[\d.]+)\)")
KINDS = {"b": "standing", "c": "single joints", "d": "falls", "h_march": "marching", "h_squat": "squatting", "h_reach": "reaching, lying"}
SAMPLES, BEST, ROUNDS = 16, 5, 10

# What a modeller would write down before looking at any recording.
UNFITTED = {"kp": 60.0, "kv": 1.0, "armature": 0.005, "damping": 0.01, "slide": 1.0, "spin": 0.005, "softness": 0.02, "impedance": 0.9}
# The search multiplies or divides a parameter by up to these factors.
RANGE = {"kp": 20.0, "kv": 20.0, "armature": 10.0, "damping": 50.0, "slide": 2.0, "spin": 20.0, "softness": 2.0, "impedance": 1.09}


def exported(**parameters):
    """Returns the text of the exported model, with the given parameters instead of its own."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "nao.xml")
        subprocess.run([ROOT / "robonewbie", "export", "--mjcf", file], check=True, stdout=subprocess.DEVNULL)
        text = file.read_text(encoding="utf-8")
    return with_parameters(text, **parameters)


def with_parameters(text, kp=None, kv=None, armature=None, damping=None, slide=None, spin=None, softness=None, impedance=None):
    if kp is None:
        return text
    text = re.sub(r'kp="[^"]*" kv="[^"]*"', f'kp="{kp}" kv="{kv}"', text)
    text = re.sub(r'<joint armature="[^"]*" damping="[^"]*"', f'<joint armature="{armature}" damping="{damping}"', text)
    contact = f'friction="{slide} {spin} 0.0001" solref="{softness} 1" solimp="{impedance} 0.99 0.001"'
    return re.sub(r'friction="[^"]*" solref="[^"]*" solimp="[^"]*"', contact, text)


def episodes(file):
    """Returns the rows of each run in a recording."""
    with gzip.open(file, "rt", encoding="utf-8") as lines:
        rows = [json.loads(line) for line in lines]
    runs = []
    for row in rows:
        if "torso" not in row:
            continue
        if not runs or row.get("i") == 0:
            runs.append([])
        runs[-1].append(row)
    return runs


class Replay:
    def __init__(self, text):
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        self.steps = round(CYCLE_SECONDS / self.model.opt.timestep)
        self.motors = {self.model.actuator(i).name: i for i in range(self.model.nu)}
        joints = [self.model.joint(i) for i in range(self.model.njnt)]
        self.addresses = {joint.name: joint.qposadr[0] for joint in joints if joint.type[0] == mujoco.mjtJoint.mjJNT_HINGE}

    def errors(self, rows):
        """Returns the squared errors of joints, position and tilt for each cycle but the first."""
        self.begin(rows[0])
        squares = []
        for before, row in zip(rows, rows[1:]):
            if "(beam" in (before["sent"] or ""):
                self.begin(row)
                continue
            for motor, speed in COMMAND.findall(before["sent"] or ""):
                if motor in self.motors:
                    self.data.ctrl[self.motors[motor]] = float(speed)
            mujoco.mj_step(self.model, self.data, self.steps)
            if self.data.warning[mujoco.mjtWarning.mjWARN_BADQACC].number:
                raise mujoco.UnexpectedError("unstable")
            squares.append(self.squares(row))
        return squares

    def begin(self, row):
        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:3] = row["torso"]["pos"]
        yaw, pitch = np.radians([row["torso"]["yaw"], -row["torso"]["pitch"]])
        turns = [np.array([np.cos(yaw / 2), 0, 0, np.sin(yaw / 2)]), np.array([np.cos(pitch / 2), 0, np.sin(pitch / 2), 0])]
        mujoco.mju_mulQuat(self.data.qpos[3:7], *turns)
        for joint, degrees in row["hj"].items():
            self.data.qpos[self.addresses[joint]] = np.radians(degrees)
        self.data.act = np.radians([row["hj"][self.model.joint(joint).name] for joint in self.model.actuator_trnid[:, 0]])
        mujoco.mj_forward(self.model, self.data)

    def squares(self, row):
        joints = [np.degrees(self.data.qpos[self.addresses[joint]]) - degrees for joint, degrees in row["hj"].items()]
        torso = self.data.body("torso")
        place = 1000 * (torso.xpos - row["torso"]["pos"])
        turn = torso.xmat.reshape(3, 3)
        tilt = np.degrees(np.arcsin(np.clip([turn[2, 0], -turn[2, 1]], -1, 1)))
        tilt -= [row["torso"]["pitch"], row["torso"]["roll"]]
        return np.mean(np.square(joints)), np.sum(np.square(place)), np.sum(np.square(tilt))


def kind_of(file):
    return next(kind for kind in KINDS if file.name.startswith(kind))


def errors_by_file(text, files):
    """Returns the root mean squares of joints, position and tilt for each recording."""
    replay = Replay(text)
    result = {}
    for file, runs in files.items():
        squares = np.concatenate([replay.errors(rows) for rows in runs if len(rows) > 1])
        result[file] = np.sqrt(np.mean(squares, axis=0))
    return result


def recordings(thinned=False):
    files = [file for file in sorted(RECORDINGS.glob("*_*.jsonl.gz")) if "f_ball" not in file.name and "asleep" not in file.name]
    runs = {file: episodes(file) for file in files}
    return {file: all_runs[:: 4 if thinned else 1] for file, all_runs in runs.items()}


def table(unfitted, fitted):
    print("| recording | joints (°) | torso (mm) | tilt (°) | joints, not fitted | torso | tilt |")
    print("|---|---|---|---|---|---|---|")
    for file in fitted:
        cells = " | ".join(f"{number:.2f}" for number in [*fitted[file], *unfitted[file]])
        print(f"| {KINDS[kind_of(file)]}: `{file.name.removesuffix('.jsonl.gz')}` | {cells} |")


def loss(text, files, reference):
    """Returns the mean logarithm of the errors in relation to those of the model that is not fitted, without lying robots."""
    try:
        errors = errors_by_file(text, files)
    except mujoco.UnexpectedError:
        return np.inf
    kinds = {}
    for file in files:
        if kind_of(file) != "h_reach":
            kinds.setdefault(kind_of(file), []).append(np.log((errors[file] + 0.01) / (reference[file] + 0.01)).mean())
    return float(np.mean([np.mean(each) for each in kinds.values()]))


def search():
    """Searches by the cross-entropy method, in the logarithms of the parameters."""
    files = recordings(thinned=True)
    text = exported()
    reference = errors_by_file(with_parameters(text, **UNFITTED), files)
    names = list(UNFITTED)
    start = np.log([UNFITTED[name] for name in names])
    width = np.log([RANGE[name] for name in names])
    state = {"round": 0, "mean": start.tolist(), "spread": (width / 2).tolist(), "best": [0, start.tolist()]}
    if STATE.exists():
        state = json.loads(STATE.read_text(encoding="utf-8"))
    for number in range(state["round"], ROUNDS):
        random = np.random.default_rng(number)
        samples = random.normal(state["mean"], state["spread"], (SAMPLES, len(names))).clip(start - width, start + width)
        samples[0] = state["best"][1]
        losses = [loss(with_parameters(text, **dict(zip(names, np.exp(each)))), files, reference) for each in samples]
        order = np.argsort(losses)
        if losses[order[0]] < state["best"][0]:
            state["best"] = [losses[order[0]], samples[order[0]].tolist()]
        good = samples[order[:BEST]]
        state |= {"round": number + 1, "mean": good.mean(axis=0).tolist(), "spread": (good.std(axis=0) * 1.1 + 0.02).tolist()}
        STATE.write_text(json.dumps(state), encoding="utf-8")
        best = {name: float(f"{value:.3g}") for name, value in zip(names, np.exp(state["best"][1]))}
        print(f"round {number + 1} of {ROUNDS}: errors {np.exp(state['best'][0]):.3f} of those before, with {best}", flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--search", action="store_true", help="search for better parameters")
    if parser.parse_args().search:
        search()
    else:
        model = exported()
        all_files = recordings()
        table(errors_by_file(with_parameters(model, **UNFITTED), all_files), errors_by_file(model, all_files))
