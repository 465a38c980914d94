package org.robonewbie.programs.process;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Supplier;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.running.CycleOwner;
import org.robonewbie.agent.running.Slowness;
import org.robonewbie.agent.running.Watchdog;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.programs.process.Departure.Cause;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;
import org.robonewbie.protocol.tcp.TcpAgentLink;

/**
 * Child side of a {@link RobotProcess}: runs a robot with the student's program for each call, and reports why each robot
 * has left.
 */
final class RobotHost {

    /** Answer sent once the program has been loaded. */
    static final String READY = "ready";

    /** Prefix of the answer that explains why the program is slow. */
    static final String SLOW = "slow ";

    private static final String HERE = "127.0.0.1";
    private static final double MAX_IDLE_MILLISECONDS = 50;

    private final ParentProcess judge;
    private final Supplier<? extends Agent> program;
    private final Queue<Robot> robots = new ConcurrentLinkedQueue<>();

    RobotHost(ParentProcess judge, Supplier<? extends Agent> program) {
        this.judge = judge;
        this.program = program;
    }

    /**
     * Request for a robot.
     *
     * @param id identifier of the request; each answer to it begins with this number
     * @param door TCP port of the trial, or the name of its socket in the sandbox
     */
    record Call(int id, String door, String team, int number, TeamSide side) {

        static Call read(String line) {
            String[] words = line.split(" ", -1);
            return new Call(
                    Integer.parseInt(words[0]),
                    words[1],
                    words[2],
                    Integer.parseInt(words[3]),
                    TeamSide.valueOf(words[4]));
        }

        String line() {
            return id + " " + door + " " + team + " " + number + " " + side;
        }
    }

    void serve() throws InterruptedException {
        judge.answer(READY);
        TimerTask look = new TimerTask() {
            @Override
            public void run() {
                robots.forEach(Robot::look);
            }
        };
        new Timer("progress", true).schedule(look, 0, ProgressWatchdog.TICK_MILLISECONDS);
        while (true) {
            Robot robot = new Robot(Call.read(judge.nextCall()));
            robots.add(robot);
            Thread thread = new Thread(robot::run, "robot");
            thread.setDaemon(true);
            thread.start();
        }
    }

    private final class Robot {

        private final Call call;
        private final ProgressWatchdog progress = new ProgressWatchdog();
        private volatile Optional<TcpAgentLink> link = Optional.empty();
        private Departure departure = new Departure(Cause.NONE, "", "");
        private boolean gone;

        Robot(Call call) {
            this.call = call;
        }

        void look() {
            progress.tick();
            if (progress.isExhausted()) {
                leave(new Departure(Cause.ENDLESS, progress.place().orElse(""), ""));
            }
        }

        void run() {
            progress.begin();
            try (TcpAgentLink connection = TcpAgentLink.connect(HERE, port())) {
                link = Optional.of(connection);
                play(connection);
            } catch (VirtualMachineError exhausted) {
                throw exhausted;
            } catch (IOException disconnected) {
                // The trial has closed the connection, which is not the program's fault.
            } catch (RuntimeException | Error mistake) {
                leave(new Departure(Cause.THROWN, ProgramPlace.of(mistake), ""));
            } finally {
                progress.end();
                leave(departure);
            }
        }

        private int port() throws IOException {
            return Files.isDirectory(Sandbox.DOOR)
                    ? Relay.open(0, Sandbox.DOOR.resolve(call.door()))
                    : Integer.parseInt(call.door());
        }

        private void play(TcpAgentLink connection) throws IOException {
            AgentDriver driver = new AgentDriver(program.get());
            driver.introduce(Options.none().withTeam(call.team()).withNumber(call.number()), call.side());
            Watchdog watchdog = driver.watch(this::noteSlowness);
            try {
                play(connection, driver);
            } finally {
                watchdog.close();
            }
        }

        private void play(TcpAgentLink connection, AgentDriver driver) throws IOException {
            PerceptorMessageReader reader = new PerceptorMessageReader();
            MessageBuffer message = new MessageBuffer();
            MessageBuffer answer = new MessageBuffer();
            EffectorMessageWriter writer = new EffectorMessageWriter(answer);
            writer.synchronise();
            connection.send(answer);
            while (connection.receive(message)) {
                answer.clear();
                List<EffectorCommand> commands = driver.respond(reader.read(message));
                commands.forEach(writer::write);
                if (commands.isEmpty()) {
                    writer.synchronise(); // keeps the robot still after it has left the game
                }
                if (driver.hasFailed()) {
                    departure = new Departure(Cause.FAILED_STEP, "", "");
                }
                progress.progress();
                connection.send(answer);
            }
        }

        /**
         * Stops a program that sleeps during its cycles, because its trial would take minutes. Slow computation is only
         * reported.
         */
        private void noteSlowness(Slowness slowness) {
            String place = " at " + slowness.cause().place();
            Departure idle =
                    new Departure(Cause.IDLE, CycleOwner.FRAMEWORK.finding(slowness, place), slowness.advice());
            judge.answer(SLOW + idle.line());
            if (slowness.isIdle() && slowness.milliseconds() >= MAX_IDLE_MILLISECONDS) {
                leave(idle);
            }
        }

        /** Reports why the robot is leaving, then closes its connection. Has no effect if called again. */
        private synchronized void leave(Departure why) {
            if (!gone) {
                gone = true;
                robots.remove(this);
                judge.answer(call.id() + " " + why.line());
                link.ifPresent(TcpAgentLink::close);
            }
        }
    }
}
