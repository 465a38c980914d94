"""Client of the simulator, which it finds and starts. docs/gym-protocol.md describes the messages."""

import atexit
import contextlib
import json
import os
import re
import shutil
import socket
import struct
import subprocess
import tempfile
import threading
import uuid
from pathlib import Path

import numpy as np

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

SKIP, STEP, RESET, STEP_AND_RESET = 0, 1, 2, 3
TERMINATED, TRUNCATED = 1, 2
_ADVANCE = 2  # the simulator's request to compute the physics of a cycle
_START_SECONDS = 600  # the first start builds the program
_TIMEOUT_SECONDS = 60
_MIN_JAVA = 17
_HOW_TO_GET_JAVA = (
    "Install Java 17 or newer, for example from https://adoptium.net; if it is already installed, set JAVA_HOME to its folder."
)


class RoboNewbieError(RuntimeError):
    """Error with instructions for the user."""


def _launcher_in(folder):
    launcher = folder / ("robonewbie.cmd" if os.name == "nt" else "robonewbie")
    return launcher if launcher.is_file() and (folder / "mvnw").is_file() else None


def _command():
    """Returns the command that starts the program: the launcher or jar that ROBONEWBIE names, or else one in the usual locations."""
    named = os.environ.get("ROBONEWBIE")
    if named:
        path = Path(named).expanduser()
        if path.is_dir():
            path = _launcher_in(path) or path
        if not path.is_file():
            raise RoboNewbieError(
                f"The environment variable ROBONEWBIE is \"{named}\", which is not a program. "
                "Set it to the folder of RoboNewbie, its launcher or robonewbie.jar."
            )
        return _command_for_jar(path) if path.suffix == ".jar" else [str(path)]
    jar = Path(__file__).with_name("robonewbie.jar")
    if jar.is_file():
        return _command_for_jar(jar)
    home = Path(__file__).with_name("home.txt")
    folders = [Path(home.read_text(encoding="utf-8"))] if home.is_file() else []
    folders += [*Path(__file__).resolve().parents, Path.cwd(), *Path.cwd().parents]
    for folder in folders:
        if _launcher_in(folder):
            return [str(_launcher_in(folder))]
    raise RoboNewbieError(
        "RoboNewbie was not found. Set the environment variable ROBONEWBIE to its folder or to robonewbie.jar, "
        "or install this package again from there: pip install ./research/python"
    )


def _command_for_jar(jar):
    return [_java(), "-XX:+UseParallelGC", "-jar", str(jar)]


def _java():
    home = os.environ.get("JAVA_HOME")
    java = shutil.which("java", path=str(Path(home, "bin")) if home else None) or shutil.which("java")
    if not java:
        raise RoboNewbieError(f"Java was not found. {_HOW_TO_GET_JAVA}")
    output = subprocess.run([java, "-version"], capture_output=True, text=True).stderr
    version = re.search(r'version "(?:1\.)?(\d+)', output)
    if not version or int(version.group(1)) < _MIN_JAVA:
        found = version.group(1) if version else "does not start"
        raise RoboNewbieError(f"Java {_MIN_JAVA} or newer is needed. Found: {java} ({found}). {_HOW_TO_GET_JAVA}")
    return java


