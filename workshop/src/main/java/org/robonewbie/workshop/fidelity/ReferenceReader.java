package org.robonewbie.workshop.fidelity;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.GZIPInputStream;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Parser of recordings: JSON lines, plain or compressed with gzip. The first line is a header; every other line
 * describes one cycle. A new run starts where {@code case} changes, where {@code joint}, {@code speed} or {@code place}
 * changes, or where time jumps back. Null fields count as missing; every field except {@code t} may be missing.
 */
final class ReferenceReader {

    private static final String GZIP_ENDING = ".gz";
    private static final String ENDING = ".jsonl";
    private static final double A_BIT = 0.005;

    private final String fileName;
    private final List<RecordedRun> runs = new ArrayList<>();
    private List<RecordedRow> rows = new ArrayList<>();
    private String run = "";
    private String header = "";
    private int lineNumber;

    private ReferenceReader(String fileName) {
        this.fileName = fileName;
    }

    /** {@return whether a file name ends in .jsonl or .jsonl.gz} */
    static boolean isRecording(String fileName) {
        return fileName.endsWith(ENDING) || fileName.endsWith(ENDING + GZIP_ENDING);
    }

    /**
     * Parses a recording.
     *
     * @param fileName file name, which determines whether the contents are compressed
     * @param content contents of the file
     * @return the recording, with at least one run
     * @throws IOException if it cannot be parsed or contains no positions; the message contains the file name
     */
    static Recording read(String fileName, InputStream content) throws IOException {
        ReferenceReader reader = new ReferenceReader(fileName);
        InputStream plain = fileName.endsWith(GZIP_ENDING) ? new GZIPInputStream(content) : content;
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(plain, StandardCharsets.UTF_8))) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                reader.readLine(line);
            }
        }
        return reader.recording();
    }

    private Recording recording() throws IOException {
        endRun();
        if (runs.isEmpty()) {
            throw new IOException(
                    "The recording " + name() + " contains neither torso nor ball positions. It needs one of them.");
        }
        return new Recording(name(), header, List.copyOf(runs));
    }

    private String name() {
        return fileName.substring(0, fileName.lastIndexOf(ENDING));
    }

    /**
     * Ends the current run. Drops the rows of a robot before the first one that contains a position; a ball's start is in the name of its
     * case, so its rows stay.
     */
    private void endRun() {
        if (rows.stream().anyMatch(ReferenceReader::isPlaced)) {
            List<RecordedRow> replayed = rows.stream()
                    .dropWhile(row -> !isPlaced(row) && !row.jointDegrees().isEmpty())
                    .toList();
            runs.add(new RecordedRun(run, replayed));
        }
        rows = new ArrayList<>();
    }

    private static boolean isPlaced(RecordedRow row) {
        return row.torso().isPresent() || row.ball().isPresent();
    }

    private void add(String runName, RecordedRow row) {
        boolean earlier =
                !rows.isEmpty() && row.seconds() < rows.get(rows.size() - 1).seconds() - A_BIT;
        if (earlier || !runName.equals(run)) {
            endRun();
            run = runName;
        }
        rows.add(row);
    }

    private void readLine(String line) throws IOException {
        lineNumber++;
        if (line.isBlank()) {
            return;
        }
        try {
            JsonObject row = JsonParser.parseString(line).getAsJsonObject();
            row.entrySet().removeIf(field -> field.getValue().isJsonNull());
            if (row.has("header")) {
                header = row.get("header").toString();
            } else {
                add(runName(row), row(row));
            }
        } catch (JsonParseException
                | ClassCastException
                | IllegalStateException
                | NullPointerException
                | UnsupportedOperationException
                | IndexOutOfBoundsException
                | NumberFormatException e) {
            throw new IOException(
                    fileName + ", line " + lineNumber
                            + " is not a recording row: expected a JSON object with t and hj, torso or ball.",
                    e);
        }
    }

    private static String runName(JsonObject row) {
        if (row.has("case")) {
            return row.get("case").getAsString();
        }
        return row.has("place") ? text(row, "joint") + " " + text(row, "speed") + " " + text(row, "place") : "";
    }

    private static RecordedRow row(JsonObject row) {
        return new RecordedRow(
                row.get("t").getAsDouble(),
                joints(row),
                vector(row, "acc"),
                vector(row, "gyr"),
                footForces(row),
                Optional.ofNullable(row.get("torso")).map(torso -> pose(torso.getAsJsonObject())),
                vector(row, "ball"),
                text(row, "pm"),
                row.has("sent") ? text(row, "sent") : text(row, "cmd"));
    }

    private static Map<String, Double> joints(JsonObject row) {
        Map<String, Double> joints = new LinkedHashMap<>();
        if (row.has("hj")) {
            row.getAsJsonObject("hj").asMap().forEach((name, angle) -> joints.put(name, angle.getAsDouble()));
        }
        return joints;
    }

    private static Optional<FootForces> footForces(JsonObject row) {
        return Optional.ofNullable(row.getAsJsonObject("frp"))
                .map(plates -> new FootForces(
                        footForce(plates, "lf"),
                        footForce(plates, "rf"),
                        footForce(plates, "lf1"),
                        footForce(plates, "rf1")));
    }

    private static Optional<FootForce> footForce(JsonObject plates, String name) {
        return Optional.ofNullable(plates.getAsJsonObject(name))
                .map(plate -> new FootForce(vector(plate.getAsJsonArray("c")), vector(plate.getAsJsonArray("f"))));
    }

    private static BodyPose pose(JsonObject torso) {
        return new BodyPose(
                vector(torso.getAsJsonArray("pos")),
                TorsoAngles.rotation(
                        torso.get("yaw").getAsDouble(),
                        torso.get("pitch").getAsDouble(),
                        torso.get("roll").getAsDouble(),
                        torso.get("up").getAsDouble()));
    }

    private static String text(JsonObject row, String name) {
        return row.has(name) ? row.get(name).getAsString() : "";
    }

    private static Optional<Vector3> vector(JsonObject row, String name) {
        return Optional.ofNullable(row.get(name)).map(value -> vector(value.getAsJsonArray()));
    }

    private static Vector3 vector(JsonArray numbers) {
        return new Vector3(
                numbers.get(0).getAsDouble(),
                numbers.get(1).getAsDouble(),
                numbers.get(2).getAsDouble());
    }
}
