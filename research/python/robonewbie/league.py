"""The NAO on RCSSServerMJ, the server of the RoboCup 3D league since 2026, for agents that speak SimSpark's protocol.

    python -m robonewbie.league install    add the robots NAO0 to NAO4 to the server that is installed in this Python environment
    python -m robonewbie.league bridge     let agents play on a running server; they connect to the bridge, by default on port 3100
"""

import argparse
import base64
import importlib.util
import math
import os
import re
import socket
import struct
import sys
import threading
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from .model import model_path

TYPES = range(5)
CYCLE_SECONDS = 0.02
MAX_TORQUE = 10
# More damping than in the exported model, where a target moves in each step of the physics; here it moves once per cycle, and without damping
# the robot falls.
STIFFNESS, DAMPING = 300, 5
# A target that runs further ahead of its joint makes the robot jerk as soon as the joint is free again.
MAX_LEAD_DEGREES = 5
MAX_MESSAGE_BYTES = 1 << 20
MAX_SPEECH_BYTES = 10  # the server drops longer ones

_MARKERS = ("head", "rlowerarm", "llowerarm", "rfoot", "lfoot")
_LANDMARKS = {
    b"l_luf": b"F1L",
    b"l_llf": b"F2L",
    b"l_ruf": b"F1R",
    b"l_rlf": b"F2R",
    b"g_lup": b"G1L",
    b"g_llp": b"G2L",
    b"g_rup": b"G1R",
    b"g_rlp": b"G2R",
}
_NUMBER = rb"(-?[\d.]+(?:e[-+]?\d+)?)"
_VECTOR = rb" ".join([_NUMBER] * 3)
_GYRO = re.compile(rb"\(GYR \(n torso_gyro\) \(rt " + _VECTOR + rb"\)\)")
_ACCELEROMETER = re.compile(rb"\(ACC \(n torso_acc\) \(a " + _VECTOR + rb"\)\)")
_TOUCH = re.compile(rb"\(TCH n (\w+) val (\d+)\)")
_HINGE = re.compile(rb"\(HJ \(n (\w+)\)\(ax " + _NUMBER + rb"\)\(vx [^)]*\)\)")
_TRUTH = re.compile(rb"\((?:pos|quat) \(n \w+\) \([pq] [^)]*\)\)")
_LANDMARK = re.compile(rb"\((\w+) \(pol [^)]*\)\)")
_MOTOR = re.compile(rb"\(([a-z]+e\d) " + _NUMBER + rb"\)")
_SCENE = re.compile(rb"\(scene (\S+?)(?: (\d))?\)")
_INIT = re.compile(rb"\(init \(unum (\d+)\) ?\(teamname ([^\s()]+)\)\)")
_BEAM = re.compile(rb"\(beam " + _VECTOR + rb"\)")
_SAY = re.compile(rb"\(say ([^\s()]+)\)")


class LeagueError(RuntimeError):
    """Error with instructions for the user."""


# ---- The robot


def server_model(kind):
    """Returns a robot type as an MJCF file for RCSSServerMJ, which expects other names and motors.

    :param kind: 0 for the standard robot, up to 4
    """
    text = Path(model_path(f"nao{kind}")).read_text(encoding="utf-8")
    root = ElementTree.fromstring(text)
    world = root.find("worldbody")
    torso = world.find("body")
    for part in list(world):
        if part is not torso:
            world.remove(part)
    name = torso.get("name")
    for element in root.iter():
        for attribute in ("site", "objname"):
            if element.get(attribute) == name:
                element.set(attribute, "torso")
    torso.set("name", "torso")
    torso.find("site").set("name", "torso")
    torso.find("geom").set("name", "torso")
    for body in torso.iter("body"):
        if body.get("name") in _MARKERS:
            ElementTree.SubElement(body, "site", name=f"{body.get('name')}-vismarker")
        if body.get("name").endswith("lowerarm"):
            body.find("geom").set("name", f"{body.get('name')[0]}forearm")  # the referee looks for this word
    root.find("default/joint").set("actuatorfrcrange", f"{-MAX_TORQUE} {MAX_TORQUE}")
    _take_over_contacts(root)
    _replace_motors(root.find("actuator"))
    ElementTree.indent(root)
    head = text[: text.index("<mujoco")]  # source and licence
    return head + ElementTree.tostring(root, encoding="unicode") + "\n"


def _take_over_contacts(root):
    """Gives the robot the contacts of our ground, since the server has a ground of its own."""
    ground = root.find("default/default[@class='scenery']/geom")
    for attribute in ("friction", "solref", "solimp", "priority"):
        if ground.get(attribute):
            root.find("default/geom").set(attribute, ground.get(attribute))


