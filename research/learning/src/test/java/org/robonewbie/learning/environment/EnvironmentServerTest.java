package org.robonewbie.learning.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.agent.policy.PolicyText;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.embedded.Viewer;

class EnvironmentServerTest {

    private final List<String> console = Collections.synchronizedList(new ArrayList<>());
    private EnvironmentServer server;
    private Socket socket;

    @BeforeEach
    void connect() throws IOException {
        server = EnvironmentServer.open(0, getClass().getClassLoader(), EnvironmentServerTest::refuse, console::add);
        socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    }

    private static Viewer.View refuse(SimulationControl simulation, int viewPort) throws IOException {
        throw new IOException("There is no viewer.");
    }

    @AfterEach
    void close() throws IOException {
        socket.close();
        server.close();
    }

    @Test
    void taskIsDescribedWithNamesUnitsAndRanges() throws IOException {
        String description = text(make("Reach", 1));

        assertThat(description)
                .startsWith("\0{")
                .contains("\"name\":\"joint.NECK_YAW\",\"unit\":\"degrees\"")
                .contains("\"action\":[\"LEFT_SHOULDER_PITCH\"")
                .contains("\"longestCycles\":100");
    }

    @Test
    void actionLeadsTheJointToItsAngle() throws IOException {
        make("Reach", 1);
        act(order(2, 1, 0, 0, 0, 0));

        ByteBuffer answer = act(order(1, 0, 0.1, 0, 0, 0));
        for (int i = 0; i < 50; i++) {
            answer = act(order(1, 0, 0.1, 0, 0, 0));
        }

        double shoulder = answer.getFloat(1 + Float.BYTES * Joint.LEFT_SHOULDER_PITCH.ordinal());
        assertThat(shoulder).isCloseTo(-95 + 12, within(0.5));
    }

    @Test
    void physicsOfEachCycleIsAskedOfTheClientThatWantsIt() throws IOException {
        byte[] task = "Reach".getBytes(StandardCharsets.UTF_8);
        ask(little(5 + task.length).put((byte) 'X').putInt(1).put(task).array());
        act(order(2, 1, 0, 0, 0, 0));

        ByteBuffer asked = act(order(1, 0, 0.1, 0, 0, 0));
        double height = asked.getDouble(1 + 5 * Double.BYTES);
        ByteBuffer answer = ask(motionless(height - 0.1));

        assertThat(asked.get(0)).isEqualTo((byte) 2);
        assertThat(asked.remaining()).isEqualTo(1 + Double.BYTES * (31 + 3 * Joint.COUNT));
        assertThat(height).isCloseTo(0.34, within(0.01));
        assertThat(answer.get(0)).isZero();
        int truth = answer.remaining() - 1 - Double.BYTES * PrivilegedState.NAMES.size();
        assertThat(answer.getDouble(truth + Double.BYTES * PrivilegedState.NAMES.indexOf("height")))
                .isEqualTo(height - 0.1);
    }

    /** Returns a state in which all links are at the same place. */
    private static byte[] motionless(double height) {
        int links = NaoModel.of(RobotType.TYPE_0).links().size();
        ByteBuffer state = little(Double.BYTES * (13 * links + 9 + 28));
        for (int i = 0; i < links; i++) {
            state.putDouble(0).putDouble(0).putDouble(height).putDouble(1);
            state.position(13 * Double.BYTES * (i + 1));
        }
        return bytes(state.position(state.capacity()));
    }

    @Test
    void gaitIsThatOfThePolicy() throws IOException {
        make("WalkGait", 1);
        byte[] policy = ("L" + PolicyText.format(PolicyFile.shipped("walk"))).getBytes(StandardCharsets.UTF_8);
        double[] still = new double[12];
        act(order(2, 1, still));
        ByteBuffer standard = act(order(1, 0, still));

        assertThat(ask(policy).remaining()).isEqualTo(1);
        act(order(2, 1, still));

        assertThat(act(order(1, 0, still))).isNotEqualTo(standard);
    }

    @Test
    void oldTaskIsKeptWhenAnUnknownOneIsAskedFor() throws IOException {
        make("Reach", 1);

        assertThat(text(make("Fly", 1)))
                .startsWith("\1There is no task \"Fly\". Available: EngineFollow, EngineRun, Follow, GetUp, JogGait,"
                        + " KeeperAgainstAttacker, Kick, KickTo, Match11v11, Match1v1, Match2v2, QuickGetUp,"
                        + " Reach, Run, RunGait, Stand, Walk, WalkGait. A class of your own must extend");
        assertThat(text(make("Walk\nforward=0.5", 1)))
                .isEqualTo(
                        "\1This task has no commanded velocity. Omit the options forward, left and turn, or choose the task Follow.");
        assertThat(text(make("Walk", 0))).isEqualTo("\1" + "0 environments were requested; request 1 to 1024.");
        assertThat(act(order(2, 1, 0, 0, 0, 0)).get(0)).isZero();
    }