def _environment():
    """Returns environment variables with a UTF-8 locale, which Java uses to decode file names; ``None`` if the current ones suffice."""
    if os.name == "nt":
        return None
    try:
        charmap = subprocess.run(["locale", "charmap"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    except OSError:
        charmap = ""
    return None if charmap.strip() == "UTF-8" else {**os.environ, "LC_ALL": "C.UTF-8"}


class _Process:
    """Process of the simulator, which serves all environments of this Python program and ends with it."""

    def __init__(self):
        command = _command() + ["gym"]
        try:
            self.process = subprocess.Popen(
                command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
                start_new_session=os.name != "nt",
                env=_environment(),
            )
        except OSError as wrong:
            raise RoboNewbieError(f"The simulator cannot be started with {command[0]}: {wrong}") from wrong
        watchdog = threading.Timer(_START_SECONDS, self.process.kill)
        watchdog.daemon = True
        watchdog.start()
        for line in self.process.stdout:
            if line.startswith("gym "):
                self.port = int(line.split()[1])
                break
        else:
            code = self.process.wait()
            raise RoboNewbieError(
                f"The simulator exited with code {code} during start-up; see its messages above. "
                f"Does this work in a terminal? {' '.join(command)} --help"
            )
        watchdog.cancel()

    def stop(self):
        try:
            self.process.stdin.close()
            self.process.wait(timeout=5)
        except (OSError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        self.process.stdout.close()


_process = None
_owner = None
_lock = threading.Lock()

# File with the port of the simulator. Child processes inherit its name and share the simulator.
_port_file = os.environ.setdefault(
    "ROBONEWBIE_PORT_FILE", str(Path(tempfile.gettempdir(), f"robonewbie-{uuid.uuid4().hex}"))
)


@contextlib.contextmanager
def _exclusive():
    """Excludes other threads and processes while one of them looks for the simulator or starts it."""
    with _lock, open(_port_file + ".lock", "w", encoding="ascii") as file:
        if fcntl:
            fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _connect():
    """Connects to the simulator of this program, and starts it if necessary."""
    global _process, _owner
    with _exclusive():
        try:
            port = int(Path(_port_file).read_text(encoding="ascii"))
            return socket.create_connection(("127.0.0.1", port), timeout=_TIMEOUT_SECONDS / 2)
        except (OSError, ValueError):
            _process, _owner = _Process(), os.getpid()
            Path(_port_file).write_text(str(_process.port), encoding="ascii")
            return socket.create_connection(("127.0.0.1", _process.port), timeout=_TIMEOUT_SECONDS / 2)


@atexit.register
def _stop():
    if _process is not None and _owner == os.getpid():
        _process.stop()
        for file in (_port_file, _port_file + ".lock"):
            Path(file).unlink(missing_ok=True)


def _lines(options):
    """Formats options as lines of a request; a pair is a range."""
    return [f"{name}={_text(name, value)}" for name, value in options.items()]


def _text(name, value):
    try:
        if isinstance(value, (tuple, list)):
            low, high = value
            return f"{float(low)!r}..{float(high)!r}"
        return repr(float(value))
    except (TypeError, ValueError):
        raise RoboNewbieError(
            f'The option "{name}" is {value!r}. Pass a number, or a pair of numbers such as (0.5, 2) for a range.'
        ) from None


class Connection:
    """Connection to the simulator's environments for one task.

    :param physics: computes the physics instead of the simulator, see :class:`robonewbie.mujoco.Physics`
    """

    def __init__(self, task, count, reward="", options=None, physics=None):
        self._physics = physics
        self._socket = _connect()
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            request = "\n".join([task, f"reward={reward}", *_lines(options or {})])
            self.description = json.loads(self._ask((b"X" if physics else b"M") + struct.pack("<i", count) + request.encode("utf-8")))
        except RoboNewbieError:
            self.close()
            raise
        rows = count * len(self.description["robots"])
        actions, quantities = len(self.description["action"]), len(self.description["observation"])
        self._requests = np.zeros(rows, dtype=[("what", "u1"), ("seed", "<i8"), ("action", "<f4", (actions,))])
        self.truth_names = self.description["truth"]
        self._answer = np.dtype(
            [
                ("observation", "<f4", (quantities,)),
                ("reward", "<f8"),
                ("truth", "<f8", (len(self.truth_names),)),
                ("true_state", "<f4", (len(self.description["trueState"]),)),
                ("state", "u1"),
            ]
        )
        self.truth = np.zeros((rows, len(self.truth_names)))
        self.true_state = np.zeros((rows, len(self.description["trueState"])), dtype=np.float32)
        self.state = np.zeros(rows, dtype=np.uint8)
        self.fresh = np.zeros((0, quantities), dtype=np.float32)

    def act(self, what, seeds, actions):
        """Steps, resets or skips environments; returns observations, rewards, and whether each episode is terminated.

        Sets ``state`` to TERMINATED, TRUNCATED or 0, and ``fresh`` to the initial observations of the environments reset after their step.
        """
        self._requests["what"] = what
        self._requests["seed"] = seeds
        self._requests["action"] = actions
        reply = self._ask(b"A" + self._requests.tobytes())
        answer = np.frombuffer(reply, dtype=self._answer, count=len(self._requests))
        self.truth, self.true_state, self.state = answer["truth"], answer["true_state"], answer["state"]
        fresh = np.frombuffer(reply, dtype="<f4", offset=len(self._requests) * self._answer.itemsize)
        self.fresh = fresh.reshape(-1, self._answer["observation"].shape[0])
        return answer["observation"].copy(), answer["reward"].copy(), self.state == TERMINATED

    def infos(self):
        """Returns a dictionary of the true state for each robot; with the option ``true_state``, it contains the complete vector."""
        infos = [dict(zip(self.truth_names, row)) for row in self.truth.tolist()]
        if self.description["trueState"]:
            for info, row in zip(infos, self.true_state):
                info["true_state"] = row.copy()
        return infos

    def change(self, options):
        """Sets the options for all following episodes."""
        self._ask(b"C" + "\n".join(_lines(options)).encode("utf-8"))

    def play(self, policy):
        """Sets the policy of all following episodes from the text of its file: the robot walks with its gait, if it has one."""
        self._ask(b"L" + policy.encode("utf-8"))

    def picture(self, index):
        """Returns the positions of limbs and ball in one environment."""
        return json.loads(self._ask(b"P" + struct.pack("<i", index)))

    def show(self, index):
        """Opens the studio with one environment, which then runs in real time.

        Returns the one-time address of its page, and the address of a file that redirects to the page.
        """
        address, file = self._ask(b"V" + struct.pack("<i", index)).decode("utf-8").split("\n")
        self._socket.settimeout(None)  # the page may pause the simulation
        return address, file

    def _ask(self, message):
        if self._socket.fileno() < 0:
            raise RoboNewbieError("The environment is closed. Create it again.")
        try:
            reply = self._exchange(message)
            while reply[0] == _ADVANCE:
                reply = self._exchange(self._physics.advance(reply[1:]))
        except TimeoutError as silent:
            self.close()
            raise RoboNewbieError(
                f"The simulator has not answered for {_TIMEOUT_SECONDS} s. Has it been stopped, or is the computer overloaded? "
                "Create the environment again."
            ) from silent
        except OSError as broken:
            raise RoboNewbieError(
                f"The connection to the simulator was lost ({broken}). Create the environment again."
            ) from broken
        if reply[0]:
            raise RoboNewbieError(reply[1:].decode("utf-8"))
        return reply[1:]

    def _exchange(self, message):
        self._socket.sendall(struct.pack("<i", len(message)) + message)
        (length,) = struct.unpack("<i", self._receive(4))
        return self._receive(length)

    def _receive(self, length):
        data = bytearray(length)
        view = memoryview(data)
        while view:
            try:
                count = self._socket.recv_into(view)
            except TimeoutError:  # after this program has been suspended (Ctrl+Z), the timeout expires immediately
                count = self._socket.recv_into(view)
            if not count:
                raise OSError("the simulator closed it")
            view = view[count:]
        return bytes(data)

    def close(self):
        self._socket.close()
