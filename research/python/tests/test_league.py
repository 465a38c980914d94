"""The NAO on RCSSServerMJ; tests on a real server are skipped without it (pip install rcsssmj==0.2.1)."""

import importlib.util
import math
import os
import re
import socket
import statistics
import subprocess
import sys
import tempfile
import threading
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from robonewbie import league
from robonewbie.simulator import _command

SERVER = importlib.util.find_spec("rcsssmj")
ROBOT = """
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyRobot extends Agent {
    public static void main(String[] args) { new MyRobot().run(args); }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < 30 ? 60 : 0);
    }
}
"""
WALKER = """
import org.robonewbie.agent.Agent;

public class Walker extends Agent {
    public static void main(String[] args) { new Walker().run(args); }

    @Override
    protected void think() {
        walk.towards(0.2, 0, 0);
    }
}
"""
DANCER = """
import org.robonewbie.agent.Agent;

public class Dancer extends Agent {
    public static void main(String[] args) { new Dancer().run(args); }

    @Override
    protected void think() {
        if (motions.isFinished()) {
            motions.start("wave");
        }
    }
}
"""

PLACES = """
import java.util.Set;
import java.util.TreeSet;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;

public class Places extends Agent {
    private final SelfLocalisation self = new SelfLocalisation();
    private final Set<String> seen = new TreeSet<>();
    private int cycle;

    public static void main(String[] args) { new Places().run(args); }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        nao.getVision().ifPresent(picture -> picture.sightings().forEach(sighting -> {
            if (!sighting.name().startsWith(nao.getTeam())) {  // its own feet
                seen.add(sighting.name());
            }
        }));
        int place = cycle / 75;
        if (place >= 20) {
            walk.towards(0.5, 0, cycle % 200 < 100 ? 20 : -20);
        } else if (cycle % 75 == 0) {
            nao.beam(-2 - 1.2 * place, 15 * Math.sin(place), 50 * place % 360);
        } else {
            lookAround.look();
        }
        if (++cycle % 75 == 0) {
            System.out.printf("place %.2f %.3f %.3f %d%n", nao.getTime(), self.pose().x(), self.pose().y(), seen.size());
        }
    }
}
"""
TWO = """
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.nao.Vector3;

public class Two extends Agent {
    private final SelfLocalisation self = new SelfLocalisation();
    private final String team;
    private int cycle;

    private Two(String team) { this.team = team; }

    public static void main(String[] args) { runTogether(args, new Two("Blue"), new Two("Red")); }

    @Override
    protected Options defaults() { return Options.none().withTeam(team).withNumber(3).withPose(-6, 2, -20); }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        if (team.equals("Blue")) {
            nao.say("hallo");
        }
        if (cycle++ == 60) {
            nao.getHeard().forEach(heard -> System.out.println(team + " heard " + heard.text()));
            Vector3 ball = self.pose().toFrame(fieldView.ball().position());
            System.out.printf("%s %s %s pose %.1f %.1f %.0f ball %.0f %.0f others %d%n", team, nao.getTeamSide(), nao.getPlayMode(),
                    self.pose().x(), self.pose().y(), self.pose().degrees(), ball.x(), ball.y(), fieldView.opponents().size());
        }
    }
}
"""


class InstallTest(unittest.TestCase):
    def test_each_robot_has_what_the_server_looks_for(self):
        for kind in league.TYPES:
            root = ElementTree.fromstring(league.server_model(kind))
            motors = {motor.get("name") for motor in root.find("actuator")}
            sites = {site.get("name") for site in root.iter("site")}

            self.assertEqual([body.get("name") for body in root.find("worldbody")], ["torso"])
            self.assertTrue({"lle4_tau", "lle4_pos", "lle4_vel"} <= motors)
            self.assertEqual(len(motors), 3 * len(league.ranges(kind)))
            self.assertTrue({"torso", "camera", "head-vismarker"} <= sites)
            self.assertEqual(root.find("sensor/gyro").get("site"), "torso")

    def test_files_are_written_into_the_server_with_their_licence(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "resources", "robots").mkdir(parents=True)

            files = league.install(folder)

            self.assertEqual([file.parent.name for file in files], ["NAO0", "NAO1", "NAO2", "NAO3", "NAO4"])
            self.assertTrue(all("Apache-2.0" in file.read_text(encoding="utf-8") for file in files))

    def test_unknown_server_is_refused_unchanged(self):
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(league.LeagueError, "Install rcsssmj==0.2.1"):
                league.install(folder)

            self.assertEqual(list(Path(folder).iterdir()), [])