def _replace_motors(actuators):
    """Gives each joint the three motors that make up the server's motor."""
    pairs = [(motor.get("name"), motor.get("joint")) for motor in actuators]
    actuators.clear()
    for name, joint in pairs:
        for element, suffix in (("motor", "tau"), ("position", "pos"), ("velocity", "vel")):
            ElementTree.SubElement(actuators, element, name=f"{name}_{suffix}", joint=joint)


def ranges(kind):
    """Returns the range in degrees of the joint of each motor, by the motor's name."""
    root = ElementTree.parse(model_path(f"nao{kind}")).getroot()
    joints = {joint.get("name"): joint.get("range") for joint in root.find("worldbody").iter("joint")}
    return {
        motor.get("name").encode(): tuple(float(number) for number in joints[motor.get("joint")].split())
        for motor in root.find("actuator")
    }


def install(folder=None):
    """Writes the robots NAO0 to NAO4 into the installed server.

    :param folder: the folder of the package ``rcsssmj``; by default that of this Python environment
    :return: the written files
    :raises LeagueError: if the server is not installed or may not be changed
    """
    if folder is None:
        found = importlib.util.find_spec("rcsssmj")
        if found is None or not found.submodule_search_locations:
            raise LeagueError("RCSSServerMJ is not installed in this Python environment. Install it: pip install rcsssmj==0.2.1")
        folder = found.submodule_search_locations[0]
    robots = Path(folder, "resources", "robots")
    if not robots.is_dir():
        raise LeagueError(f"{robots} does not exist, so this version of RCSSServerMJ is not known. Install rcsssmj==0.2.1.")
    files = []
    try:
        for kind in TYPES:
            file = robots / f"NAO{kind}" / "robot.xml"
            file.parent.mkdir(exist_ok=True)
            unfinished = file.with_suffix(".part")
            unfinished.write_text(server_model(kind), encoding="utf-8")
            os.replace(unfinished, file)
            files.append(file)
    except OSError as wrong:
        raise LeagueError(f"The robots cannot be written to {robots}: {wrong}") from wrong
    return files


# ---- The bridge


class Translator:
    """Translation between the messages of one agent and those of the server."""

    def __init__(self, kind, team, number):
        self._ranges = ranges(kind)
        self._team, self._number = team, number
        self._speeds = dict.fromkeys(self._ranges, 0.0)
        self._angles = dict.fromkeys(self._ranges, 0.0)
        self._targets = None

    def perception(self, message):
        """Translates a message of the server for the agent."""
        message = _TRUTH.sub(b"", message)
        message = _GYRO.sub(lambda found: b"(GYR (n torso) (rt %s))" % _simspark_axes(found), message)
        message = _ACCELEROMETER.sub(lambda found: b"(ACC (n torso) (a %s))" % _simspark_axes(found), message)
        message = _TOUCH.sub(_foot_force, message)
        message = _HINGE.sub(self._hinge, message)
        message = _LANDMARK.sub(_landmark, message)
        left = b"(tl %s)" % self._team in message
        me = b"(GS (unum %d)(team %s)" % (self._number, b"left" if left else b"right")
        return message.replace(b"(GS ", me, 1)

    def _hinge(self, found):
        motor = found[1][:-2] + b"e" + found[1][-1:]  # llj4 is moved by lle4
        if motor in self._angles:
            self._angles[motor] = float(found[2])
        return b"(HJ (n %s) (ax %s))" % found.groups()

    def action(self, message):
        """Translates an answer of the agent for the server; motors keep their speeds until they get others."""
        for motor, speed in _MOTOR.findall(message):
            if motor in self._speeds:
                self._speeds[motor] = math.degrees(_finite(speed))
        parts = []
        beam = _BEAM.search(message)
        if beam:
            parts.append(b"(beam %s)" % b" ".join(b"%.3f" % _finite(number) for number in beam.groups()))
            self._targets = dict.fromkeys(self._ranges, 0.0)
        elif self._targets is None:
            self._targets = dict(self._angles)
        speech = _SAY.search(message)
        if speech and len(speech[1]) <= MAX_SPEECH_BYTES:
            parts.append(b"(SPK say 100 %s)" % base64.b64encode(speech[1]))
        for motor, (low, high) in self._ranges.items():
            angle, speed = self._angles[motor], self._speeds[motor]
            target = self._targets[motor] + speed * CYCLE_SECONDS
            target = min(max(target, angle - MAX_LEAD_DEGREES), angle + MAX_LEAD_DEGREES)
            self._targets[motor] = target = min(max(target, low), high)
            parts.append(b"(%s %.3f %.3f %g %g 0)" % (motor, target, speed, STIFFNESS, DAMPING))
        return b"".join(parts)


