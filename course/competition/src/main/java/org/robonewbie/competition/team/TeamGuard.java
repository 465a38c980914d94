package org.robonewbie.competition.team;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * The first class in the process of a team: it starts the team's program, and ends it with all that belongs to it as soon as
 * whoever holds the competition is gone, which it notices by the end of its input.
 */
public final class TeamGuard {

    /** Requests a class to be started. */
    static final String CLASS = "class";

    /** Requests a command to be started. */
    static final String COMMAND = "command";

    private TeamGuard() {}

    /**
     * Starts a program.
     *
     * @param arguments {@code class} and the name of a class, or {@code command} and a command; then arguments
     * @throws IOException if the command does not exist
     * @throws InterruptedException never in practice
     * @throws ReflectiveOperationException if the class cannot be started
     */
    public static void main(String[] arguments) throws IOException, InterruptedException, ReflectiveOperationException {
        watch(System.in);
        moveIn();
        System.setIn(new ByteArrayInputStream(new byte[0]));
        List<String> program = List.of(arguments).subList(1, arguments.length);
        if (arguments[0].equals(COMMAND)) {
            runCommand(program);
        } else {
            runClass(program.get(0), program.subList(1, program.size()));
        }
    }

    /** Behind a fence, fills the empty home with the team's files, and opens the port that leads to the simulator. */
    private static void moveIn() throws IOException {
        if (Files.exists(Fence.DOOR)) {
            if (Files.isDirectory(Fence.TEAM)) {
                TeamFolder.of(Fence.TEAM, List.of()).copyTo(Fence.HOME);
            }
            Relay.open(Fence.PORT, Fence.DOOR);
        }
    }

    private static void runCommand(List<String> command) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.INHERIT)
                .start();
        process.getOutputStream().close();
        Runtime.getRuntime().halt(process.waitFor());
    }

    private static void runClass(String name, List<String> arguments) throws ReflectiveOperationException {
        try {
            Class<?> type = Class.forName(name);
            String[] words = arguments.toArray(String[]::new);
            Optional<MainMethod> own = MainMethod.of(type);
            if (own.isPresent()) {
                own.get().call(words);
            } else {
                type.getMethod("main", String[].class).invoke(null, (Object) words); // an inherited one
            }
        } catch (InvocationTargetException thrown) {
            Throwable cause = Objects.requireNonNull(thrown.getCause());
            System.err.println(name + " ended with " + cause);
            Arrays.stream(cause.getStackTrace()).limit(10).forEach(line -> System.err.println("    at " + line));
            System.exit(1);
        }
    }

    private static void watch(InputStream input) {
        Thread thread = new Thread(
                () -> {
                    try {
                        input.transferTo(OutputStream.nullOutputStream());
                    } catch (IOException closed) {
                        // That is the end, too.
                    }
                    ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
                    Runtime.getRuntime().halt(1);
                },
                "team-guard");
        thread.setDaemon(true);
        thread.start();
    }
}
