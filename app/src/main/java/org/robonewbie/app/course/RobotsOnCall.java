package org.robonewbie.app.course;

import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Queue;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.running.CycleOwner;
import org.robonewbie.agent.running.Slowness;
import org.robonewbie.agent.running.Watchdog;
import org.robonewbie.exercises.Patience;
import org.robonewbie.exercises.Performance;
import org.robonewbie.exercises.Score;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/**
 * The process in which a student's program runs while another one judges it: it brings a robot whenever the judge asks for one. All
 * that it can tell the judge is what its robots do, and why they gave up.
 */
public final class RobotsOnCall {

    /** The file that says that the program can be started. */
    static final String READY = "ready";

    /** The file that says what makes the program slow. */
    static final String SLOW = "slow";

    private static final String HERE = "127.0.0.1";
    private static final double MOST_IDLE_MILLISECONDS = 50;

    private final Supplier<? extends Agent> program;
    private final Path complaints;
    private final Queue<Robot> robots = new ConcurrentLinkedQueue<>();

    /**
     * Prepares the program.
     *
     * @param program makes a robot with the student's program
     * @param complaints folder for the reasons for which robots give up
     */
    public RobotsOnCall(Supplier<? extends Agent> program, Path complaints) {
        this.program = program;
        this.complaints = complaints;
    }

    /** What the judge asks for. */
    record Call(int port, String team, int number, TeamSide side) {

        static Call read(String line) {
            String[] words = line.split(" ", -1);
            return new Call(
                    Integer.parseInt(words[0]), words[1], Integer.parseInt(words[2]), TeamSide.valueOf(words[3]));
        }

        String line() {
            return port + " " + team + " " + number + " " + side + "\n";
        }
    }

    private record Robot(Call call, Patience patience, AtomicReference<TcpAgentLink> link) {

        /** Ends the conversation with the judge, whatever the program is at. */
        void leave() {
            Optional.ofNullable(link.get()).ifPresent(TcpAgentLink::close);
        }
    }

    /**
     * Brings robots until the judge is gone; the program has no access to the calls.
     *
     * @throws IOException if the calls cannot be read
     */
    public void serve() throws IOException {
        InputStream calls = System.in;
        System.setIn(new ByteArrayInputStream(new byte[0]));
        Files.createFile(complaints.resolve(READY));
        new Timer("patience", true).schedule(new Look(), 0, Patience.TICK_MILLISECONDS);
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(calls, StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                Robot robot = new Robot(Call.read(line), new Patience(), new AtomicReference<>());
                robots.add(robot);
                Thread thread = new Thread(() -> play(robot), "robot");
                thread.setDaemon(true);
                thread.start();
            }
        }
        Runtime.getRuntime().halt(0);
    }

    /** Looks whether all robots still answer. */
    private final class Look extends TimerTask {

        @Override
        public void run() {
            robots.removeIf(this::isStuck);
        }

        private boolean isStuck(Robot robot) {
            robot.patience().tick();
            if (robot.patience().isExhausted()) {
                complain(robot, robot.patience().score());
                robot.leave();
                return true;
            }
            return false;
        }
    }

    private void play(Robot robot) {
        robot.patience().begin();
        try (TcpAgentLink link = TcpAgentLink.connect(HERE, robot.call().port())) {
            robot.link().set(link);
            playOrComplain(robot, link);
        } catch (IOException judgeIsGone) {
            // Then nobody wants to know what has become of the robot.
        } finally {
            robot.patience().end();
            robots.remove(robot);
        }
    }

    /** A complaint has to be there before the connection ends. */
    private void playOrComplain(Robot robot, TcpAgentLink link) throws IOException {
        try {
            play(robot, link);
        } catch (VirtualMachineError exhausted) {
            throw exhausted;
        } catch (RuntimeException | Error mistake) {
            complain(robot, Performance.ofMistake(mistake));
        }
    }

    private void play(Robot robot, TcpAgentLink link) throws IOException {
        Call call = robot.call();
        AgentDriver driver = new AgentDriver(program.get());
        driver.introduce(Options.none().withTeam(call.team()).withNumber(call.number()), call.side());
        Watchdog watchdog = driver.watch(slowness -> noteSlowness(robot, slowness));
        try {
            play(robot, link, driver);
        } finally {
            watchdog.close();
        }
    }

    private void play(Robot robot, TcpAgentLink link, AgentDriver driver) throws IOException {
        PerceptorMessageReader reader = new PerceptorMessageReader();
        MessageBuffer message = new MessageBuffer();
        MessageBuffer answer = new MessageBuffer();
        EffectorMessageWriter writer = new EffectorMessageWriter(answer);
        writer.synchronise();
        link.send(answer);
        boolean failed = false;
        while (link.receive(message)) {
            answer.clear();
            driver.respond(reader.read(message)).forEach(writer::write);
            if (!failed && driver.hasFailed()) {
                failed = true;
                complain(robot, Score.failed(0, "", Performance.MEND_STEP));
            }
            robot.patience().progress();
            link.send(answer);
        }
    }

    /** A program that sleeps in its cycles would take minutes for a trial; one that computes too much may be right all the same. */
    private void noteSlowness(Robot robot, Slowness slowness) {
        String finding =
                CycleOwner.FRAMEWORK.finding(slowness, " at " + slowness.cause().place());
        write(SLOW, finding + "\n" + slowness.advice());
        if (slowness.isIdle() && slowness.milliseconds() >= MOST_IDLE_MILLISECONDS) {
            complain(robot, Score.failed(0, finding, slowness.advice()));
            robot.leave();
        }
    }

    private void complain(Robot robot, Score score) {
        write(Integer.toString(robot.call().port()), score.finding() + "\n" + score.hint());
    }

    private void write(String file, String text) {
        try {
            AtomicFile.write(complaints.resolve(file), text);
        } catch (IOException unwritable) {
            System.err.println(text);
        }
    }
}