class TranslatorTest(unittest.TestCase):
    def setUp(self):
        self.translator = league.Translator(0, b"Blue", 2)

    def test_senses_are_translated(self):
        translated = self.translator.perception(
            b"(time (now 1.5))(GS (t 0.0)(pm BeforeKickOff)(tl Red)(tr Blue)(sl 0)(sr 0))(pos (n torso_pos) (p 1.0 2.0 0.3))"
            b"(GYR (n torso_gyro) (rt 1.0 2.0 3.0))(ACC (n torso_acc) (a -0.0 0.5 9.81))(TCH n lf val 22)(TCH n rf val 0)"
            b"(HJ (n laj1)(ax 30.5)(vx 1.0))(See (g_rup (pol 9.0 1.0 2.0))(t_cuf (pol 1.0 2.0 3.0))(B (pol 2.0 3.0 4.0)))"
        )

        self.assertEqual(
            translated,
            b"(time (now 1.5))(GS (unum 2)(team right)(t 0.0)(pm BeforeKickOff)(tl Red)(tr Blue)(sl 0)(sr 0))"
            b"(GYR (n torso) (rt -2.00 1.00 3.00))(ACC (n torso) (a -0.50 -0.00 9.81))(FRP (n lf) (c 0 0 -0.01) (f 0 0 22))"
            b"(HJ (n laj1) (ax 30.5))(See (G1R (pol 9.0 1.0 2.0))(B (pol 2.0 3.0 4.0)))",
        )

    def test_motor_keeps_its_speed(self):
        first = self.translator.action(b"(lae1 1)(syn)")
        second = self.translator.action(b"(syn)")

        self.assertIn(b"(lae1 1.146 57.296 300 5 0)", first)
        self.assertIn(b"(lae1 2.292 57.296 300 5 0)", second)

    def test_target_stays_near_the_joint_and_within_its_range(self):
        for _ in range(50):
            ahead = self.translator.action(b"(lae1 6)(rle1 6)(syn)")

        self.assertIn(b"(lae1 5.000 ", ahead)
        self.assertIn(b"(rle1 1.000 ", ahead)

    def test_messages_that_would_end_or_reset_the_server_do_not_reach_it(self):
        sent = self.translator.action(b"(foo 1 2 3 4 5)(xxe9 1)(beam nan 0 0)(lae1 1e999)(rae1 1e30)(say hello)(say (x))")

        names = {name for name in re.findall(rb"\((\w+) ", sent)}
        self.assertEqual(names, set(league.ranges(0)) | {b"SPK"})
        self.assertNotRegex(sent, rb"nan|inf|e\d\d")