def _finite(digits):
    """Returns a number within what the server bears; a single infinite one would reset its world for all robots."""
    try:
        number = float(digits)
    except ValueError:
        return 0.0
    return min(max(number, -1000.0), 1000.0)


def _simspark_axes(found):
    """SimSpark's x axis points to the right and its y axis forward."""
    x, y, z = (float(number) for number in found.groups())
    return b"%.2f %.2f %.2f" % (-y, x, z)


def _foot_force(found):
    name, force = found[1], int(found[2])
    return b"(FRP (n %s) (c 0 0 -0.01) (f 0 0 %d))" % (name, force) if force else b""


def _landmark(found):
    name = found[1]
    if name in _LANDMARKS:
        return found[0].replace(name, _LANDMARKS[name], 1)
    return found[0] if name == b"B" or name.decode() in _MARKERS else b""


class Connection:
    """Messages with a prefix of four bytes for their length, which SimSpark and RCSSServerMJ share."""

    def __init__(self, connected):
        connected.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._socket = connected

    def send(self, message):
        self._socket.sendall(struct.pack(">I", len(message)) + message)

    def receive(self):
        """Returns the next message; raises ``OSError`` at the end of the connection."""
        (length,) = struct.unpack(">I", self._exactly(4))
        if length > MAX_MESSAGE_BYTES:
            raise OSError(f"a message of {length} bytes is announced")
        return self._exactly(length)

    def _exactly(self, count):
        data = b""
        while len(data) < count:
            more = self._socket.recv(count - len(data))
            if not more:
                raise OSError("the connection was closed")
            data += more
        return data

    def close(self):
        self._socket.close()


def play(agent, server_address, on_message=lambda message: None):
    """Lets one agent play until one of the two sides ends.

    :param agent: the connection to the agent
    :param server_address: pair of host and port of the server
    :param on_message: called with each message of the server
    """
    scene = _SCENE.search(agent.receive())
    kind = int(scene[2] or 0) if scene else 0
    agent.send(b"(time (now 0.00))")
    joining = _INIT.search(agent.receive())
    if not joining or kind not in TYPES:
        raise OSError("the agent does not speak SimSpark's protocol")
    number, team = int(joining[1]) or 1, joining[2]
    server = Connection(socket.create_connection(server_address))
    try:
        server.send(b"(init NAO%d %s %d)" % (kind, team, number))
        translator = Translator(kind, team, number)
        while True:
            message = server.receive()
            on_message(message)
            agent.send(translator.perception(message))
            server.send(translator.action(agent.receive()))
    finally:
        server.close()


def serve(listener, server_address, on_message=lambda message: None):
    """Accepts agents until the listening socket is closed; each plays in a thread of its own."""
    while True:
        try:
            connected, _ = listener.accept()
        except OSError:
            return
        threading.Thread(target=_play_and_report, args=(Connection(connected), server_address, on_message), daemon=True).start()


def _play_and_report(agent, server_address, on_message):
    try:
        play(agent, server_address, on_message)
    except OSError as end:
        print(f"An agent has left, or the server has ended: {end}", file=sys.stderr)
    finally:
        agent.close()


def _address(text):
    host, colon, port = text.rpartition(":")
    if not colon or not port.isdigit():
        raise argparse.ArgumentTypeError(f"{text!r} is not HOST:PORT, such as 127.0.0.1:60000")
    return host, int(port)


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python -m robonewbie.league", description="The NAO on RCSSServerMJ.")
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("install", help="add the NAO to the server that is installed in this Python environment")
    bridge = commands.add_parser("bridge", help="let agents that speak SimSpark's protocol play on a running server")
    bridge.add_argument("--port", type=int, default=3100, help="port for agents (default: 3100)")
    bridge.add_argument("--server", type=_address, default=("127.0.0.1", 60000), help="HOST:PORT of the server (default: 127.0.0.1:60000)")
    options = parser.parse_args(arguments)
    try:
        if options.command == "install":
            print(f"The server knows NAO0 to NAO4 now: {install()[0].parents[1]}")
            return 0
        with socket.create_server(("127.0.0.1", options.port)) as listener:
            print(f"Agents connect to port {options.port}; Control-C ends the bridge.", flush=True)
            serve(listener, options.server)
    except KeyboardInterrupt:
        return 0
    except (LeagueError, OSError, OverflowError) as wrong:
        print(f"robonewbie.league: {wrong}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
