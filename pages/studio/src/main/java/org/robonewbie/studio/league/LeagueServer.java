package org.robonewbie.studio.league;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The installed RCSSServerMJ, run as a separate process. */
public final class LeagueServer implements AutoCloseable {

    /** The command that installs the server. */
    public static final String INSTALLATION = "pip install rcsssmj==0.2.1";

    private static final String COMMAND = "rcssservermj";
    private static final String READY = "Listening for monitor connections";

    private final Process process;

    private LeagueServer(Process process) {
        this.process = process;
    }

    /**
     * Looks for the server in the folders of the environment variable {@code PATH}.
     *
     * @return the command that starts it; empty if it is not installed
     */
    public static Optional<Path> find() {
        String path = Optional.ofNullable(System.getenv("PATH")).orElse("");
        return Arrays.stream(path.split(File.pathSeparator))
                .filter(folder -> !folder.isBlank())
                .flatMap(folder -> Stream.of(COMMAND, COMMAND + ".exe").map(name -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
    }

    /**
     * Starts the server on this computer in sync mode: it waits in each cycle until all agents have answered.
     *
     * @param agentPort TCP port for agents
     * @param monitorPort TCP port for monitors
     * @param options further options, such as {@code --no-realtime}
     * @return the running server
     * @throws IOException if it is not installed or exits during start-up; the message says what to do
     */
    public static LeagueServer start(int agentPort, int monitorPort, String... options) throws IOException {
        Path command = find().orElseThrow(() -> new IOException("No RCSSServerMJ is running on agent port " + agentPort
                + ", and none is installed. Install it with \"" + INSTALLATION
                + "\" in a Python environment that is active in this terminal."));
        Path folder = Files.createTempDirectory("rcssservermj"); // it writes a log into its working directory
        List<String> words = new ArrayList<>(List.of(
                command.toString(),
                "--sync",
                "--no-render",
                "--host=127.0.0.1",
                "--aport=" + agentPort,
                "--mport=" + monitorPort));
        words.addAll(List.of(options));
        Process process = new ProcessBuilder(words)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        LeagueServer server = new LeagueServer(process);
        Runtime.getRuntime().addShutdownHook(new Thread(server::close, "end-of-league-server"));
        server.awaitReady();
        return server;
    }

    /** Waits until the server accepts connections, and discards its further output. */
    private void awaitReady() throws IOException {
        BufferedReader output =
                new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
        String last = "";
        for (String line = output.readLine(); line != null; line = output.readLine()) {
            if (line.contains(READY)) {
                Thread reader = new Thread(() -> output.lines().forEach(ignored -> {}), "output-of-league-server");
                reader.setDaemon(true);
                reader.start();
                return;
            }
            last = line;
        }
        throw new IOException("RCSSServerMJ ended while it was starting: " + last);
    }

    /** Ends the server. Closing again has no effect. */
    @Override
    public void close() {
        process.destroy();
    }
}
