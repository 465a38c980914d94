package org.robonewbie.programs.process;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.SocketAddress;
import java.net.UnixDomainSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.file.TemporaryFolder;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.programs.ClassPath;
import org.robonewbie.programs.JavaSource;
import org.robonewbie.programs.process.Departure.Cause;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.SensorReadings;

/**
 * A student's program in a child process that provides robots for trials in this process. From the child, this process
 * receives only the robots' commands and the reasons why they leave.
 *
 * <pre>{@code
 * try (RobotProcess program = new RobotProcess(request, sandbox, System.out::println);
 *         RobotProcess.Entrance entrance = program.entrance()) {
 *     Trial trial = Trial.served(scene, 1, entrance.get());
 * }
 * }</pre>
 */
public final class RobotProcess implements AutoCloseable {

    /**
     * Prefix of each line printed by the student's program, so that no line can be mistaken for the grader's output.
     */
    public static final String MARK = "  program| ";

    private static final double SECONDS_TO_LEAVE = 3;
    private static final double SECONDS_TO_END = 0.5;

    private final Map<Integer, CompletableFuture<Departure>> robots = new ConcurrentHashMap<>();
    private final AtomicInteger calls = new AtomicInteger();
    private final Optional<TemporaryFolder> sockets;
    private final ChildProcess process;
    private volatile boolean ready;
    private volatile Optional<Departure> slowness = Optional.empty();

    /**
     * The program to start.
     *
     * @param program name of an example, a class or a Java file
     * @param classPath folders and jars with the student's classes
     * @param folder working directory of the program, which contains its motions; read-only in a sandbox
     * @param isAlone whether no other program uses this directory
     */
    public record Request(String program, List<Path> classPath, Path folder, boolean isAlone) {

        /** Makes all paths absolute. */
        public Request {
            classPath = new ClassPath(classPath).places();
            folder = folder.toAbsolutePath().normalize();
        }

        private SandboxPolicy policy(Path sockets) throws IOException {
            List<Path> readable = new ArrayList<>(
                    JavaCommand.readable(ClassPath.ofThisProgram().with(classPath)));
            if (program.endsWith(".java")) {
                Path file = folder.resolve(program);
                readable.add(JavaSource.of(file, TextFile.read(file).content()).rootFolder());
            }
            return new SandboxPolicy(
                    readable, hiddenAtHome(), Optional.of(folder), Optional.of(sockets), Optional.empty());
        }

        /**
         * Returns the files with the user's keys and settings, which are hidden if the program's folder is the home folder
         * itself.
         */
        private static List<Path> hiddenAtHome() {
            try (Stream<Path> entries = Files.list(Path.of(System.getProperty("user.home", "/")))) {
                return entries.filter(
                                entry -> String.valueOf(entry.getFileName()).startsWith("."))
                        .toList();
            } catch (IOException none) {
                return List.of();
            }
        }
    }

    /**
     * Starts a program.
     *
     * @param request the program
     * @param sandbox the sandbox
     * @param lines receives each line that the process prints; lines printed by the program have the prefix {@link #MARK}
     * @throws IOException if it cannot be started
     */
    public RobotProcess(Request request, Sandbox sandbox, Consumer<String> lines) throws IOException {
        List<String> command = JavaCommand.ofProgram(
                JavaCommand.MEGABYTES,
                List.of(),
                ClassPath.ofThisProgram(),
                List.of(ProgramMain.ROBOTS, request.program(), new ClassPath(request.classPath()).text()));
        sockets = sandbox.isUp() ? Optional.of(TemporaryFolder.create("doors")) : Optional.empty();
        process = ChildProcess.start(
                sockets.isPresent()
                        ? sandbox.enclose(command, request.policy(sockets.get().path()))
                        : command,
                request.folder(),
                request.isAlone(),
                ProgramOutput.of(line -> lines.accept((ready ? MARK : "") + line), this::receive),
                Limits.UNTIMED);
    }

    /** Parses an answer. A forged answer can affect only the program's own robots. */
    private void receive(String answer) {
        try {
            if (answer.isEmpty()) {
                robots.values().forEach(robot -> robot.cancel(false));
            } else if (answer.equals(RobotHost.READY)) {
                ready = true;
            } else if (answer.startsWith(RobotHost.SLOW)) {
                slowness = Optional.of(Departure.read(answer.substring(RobotHost.SLOW.length())));
            } else {
                int id = Integer.parseInt(answer.substring(0, answer.indexOf(' ')));
                Departure why = Departure.read(answer.substring(answer.indexOf(' ') + 1));
                Optional.ofNullable(robots.get(id)).ifPresent(robot -> robot.complete(why));
            }
        } catch (IllegalArgumentException | IndexOutOfBoundsException forged) {
            // An invalid answer is ignored.
        }
    }