class ServerTest(unittest.TestCase):
    """Each test has a server of its own, which agents reach by a port that keeps its messages; agents are Java programs."""

    robot = "NAO"
    orders = ()  # what a trainer orders after 3 s

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        ports = [_free_port() for _ in range(2)]
        options = [f"--aport={ports[0]}", f"--mport={ports[1]}", "--sync", "--no-realtime", "--no-render"]
        self.server = subprocess.Popen(
            [sys.executable, "-m", "rcsssmj", *options], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
        )
        self.addCleanup(self._end_server)
        for line in self.server.stderr:
            if "agent" in line.lower() and str(ports[0]) in line:
                break
        self.messages = []
        listener = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(listener.close)
        self.port = listener.getsockname()[1]
        self.monitor_port = ports[1]
        served = (listener, ("127.0.0.1", ports[0]), self._on_message)
        threading.Thread(target=self.serve, args=served, daemon=True).start()

    def serve(self, listener, server_address, on_message):
        while True:
            try:
                agent = league.Connection(listener.accept()[0])
            except OSError:
                return
            threading.Thread(target=self._pass_on, args=(agent, server_address, on_message), daemon=True).start()

    def _pass_on(self, agent, server_address, on_message):
        """Passes all messages between an agent and the server."""
        server = league.Connection(socket.create_connection(server_address))
        try:
            while True:
                server.send(agent.receive())
                message = server.receive()
                on_message(message)
                agent.send(message)
        except OSError:
            agent.close()
            server.close()

    def _on_message(self, message):
        self.messages.append(message)
        if len(self.messages) == 150 and self.orders:
            monitor = socket.create_connection(("127.0.0.1", self.monitor_port))
            self.addCleanup(monitor.close)
            connection = league.Connection(monitor)
            for order in self.orders:
                connection.send(order)

    def _end_server(self):
        self.server.kill()  # it does not always notice an interrupt
        self.server.communicate()

    def _run(self, name, source, seconds, *more):
        file = self.folder / f"{name}.java"
        file.write_text(source, encoding="utf-8")
        options = ["--host", "127.0.0.1", "--port", str(self.port), "--robot", self.robot, "--seconds", str(seconds), "--headless", *more]
        done = subprocess.run([*_command(), "run", str(file), *options], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIsNone(self.server.poll())
        return done.stdout + done.stderr

    def _readings(self, pattern):
        """Returns the numbers that a sensor has sent from the start of the program until its end."""
        found = [re.search(pattern, message) for message in self.messages]
        return [[float(number) for number in each.groups()] for each in found if each]


@unittest.skipUnless(SERVER, "rcsssmj is not installed")
class NaoTest(ServerTest):
    """NAOs play through the bridge."""

    def setUp(self):
        league.install()
        super().setUp()

    def serve(self, *served):
        league.serve(*served)

    def test_first_program_of_the_readme_raises_the_arm(self):
        self._run("MyRobot", ROBOT, 3)

        ((angle,),) = self._readings(rb"\(HJ \(n laj1\)\(ax ([-\d.]+)\)")[-1:]
        self.assertGreater(angle, 29.5)
        self.assertLess(angle, 32)

    def test_walk_goes_forward_upright(self):
        self._run("Walker", WALKER, 12)

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")[15:]
        distance = places[-1][0] - places[0][0]
        self.assertGreater(distance, 1.2)
        self.assertLess(distance, 3)
        self.assertGreater(min(place[2] for place in places[50:]), 0.3)


@unittest.skipUnless(SERVER, "rcsssmj is not installed")
class T1Test(ServerTest):
    robot = "T1"

    def test_first_program_of_the_readme_raises_the_arm(self):
        self._run("MyRobot", ROBOT, 4)

        ((angle,),) = self._readings(rb"\(HJ \(n q_laj1\)\(ax ([-\d.]+)\)")[-1:]
        self.assertGreater(-angle - 90, 29.5)
        self.assertLess(-angle - 90, 32)

    def test_motions_of_arms_and_head_play_upright(self):
        self._run("Dancer", DANCER, 12)

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")[15:]
        self.assertGreater(min(place[2] for place in places), 0.6)
        arms = [angle for (angle,) in self._readings(rb"\(HJ \(n q_laj1\)\(ax ([-\d.]+)\)")]
        self.assertGreater(max(arms) - min(arms), 60)

    def test_walk_goes_forward_upright(self):
        self._run("Walker", WALKER.replace("0.2, 0, 0", "0.5, 0, 0"), 12)

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")[15:]
        self.assertGreater(places[-1][0] - places[0][0], 1.5)
        self.assertGreater(min(place[2] for place in places), 0.55)


    def test_finds_its_place_by_what_it_sees(self):
        printed = self._run("Places", PLACES, 38)

        truth = {round(time, 2): (x, y) for time, x, y in self._readings(rb"\(now ([\d.]+)\).*torso_pos\) \(p ([-\d.]+) ([-\d.]+)")}
        lines = [[float(word) for word in line.split()[1:]] for line in printed.splitlines() if line.startswith("place ")]
        errors = [math.dist(truth[time], (x, y)) for time, x, y, _ in lines]
        self.assertGreaterEqual(len(errors), 24)
        self.assertLess(statistics.median(errors), 0.05)
        self.assertLess(max(errors), 0.1)
        self.assertEqual(lines[-1][-1], 31)  # all landmarks and the ball

    def test_fallen_robot_waits_for_the_referee_and_walks_on(self):
        self.orders = (b"(kickOff Left)", b"(agent (unum 2)(team RoboNewbie)(move3d -5 0 0.3 0.7071 0 0.7071 0))")
        source = WALKER.replace("walk.towards(0.2, 0, 0)", "if (nao.isFallen()) { motions.startGetUp(); } else { walk.towards(0.5, 0, 0); }")

        printed = self._run("Walker", source, 30, "--number", "2")

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")
        self.assertLess(min(place[2] for place in places), 0.15)
        self.assertGreater(places[-1][2], 0.55)
        self.assertLess(abs(places[-1][1]), 20.5)  # the referee has placed it at 21 m
        self.assertEqual(printed.count("The T1 has fallen and cannot get up"), 1)

    def test_policy_of_the_user_walks(self):
        shipped = Path(__file__).parents[3] / "core/agent/src/main/resources/policies/t1-walk.policy"
        policy = self.folder / "mine.policy"
        policy.write_bytes(shipped.read_bytes())

        self._run("Walker", WALKER.replace("0.2, 0, 0", "0.5, 0, 0"), 6, "--walk", str(policy))

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")[15:]
        self.assertGreater(places[-1][0] - places[0][0], 0.5)

    def test_program_of_the_page_walks_to_the_ball_as_t1_and_as_nao(self):
        page = Path(__file__).parents[3] / "docs/from-nao-to-t1.md"
        (source,) = re.findall(r"```java\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)

        self._run("ToTheBall", source, 14, "--pose", "-2,0.5,0")

        places = self._readings(rb"\(pos \(n torso_pos\) \(p ([-\d.]+) ([-\d.]+) ([-\d.]+)\)\)")
        self.assertGreater(math.hypot(*places[-1][:2]), 0.4)
        self.assertLess(math.hypot(*places[-1][:2]), 0.95)
        self.assertGreater(places[-1][2], 0.55)
        options = ["--seconds", "5", "--fast", "--headless", "--pose", "-1,0,0"]
        done = subprocess.run([*_command(), "run", str(self.folder / "ToTheBall.java"), *options], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_first_program_starts_the_server_itself(self):
        file = self.folder / "MyRobot.java"
        file.write_text(ROBOT, encoding="utf-8")
        path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
        options = ["--robot", "T1", "--port", str(_free_port()), "--seconds", "3", "--headless"]

        done = subprocess.run(
            [*_command(), "run", str(file), *options], cwd=self.folder, env={**os.environ, "PATH": path}, capture_output=True, text=True
        )

        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Started RCSSServerMJ", done.stdout)

    def test_teams_share_one_match(self):
        printed = self._run("Two", TWO, 6)

        self.assertRegex(printed, "Blue LEFT BEFORE_KICK_OFF pose -6.0 2.0 -20 ball -?0 -?0 others 1")
        self.assertRegex(printed, "Red RIGHT BEFORE_KICK_OFF pose -6.0 2.0 -20 ball -?0 -?0 others 1")
        self.assertIn("Red heard hallo", printed)
        self.assertNotIn("Blue heard", printed)


@unittest.skipUnless(SERVER, "rcsssmj is not installed")
class K1Test(ServerTest):
    robot = "K1"

    def test_first_program_of_the_readme_raises_the_arm(self):
        self._run("MyRobot", ROBOT, 4)

        ((angle,),) = self._readings(rb"\(HJ \(n q_laj1\)\(ax ([-\d.]+)\)")[-1:]
        self.assertGreater(-angle - 90, 29.5)
        self.assertLess(-angle - 90, 32)


def _free_port():
    with socket.create_server(("127.0.0.1", 0)) as probe:
        return probe.getsockname()[1]


if __name__ == "__main__":
    unittest.main()