    @Test
    void anyMeasureCanBeTheReward() throws IOException {
        assertThat(text(make("Reach\nreward=energy", 1))).contains("\"reward\":\"energy\"");
        act(order(2, 1, 0, 0, 0, 0));
        act(order(1, 0, 1, 0, 0, 0));
        ByteBuffer answer = act(order(1, 0, 1, 0, 0, 0));

        assertThat(answer.getDouble(answer.limit() - 9 - Double.BYTES * PrivilegedState.NAMES.size()))
                .isNegative();
        assertThat(text(make("Reach\nreward=joy", 1))).startsWith("\1There is no measure \"joy\". Available: ");
        assertThat(text(make("Reach\nvelocity=9", 1)))
                .isEqualTo(
                        "\1There is no option \"velocity\". Available: reward, x, y, heading, ball_x, ball_y, push,"
                                + " delay, cycles, noise, friction, mass, forward, left, turn, distance, speed, step,"
                                + " slow, tolerance, constant, flight, type, seconds, strength, sole_friction, com_forward, com_left, jitter, history, speeds, true_state.");
    }

    @Test
    void optionsChangeWhatBeginsAndPicturesShowIt() throws IOException {
        make("Walk\nx=1..1.5\nball_x=0.5", 1);
        double[] nothing = new double[12];

        double first = truth(act(order(2, 1, nothing)), "x");
        assertThat(first).isBetween(1.0, 1.5);
        assertThat(truth(act(order(2, 2, nothing)), "x")).isBetween(1.0, 1.5).isNotEqualTo(first);
        assertThat(truth(act(order(2, 1, nothing)), "x")).isEqualTo(first);
        assertThat(text(ask("Cball_x=2".getBytes(StandardCharsets.UTF_8)))).isEqualTo("\0");
        assertThat(truth(act(order(2, 1, nothing)), "ball_x")).isEqualTo(2);
        assertThat(text(ask(bytes(little(5).put((byte) 'P').putInt(0))))).contains("\"ball\":[2.0,-8.0,");
        assertThat(text(ask(bytes(little(5).put((byte) 'P').putInt(1)))))
                .isEqualTo("\1Environment 1 does not exist. Valid indices are 0 to 0.");
        assertThat(text(ask("Cball_x=2..1".getBytes(StandardCharsets.UTF_8))))
                .startsWith("\1The option ball_x=2..1 is neither a number nor an ascending range");
    }

    @Test
    void episodeThatIsOverBeginsAgainWithItsNextObservation() throws IOException {
        make("Reach\ncycles=60", 2);
        byte[] begin = bytes(little(50).put(order(2, 1, 0, 0, 0, 0)).put(order(2, 2, 0, 0, 0, 0)));
        byte[] act = bytes(little(50).put(order(3, 1, 0, 0, 0, 0)).put(order(1, 2, 0, 0, 0, 0)));
        ByteBuffer first = act(begin);

        ByteBuffer middle = act(act);
        ByteBuffer last = act(act);

        int row = (first.limit() - 1) / 2;
        int observation = row - 1 - Double.BYTES * (1 + PrivilegedState.NAMES.size());
        assertThat(middle.limit()).isEqualTo(first.limit());
        assertThat(last.limit()).isEqualTo(first.limit() + observation);
        assertThat(last.get(row)).as("the time of the task is over").isEqualTo((byte) 2);
        assertThat(last.slice(first.limit(), observation)).isEqualTo(first.slice(1, observation));
    }

    @Test
    void robotsOfAMatchActAndEarnEachForItself() throws IOException {
        String description = text(make("Match1v1", 1));
        byte[] begin = order(2, 1, new double[3]);
        double[] before = places(act(bytes(little(2 * begin.length).put(begin).put(begin))));
        byte[] hold = order(1, 1, new double[3]);
        double[] after = {};
        for (int i = 0; i < 10; i++) {
            after = places(act(bytes(little(2 * hold.length).put(hold).put(order(1, 1, 1, 0, 0)))));
        }

        assertThat(description).contains("\"robots\":[\"left_1\",\"right_1\"]", "\"opponent1.forward\"", "\"0.8 m/s\"");
        assertThat(after[0]).isCloseTo(before[0], within(0.05));
        assertThat(after[1]).as("walks forward, towards the left goal").isLessThan(before[1] - 0.5);
        assertThat(text(make("Match1v1\nreward=energy", 1))).startsWith("\1The reward energy measures a single robot");
    }

