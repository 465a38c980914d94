"""Finds and starts the simulator, and talks to it. The messages are described in docs/gym-protocol.md."""

import atexit
import json
import os
import shutil
import socket
import struct
import subprocess
import threading
from pathlib import Path

import numpy as np

SKIP, STEP, RESET = 0, 1, 2
_START_SECONDS = 600  # the first start builds the program


class RoboNewbieError(RuntimeError):
    """Something is wrong; the text says what to do."""


def _launcher_in(folder):
    launcher = folder / ("robonewbie.cmd" if os.name == "nt" else "robonewbie")
    return launcher if launcher.is_file() and (folder / "mvnw").is_file() else None


def _command():
    """Finds the program: ROBONEWBIE names the launcher or the jar; else it is looked for."""
    wanted = os.environ.get("ROBONEWBIE")
    if wanted:
        path = Path(wanted).expanduser()
        if path.is_dir():
            path = _launcher_in(path) or path
        if not path.is_file():
            raise RoboNewbieError(
                f"The environment variable ROBONEWBIE is \"{wanted}\", where there is no program. "
                "Set it to the folder of RoboNewbie, its launcher or robonewbie.jar."
            )
        return [_java(), "-XX:+UseParallelGC", "-jar", str(path)] if path.suffix == ".jar" else [str(path)]
    home = Path(__file__).with_name("home.txt")
    folders = [Path(home.read_text(encoding="utf-8"))] if home.is_file() else []
    folders += [*Path(__file__).resolve().parents, Path.cwd(), *Path.cwd().parents]
    for folder in folders:
        if _launcher_in(folder):
            return [str(_launcher_in(folder))]
    raise RoboNewbieError(
        "RoboNewbie was not found. Set the environment variable ROBONEWBIE to its folder or to robonewbie.jar, "
        "or install this package again from there: pip install ./python"
    )


def _java():
    home = os.environ.get("JAVA_HOME")
    java = shutil.which("java", path=str(Path(home, "bin")) if home else None) or shutil.which("java")
    if not java:
        raise RoboNewbieError("Java was not found. Install a JDK 17 or newer, for example from https://adoptium.net")
    return java


class _Process:
    """The simulator, which serves all environments of this Python program and ends with it."""

    def __init__(self):
        command = _command() + ["gym"]
        try:
            self.process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, start_new_session=os.name != "nt"
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
                f"The simulator ended at once with exit code {code}; its messages stand above. "
                f"Does this work in a terminal? {' '.join(command)} --help"
            )
        watchdog.cancel()

    def is_running(self):
        return self.process.poll() is None

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


def _running_process():
    """One simulator is enough for all environments; after a fork the child starts its own."""
    global _process, _owner
    with _lock:
        if _process is None or _owner != os.getpid() or not _process.is_running():
            _process, _owner = _Process(), os.getpid()
        return _process


@atexit.register
def _stop():
    if _process is not None and _owner == os.getpid():
        _process.stop()


class Connection:
    """Some environments of one task in the simulator."""

    def __init__(self, task, count, reward=""):
        self._socket = socket.create_connection(("127.0.0.1", _running_process().port))
        self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        try:
            order = f"{task}\nreward={reward}" if reward else task
            self.description = json.loads(self._ask(b"M" + struct.pack("<i", count) + order.encode("utf-8")))
        except RoboNewbieError:
            self.close()
            raise
        self._orders = np.zeros(
            count,
            dtype=[("what", "u1"), ("seed", "<i8"), ("action", "<f8", (len(self.description["action"]),))],
        )
        self._answer = np.dtype(
            [("observation", "<f8", (len(self.description["observation"]),)), ("reward", "<f8"), ("over", "?")]
        )

    def act(self, what, seeds, actions):
        """Lets environments step, begin anew or wait; gives observations, rewards and whether they are over."""
        self._orders["what"] = what
        self._orders["seed"] = seeds
        self._orders["action"] = actions
        answer = np.frombuffer(self._ask(b"A" + self._orders.tobytes()), dtype=self._answer)
        return answer["observation"].astype(np.float32), answer["reward"].copy(), answer["over"].copy()

    def _ask(self, message):
        try:
            self._socket.sendall(struct.pack("<i", len(message)) + message)
            (length,) = struct.unpack("<i", self._receive(4))
            reply = self._receive(length)
        except OSError as broken:
            raise RoboNewbieError(
                f"The connection to the simulator broke ({broken}). Make the environment again."
            ) from broken
        if reply[0]:
            raise RoboNewbieError(reply[1:].decode("utf-8"))
        return reply[1:]

    def _receive(self, length):
        data = bytearray(length)
        view = memoryview(data)
        while view:
            count = self._socket.recv_into(view)
            if not count:
                raise OSError("it was closed at the other end")
            view = view[count:]
        return bytes(data)

    def close(self):
        self._socket.close()
