package org.robonewbie.workshop.fidelity;

import java.io.BufferedReader;
import java.io.EOFException;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NotDirectoryException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipException;

/**
 * Replays recordings of a real rcssserver3d in the simulated world, without noise, and measures the deviation.
 *
 * <p>A recording is a file of JSON lines, plain or compressed: a header, then one line per cycle of 20 ms with {@code
 * t}, {@code hj}, {@code acc}, {@code gyr}, {@code frp}, {@code torso} and {@code sent}, or with {@code case} and
 * {@code ball}. Commands on one line take effect on the next.
 *
 * <pre>{@code
 * System.out.print(FidelityBench.run(AgentRoute.NONE).toTable());
 * }</pre>
 */
public final class FidelityBench {

    private static final String SHIPPED = "recordings/";
    private static final String INDEX = SHIPPED + "index.txt";

    private FidelityBench() {}

    /**
     * Replays the shipped recordings.
     *
     * @param route transport for commands and measurements
     * @return the deviation from each recording
     * @throws IOException if a recording cannot be read
     */
    public static FidelityReport run(AgentRoute route) throws IOException {
        List<RecordingFidelity> results = new ArrayList<>();
        for (String name : shippedNames()) {
            results.add(Replay.of(readShipped(name), route));
        }
        return new FidelityReport(results, List.of());
    }

    /**
     * Replays all recordings in a directory. Files that cannot be parsed are listed in the report.
     *
     * @param directory directory of the recordings; files whose names do not end in .jsonl or .jsonl.gz are ignored
     * @param route transport for commands and measurements
     * @return the deviation from each recording
     * @throws IOException if there is no recording or the directory cannot be read; the message states the cause
     */
    public static FidelityReport run(Path directory, AgentRoute route) throws IOException {
        List<RecordingFidelity> results = new ArrayList<>();
        List<String> problems = new ArrayList<>();
        for (Path file : recordingsIn(directory)) {
            try {
                results.add(Replay.of(read(file), route));
            } catch (EOFException | ZipException e) {
                problems.add(file.getFileName() + " is damaged (" + e.getMessage() + "). Copy or compress it again.");
            } catch (IOException e) {
                problems.add(String.valueOf(e.getMessage()));
            }
        }
        return new FidelityReport(results, problems);
    }

    /**
     * Reads a recording.
     *
     * @param file a file whose name ends in .jsonl or .jsonl.gz
     * @return the recording
     * @throws IOException if it cannot be read; the message states the cause
     */
    public static Recording read(Path file) throws IOException {
        String name = String.valueOf(file.getFileName());
        if (!ReferenceReader.isRecording(name)) {
            throw new IOException(file + " is not a recording. Choose a file whose name ends in .jsonl or .jsonl.gz.");
        }
        try (InputStream content = Files.newInputStream(file)) {
            return ReferenceReader.read(name, content);
        }
    }

    /** {@return the file names of the shipped recordings in alphabetical order} */
    static List<String> shippedNames() throws IOException {
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(open(INDEX), StandardCharsets.UTF_8))) {
            return lines.lines().filter(line -> !line.isBlank()).toList();
        }
    }

    /** Reads one of the {@link #shippedNames()}. */
    static Recording readShipped(String fileName) throws IOException {
        try (InputStream content = open(SHIPPED + fileName)) {
            return ReferenceReader.read(fileName, content);
        }
    }

    private static InputStream open(String resource) throws IOException {
        InputStream stream = FidelityBench.class.getResourceAsStream(resource);
        if (stream == null) {
            throw new FileNotFoundException("The recording " + resource + " is missing from the JAR file.");
        }
        return stream;
    }

    private static List<Path> recordingsIn(Path directory) throws IOException {
        if (!Files.isDirectory(directory)) {
            throw new NotDirectoryException(
                    directory + " is not a directory. Choose one that contains recordings (*.jsonl or *.jsonl.gz).");
        }
        try (Stream<Path> files = Files.list(directory)) {
            List<Path> recordings = files.filter(file ->
                            ReferenceReader.isRecording(file.getFileName().toString()))
                    .sorted()
                    .toList();
            if (recordings.isEmpty()) {
                throw new FileNotFoundException(directory + " contains no recordings (*.jsonl or *.jsonl.gz).");
            }
            return recordings;
        }
    }
}
