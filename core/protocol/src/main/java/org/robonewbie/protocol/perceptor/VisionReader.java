package org.robonewbie.protocol.perceptor;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import org.robonewbie.nao.BodyPart;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenMarking;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Parser for the perceptor {@code See}. */
final class VisionReader {

    private static final Landmark[] LANDMARKS = Landmark.values();
    private static final BodyPart[] BODY_PARTS = BodyPart.values();

    private final SexpReader reader;
    private final KnownWords words;
    private final String[] landmarkNames;
    private final List<FieldMarking> knownMarkings;
    private final List<SeenLandmark> landmarks = new ArrayList<>();
    private final List<SeenMarking> markings = new ArrayList<>();
    private final List<SeenPlayer> players = new ArrayList<>();
    private final List<SeenLine> lines = new ArrayList<>();
    private final List<SeenBodyPart> parts = new ArrayList<>();
    private PolarPosition position = new PolarPosition(0, 0, 0);
    private Optional<PolarPosition> ball = Optional.empty();
    private Optional<Vector3> ownPosition = Optional.empty();
    private OptionalDouble ownOrientation = OptionalDouble.empty();
    private Optional<Vector3> ballPosition = Optional.empty();

    VisionReader(
            SexpReader reader,
            KnownWords words,
            Function<Landmark, String> landmarkName,
            List<FieldMarking> knownMarkings) {
        this.reader = reader;
        this.words = words;
        this.knownMarkings = knownMarkings;
        this.landmarkNames = Stream.of(LANDMARKS).map(landmarkName).toArray(String[]::new);
    }

    /** Parses the list whose name is the current atom. Returns empty if the list is incomplete. */
    Optional<Vision> read() {
        clear();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            readItem();
        }
        if (reader.token() == Token.END) {
            return Optional.empty();
        }
        return Optional.of(
                new Vision(landmarks, ball, players, lines, ownPosition, ownOrientation, ballPosition, markings));
    }

    private void clear() {
        landmarks.clear();
        markings.clear();
        players.clear();
        lines.clear();
        ball = Optional.empty();
        ownPosition = Optional.empty();
        ownOrientation = OptionalDouble.empty();
        ballPosition = Optional.empty();
    }

    private void readItem() {
        if (reader.atomIs("L")) {
            readLine();
        } else if (reader.atomIs("P")) {
            readPlayer();
        } else if (reader.atomIs("B")) {
            ball = readPosition(reader.depth()) ? Optional.of(position) : Optional.empty();
        } else if (reader.atomIs("mypos")) {
            ownPosition = Readings.vector(reader);
        } else if (reader.atomIs("myorien")) {
            ownOrientation = Readings.number(reader);
        } else if (reader.atomIs("ballpos")) {
            ballPosition = Readings.vector(reader);
        } else {
            readLandmark();
        }
    }

    private void readLandmark() {
        for (int i = 0; i < LANDMARKS.length; i++) {
            if (reader.atomIs(landmarkNames[i])) {
                if (readPosition(reader.depth())) {
                    landmarks.add(new SeenLandmark(LANDMARKS[i], position));
                }
                return;
            }
        }
        for (FieldMarking marking : knownMarkings) {
            if (reader.atomIs(marking.leagueName())) {
                if (readPosition(reader.depth())) {
                    markings.add(new SeenMarking(marking, position));
                }
                return;
            }
        }
    }

    private void readLine() {
        int depth = reader.depth();
        boolean hasStart = readPosition(depth);
        PolarPosition start = position;
        if (hasStart && readPosition(depth)) {
            lines.add(new SeenLine(start, position));
        }
    }

    private void readPlayer() {
        parts.clear();
        String team = "";
        int number = 0;
        Optional<PolarPosition> whole = Optional.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("team")) {
                team = reader.next() == Token.ATOM ? words.of(reader) : "";
            } else if (reader.atomIs("id")) {
                number = reader.next() == Token.ATOM ? reader.integer() : 0;
            } else if (reader.atomIs("pol")) {
                whole = readPolar() ? Optional.of(position) : Optional.empty();
            } else {
                readBodyPart();
            }
        }
        players.add(new SeenPlayer(team, number, parts, whole));
    }

    private void readBodyPart() {
        for (BodyPart part : BODY_PARTS) {
            if (reader.atomIs(part.simSparkName())) {
                if (readPosition(reader.depth())) {
                    parts.add(new SeenBodyPart(part, position));
                }
                return;
            }
        }
    }

    /** Finds the next {@code (pol …)} at the given depth and stores it in {@link #position}. */
    private boolean readPosition(int depth) {
        while (reader.nextList(depth)) {
            if (reader.atomIs("pol")) {
                return readPolar();
            }
        }
        return false;
    }

    private boolean readPolar() {
        if (!reader.nextNumber()) {
            return false;
        }
        double distance = reader.number();
        if (!reader.nextNumber()) {
            return false;
        }
        double horizontal = reader.number();
        if (!reader.nextNumber()) {
            return false;
        }
        position = new PolarPosition(distance, horizontal, reader.number());
        return true;
    }
}
