package org.robonewbie.app.soak;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** A server in a process of its own, whose memory can be looked at. */
final class SoakServer implements AutoCloseable {

    private static final Pattern PORTS = Pattern.compile("Agents can join on port (\\d+), monitors on port (\\d+)");
    private static final Pattern USED = Pattern.compile("used (\\d+)K");
    private static final int KILOBYTES_PER_MEGABYTE = 1024;

    private final Process process;
    private final int agentPort;
    private final int monitorPort;
    private final List<String> sentences = new ArrayList<>();
    private final Thread listener;

    /**
     * Starts the server.
     *
     * @param mostKilobytes no file that it writes gets larger, as if the disk were full
     * @param options of {@code robonewbie simulator}
     */
    SoakServer(long mostKilobytes, String... options) throws IOException {
        List<String> command =
                new ArrayList<>(List.of("bash", "-c", "ulimit -f " + mostKilobytes + "; exec \"$@\"", "soak"));
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), "org.robonewbie.app.Main", "simulator"));
        command.addAll(List.of("--agent-port", "0", "--monitor-port", "0"));
        command.addAll(List.of(options));
        process = new ProcessBuilder(command).redirectErrorStream(true).start();
        BufferedReader console = process.inputReader(StandardCharsets.UTF_8);
        Matcher ports = awaitPorts(console);
        agentPort = Integer.parseInt(ports.group(1));
        monitorPort = Integer.parseInt(ports.group(2));
        listener = new Thread(() -> console.lines().forEach(this::note), "console of the server");
        listener.start();
    }

    private Matcher awaitPorts(BufferedReader console) throws IOException {
        for (String line = console.readLine(); line != null; line = console.readLine()) {
            note(line);
            Matcher ports = PORTS.matcher(line);
            if (ports.find()) {
                return ports;
            }
        }
        throw new IOException("The server has not started: " + sentences);
    }

    /** Keeps what is not said again and again. */
    private synchronized void note(String line) {
        if (line.contains("recording")) {
            sentences.add(line);
        }
    }

    int agentPort() {
        return agentPort;
    }

    int monitorPort() {
        return monitorPort;
    }

    /** What it has said of its recording. */
    synchronized List<String> sentences() {
        return List.copyOf(sentences);
    }

    /** The memory that is in use after a collection of garbage. */
    long megabytes() throws IOException {
        jcmd("GC.run");
        Matcher used = USED.matcher(jcmd("GC.heap_info"));
        if (!used.find()) {
            throw new IOException("The server's memory is not known.");
        }
        return Long.parseLong(used.group(1)) / KILOBYTES_PER_MEGABYTE;
    }

    /** Its open files and connections. */
    long openFiles() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("/proc", Long.toString(process.pid()), "fd"))) {
            return files.count();
        }
    }

    private String jcmd(String order) throws IOException {
        Process asked = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "jcmd").toString(),
                        Long.toString(process.pid()),
                        order)
                .redirectErrorStream(true)
                .start();
        try (BufferedReader answer =
                new BufferedReader(new InputStreamReader(asked.getInputStream(), StandardCharsets.UTF_8))) {
            return String.join("\n", answer.lines().toList());
        }
    }

    /** Waits for its end and returns the exit code. */
    int awaitEnd() throws InterruptedException {
        int code = process.waitFor();
        listener.join();
        return code;
    }

    @Override
    public void close() {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        Objects.requireNonNull(process.destroyForcibly());
        try {
            process.waitFor(10, TimeUnit.SECONDS);
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
        }
    }
}