    /** {@return whether the program could be compiled and loaded} */
    public boolean isReady() {
        return ready;
    }

    /** {@return the reason why the program is slow; empty if it is not} */
    public Optional<Departure> slowness() {
        return slowness;
    }

    /** {@return the first lines of the output, such as compiler messages} */
    public List<String> lines() {
        return process.output().lines();
    }

    /** {@return the last part of the output} */
    public String output() {
        return process.output().end();
    }

    /** {@return the exit code; 1 if the process is still running or was killed for exceeding a limit} */
    public int exitCode() {
        process.awaitEnd(SECONDS_TO_END);
        return process.exitCode().orElse(1);
    }

    private Departure ending() {
        int code = exitCode();
        return process.excess()
                .map(limit -> new Departure(
                        limit == ChildProcess.Excess.MEMORY ? Cause.MEMORY : Cause.EXCESS,
                        String.valueOf(JavaCommand.MEGABYTES),
                        ""))
                .orElse(new Departure(Cause.EXIT, String.valueOf(code), ""));
    }

    /**
     * Opens a port for the robots of one trial.
     *
     * @return the open port
     * @throws IOException if no port is free
     */
    public Entrance entrance() throws IOException {
        String name = "door" + calls.incrementAndGet();
        SocketAddress address = sockets.<SocketAddress>map(
                        folder -> UnixDomainSocketAddress.of(folder.path().resolve(name)))
                .orElse(new InetSocketAddress(InetAddress.getByAddress(new byte[] {127, 0, 0, 1}), 0));
        return new Entrance(address, name);
    }

    /** Port to which the robots of one trial connect. Robots of concurrent trials are refused. */
    public final class Entrance implements Supplier<Controller>, AutoCloseable {

        private final GuestDoor door;
        private final String name;
        private final List<CompletableFuture<Departure>> own = new ArrayList<>();

        private Entrance(SocketAddress address, String name) throws IOException {
            this.name = name;
            this.door = GuestDoor.open(address, this::isWelcome);
        }

        private boolean isWelcome(InetSocketAddress guest) {
            return !ProcessTree.hasConnections() || process.holds(guest.getPort(), door.port());
        }

        /**
         * {@return the controller of a robot; the robot is requested from the process as soon as its team and number
         * are known}
         */
        @Override
        public Controller get() {
            return new CalledRobot(this);
        }

        private Controller call(String team, int number, TeamSide side) {
            int id = calls.incrementAndGet();
            CompletableFuture<Departure> departure = new CompletableFuture<>();
            robots.put(id, departure);
            own.add(departure);
            String address = sockets.isPresent() ? name : String.valueOf(door.port());
            if (!process.call(new RobotHost.Call(id, address, team, number, side).line())) {
                departure.cancel(false);
            }
            return door.await(() -> !departure.isDone() && process.isRunning());
        }

        /**
         * Returns why the robots left a finished trial: the reason reported by the process, or the exit of the process
         * itself.
         *
         * @return the reason; empty if they stayed until the end of the trial, or if the program was never ready
         */
        public Optional<Departure> departure() {
            return (ready ? own : List.<CompletableFuture<Departure>>of())
                    .stream()
                            .flatMap(robot -> departure(robot).stream())
                            .filter(why -> why.cause() != Cause.NONE)
                            .findFirst();
        }

        private Optional<Departure> departure(CompletableFuture<Departure> robot) {
            try {
                return Optional.of(robot.get((long) (SECONDS_TO_LEAVE * 1000), TimeUnit.MILLISECONDS));
            } catch (InterruptedException stopped) {
                Thread.currentThread().interrupt();
                return Optional.empty();
            } catch (ExecutionException | TimeoutException | CancellationException silent) {
                return process.isRunning() && !process.awaitEnd(SECONDS_TO_END)
                        ? Optional.empty()
                        : Optional.of(ending());
            }
        }

        @Override
        public void close() {
            door.close();
        }
    }

    private static final class CalledRobot implements Controller {

        private final Entrance entrance;
        private Optional<Controller> guest = Optional.empty();

        CalledRobot(Entrance entrance) {
            this.entrance = entrance;
        }

        @Override
        public void introduce(String team, int number, TeamSide side) {
            guest = Optional.of(entrance.call(team, number, side));
        }

        @Override
        public List<EffectorCommand> respond(SensorReadings readings) {
            return guest.orElseThrow().respond(readings);
        }

        @Override
        public void close() {
            guest.ifPresent(Controller::close);
        }
    }

    /** Kills the program and all of its processes. */
    @Override
    public void close() {
        process.close();
        sockets.ifPresent(TemporaryFolder::close);
    }
}