    /** Returns the x coordinate of both robots of a match. */
    private static double[] places(ByteBuffer answer) {
        int row = (answer.limit() - 1) / 2;
        int x = Double.BYTES * (PrivilegedState.NAMES.size() - PrivilegedState.NAMES.indexOf("x"));
        return new double[] {answer.getDouble(row - x), answer.getDouble(2 * row - x)};
    }

    private static double truth(ByteBuffer answer, String name) {
        int fromTheEnd = PrivilegedState.NAMES.size() - PrivilegedState.NAMES.indexOf(name);
        return answer.getDouble(answer.limit() - 1 - Double.BYTES * fromTheEnd);
    }

    @Test
    void programThatNamesNoTaskIsRefused() throws IOException {
        assertThat(text(make("", 1))).startsWith("\1There is no task \"\".");
    }

    @Test
    void shippedSampleOfATaskIsShortAndRuns(@TempDir Path classes) throws Exception {
        Path sample = Path.of("../python/examples/Squat.java");
        int code =
                ToolProvider.getSystemJavaCompiler().run(null, null, null, "-d", classes.toString(), sample.toString());
        try (URLClassLoader loader =
                        new URLClassLoader(new URL[] {classes.toUri().toURL()});
                TrainingEnvironment squat = new EnvironmentSpec("Squat", List.of()).create(loader)) {
            double[] bent = new double[squat.task().joints().size()];
            for (Joint joint : List.of(Joint.LEFT_KNEE_PITCH, Joint.RIGHT_KNEE_PITCH)) {
                bent[squat.task().joints().indexOf(joint)] = -0.3;
            }
            double earned = 0;
            for (int i = 0; i < 20; i++) {
                squat.step(bent);
                earned += squat.reward();
            }

            assertThat(code).isZero();
            assertThat(Files.readAllLines(sample)).hasSizeLessThanOrEqualTo(40);
            assertThat(earned).isPositive();
        }
    }

    @Test
    void noRobotMovesIfAnActionIsNoNumber() throws IOException {
        make("Reach", 2);
        byte[] reset = bytes(little(50).put(order(2, 1, 0, 0, 0, 0)).put(order(2, 2, 0, 0, 0, 0)));
        byte[] waiting = bytes(little(50).put(order(0, 1, 0, 0, 0, 0)).put(order(0, 2, 0, 0, 0, 0)));
        ByteBuffer before = act(reset);

        assertThat(text(act(bytes(little(50).put(order(1, 0, 1, 0, 0, 0)).put(order(1, 0, Double.NaN, 0, 0, 0))))))
                .startsWith("\1An action of environment 1 contains NaN.");
        assertThat(act(waiting)).isEqualTo(before);
    }

    @Test
    void ordersOfAWrongSizeAreRefused() throws IOException {
        make("Reach", 2);

        assertThat(text(act(order(1, 0, 0, 0, 0, 0))))
                .isEqualTo("\1The step request has 25 bytes; expected 50 for 2 robots with 4 actions each.");
        assertThat(text(ask(new byte[] {'?'}))).isEqualTo("\1There is no request of kind 63.");
    }

    private ByteBuffer make(String task, int count) throws IOException {
        byte[] name = task.getBytes(StandardCharsets.UTF_8);
        return ask(
                little(5 + name.length).put((byte) 'M').putInt(count).put(name).array());
    }

    private ByteBuffer act(byte[] order) throws IOException {
        return ask(bytes(little(1 + order.length).put((byte) 'A').put(order)));
    }

    private static byte[] order(int what, long seed, double... action) {
        ByteBuffer order =
                little(9 + Float.BYTES * action.length).put((byte) what).putLong(seed);
        for (double part : action) {
            order.putFloat((float) part);
        }
        return bytes(order);
    }

    private ByteBuffer ask(byte[] message) throws IOException {
        socket.getOutputStream()
                .write(little(4 + message.length)
                        .putInt(message.length)
                        .put(message)
                        .array());
        DataInputStream input = new DataInputStream(socket.getInputStream());
        byte[] answer = new byte[Integer.reverseBytes(input.readInt())];
        input.readFully(answer);
        return ByteBuffer.wrap(answer).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static byte[] bytes(ByteBuffer buffer) {
        byte[] bytes = new byte[buffer.flip().remaining()];
        buffer.get(bytes);
        return bytes;
    }

    private static ByteBuffer little(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static String text(ByteBuffer answer) {
        return StandardCharsets.UTF_8.decode(answer).toString();
    }
}
