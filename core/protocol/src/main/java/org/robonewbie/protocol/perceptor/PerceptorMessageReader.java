package org.robonewbie.protocol.perceptor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles.ExtraHinge;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/**
 * Parser for perceptor messages. Unknown lists are skipped at any depth and incomplete lists are ignored, so parsing never
 * fails. Each robot has its own reader. Not thread-safe.
 *
 * <pre>{@code
 * link.receive(buffer);
 * PerceptorMessage message = reader.read(buffer);
 * }</pre>
 */
public final class PerceptorMessageReader {

    private static final List<String> JOINT_NAMES =
            Arrays.stream(Joint.values()).map(Joint::perceptorName).toList();
    private static final int MAX_HEARD = 100;

    private final SexpReader reader = new SexpReader();
    private final KnownWords words = new KnownWords();
    private final OrderedNames joints = new OrderedNames(JOINT_NAMES);
    private final VisionReader visionReader = new VisionReader(reader, words, Landmark::simSparkName, List.of());
    private final List<Heard> heard = new ArrayList<>();
    private final List<ExtraHinge> extraHinges = new ArrayList<>();
    private double[] jointAngles = new double[Joint.COUNT];
    private int presentJoints;
    private OptionalDouble seconds = OptionalDouble.empty();
    private Optional<GameState> gameState = Optional.empty();
    private Optional<Vector3> gyro = Optional.empty();
    private Optional<Vector3> accelerometer = Optional.empty();
    private Optional<FootForce> leftFoot = Optional.empty();
    private Optional<FootForce> rightFoot = Optional.empty();
    private Optional<FootForce> leftToe = Optional.empty();
    private Optional<FootForce> rightToe = Optional.empty();
    private Optional<Vision> vision = Optional.empty();

    /** Creates a reader. */
    public PerceptorMessageReader() {}

    /**
     * Parses a message.
     *
     * @param message the message as received from the simulator
     * @return the sensor readings
     */
    public PerceptorMessage read(MessageBuffer message) {
        clear();
        reader.start(message);
        while (reader.nextList(0)) {
            readPerceptor();
        }
        return new PerceptorMessage(
                seconds,
                gameState,
                heard,
                gyro,
                accelerometer,
                new JointAngles(jointAngles, presentJoints, extraHinges),
                new FootForces(leftFoot, rightFoot, leftToe, rightToe),
                vision);
    }

    private void clear() {
        jointAngles = new double[Joint.COUNT];
        presentJoints = 0;
        heard.clear();
        extraHinges.clear();
        seconds = OptionalDouble.empty();
        gameState = Optional.empty();
        gyro = Optional.empty();
        accelerometer = Optional.empty();
        leftFoot = Optional.empty();
        rightFoot = Optional.empty();
        leftToe = Optional.empty();
        rightToe = Optional.empty();
        vision = Optional.empty();
    }

    private void readPerceptor() {
        if (reader.atomIs("HJ")) {
            readHinge();
        } else if (reader.atomIs("FRP")) {
            readForce();
        } else if (reader.atomIs("See")) {
            vision = visionReader.read();
        } else if (reader.atomIs("GYR")) {
            gyro = Readings.vectorIn(reader, "rt");
        } else if (reader.atomIs("ACC")) {
            accelerometer = Readings.vectorIn(reader, "a");
        } else if (reader.atomIs("GS")) {
            readGameState();
        } else if (reader.atomIs("hear")) {
            readHeard();
        } else if (reader.atomIs("time")) {
            OptionalDouble now = Readings.numberIn(reader, "now");
            seconds = now.isPresent() ? now : seconds;
        }
    }

    private void readGameState() {
        OptionalInt number = OptionalInt.empty();
        Optional<TeamSide> side = Optional.empty();
        OptionalInt leftScore = OptionalInt.empty();
        OptionalInt rightScore = OptionalInt.empty();
        double playSeconds = 0;
        String playMode = "";
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("t")) {
                playSeconds = reader.nextNumber() ? reader.number() : playSeconds;
            } else if (reader.atomIs("pm")) {
                playMode = reader.next() == Token.ATOM ? words.of(reader) : playMode;
            } else if (reader.atomIs("sl")) {
                leftScore = Readings.integer(reader);
            } else if (reader.atomIs("sr")) {
                rightScore = Readings.integer(reader);
            } else if (reader.atomIs("unum")) {
                number = Readings.integer(reader);
            } else if (reader.atomIs("team")) {
                side = readSide();
            }
        }
        if (Readings.isComplete(reader)) {
            gameState = Optional.of(new GameState(number, side, leftScore, rightScore, playSeconds, playMode));
        }
    }

    private Optional<TeamSide> readSide() {
        if (reader.next() != Token.ATOM) {
            return Optional.empty();
        }
        if (reader.atomIs("left")) {
            return Optional.of(TeamSide.LEFT);
        }
        return reader.atomIs("right") ? Optional.of(TeamSide.RIGHT) : Optional.empty();
    }

    /** Parses {@code (hear TEAM TIME DIRECTION TEXT)}; old servers omit the team. */
    private void readHeard() {
        String[] atoms = new String[4];
        OptionalDouble[] numbers = new OptionalDouble[4];
        int count = 0;
        while (reader.next() == Token.ATOM && count < atoms.length) {
            atoms[count] = reader.text();
            numbers[count] = reader.isNumber() ? OptionalDouble.of(reader.number()) : OptionalDouble.empty();
            count++;
        }
        if (!Readings.isComplete(reader) || count < 3 || heard.size() >= MAX_HEARD) {
            return;
        }
        Optional<String> team = count == 4 ? Optional.of(atoms[0]) : Optional.empty();
        OptionalDouble playSeconds = numbers[count - 3];
        OptionalDouble direction = numbers[count - 2];
        if (playSeconds.isPresent() && (direction.isPresent() || atoms[count - 2].equals("self"))) {
            heard.add(new Heard(team, playSeconds.getAsDouble(), direction, atoms[count - 1]));
        }
    }

    private void readHinge() {
        int joint = -1;
        String extraName = "";
        double degrees = 0;
        boolean degreesSeen = false;
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("n") && reader.next() == Token.ATOM) {
                joint = joints.indexOf(reader);
                extraName = joint < 0 ? words.of(reader) : "";
            } else if (reader.atomIs("ax") && reader.nextNumber()) {
                degrees = reader.number();
                degreesSeen = true;
            }
        }
        if (!Readings.isComplete(reader) || !degreesSeen) {
            return;
        }
        if (joint >= 0) {
            jointAngles[joint] = degrees;
            presentJoints |= 1 << joint;
        } else if (!extraName.isEmpty()) {
            extraHinges.add(new ExtraHinge(extraName, degrees));
        }
    }

    private void readForce() {
        String foot = "";
        Optional<Vector3> point = Optional.empty();
        Optional<Vector3> force = Optional.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("n")) {
                foot = reader.next() == Token.ATOM ? words.of(reader) : "";
            } else if (reader.atomIs("c")) {
                point = Readings.vector(reader);
            } else if (reader.atomIs("f")) {
                force = Readings.vector(reader);
            }
        }
        if (Readings.isComplete(reader) && point.isPresent() && force.isPresent()) {
            setForce(foot, Optional.of(new FootForce(point.get(), force.get())));
        }
    }

    private void setForce(String foot, Optional<FootForce> force) {
        switch (foot) {
            case "lf" -> leftFoot = force;
            case "rf" -> rightFoot = force;
            case "lf1" -> leftToe = force;
            case "rf1" -> rightToe = force;
            default -> {
                // a sensor of an unknown robot type
            }
        }
    }
}
