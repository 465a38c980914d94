package org.robonewbie.protocol.perceptor;

import java.util.ArrayList;
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

    private static final Joint[] JOINTS = Joint.values();
    private static final int MAX_HEARD = 100;

    private final SexpReader reader = new SexpReader();
    private final KnownWords words = new KnownWords();
    private final VisionReader visionReader = new VisionReader(reader, words, Landmark::simSparkName);
    private final List<Heard> heard = new ArrayList<>();
    private final List<ExtraHinge> extraHinges = new ArrayList<>();
    private double[] jointAngles = new double[Joint.COUNT];
    private int presentJoints;
    private int expectedJoint;
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
            gyro = readTorso("rt");
        } else if (reader.atomIs("ACC")) {
            accelerometer = readTorso("a");
        } else if (reader.atomIs("GS")) {
            readGameState();
        } else if (reader.atomIs("hear")) {
            readHeard();
        } else if (reader.atomIs("time")) {
            readTime();
        }
    }

    private void readTime() {
        OptionalDouble now = OptionalDouble.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("now")) {
                now = Readings.number(reader);
            }
        }
        if (isComplete() && now.isPresent()) {
            seconds = now;
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
                leftScore = readInteger();
            } else if (reader.atomIs("sr")) {
                rightScore = readInteger();
            } else if (reader.atomIs("unum")) {
                number = readInteger();
            } else if (reader.atomIs("team")) {
                side = readSide();
            }
        }
        if (isComplete()) {
            gameState = Optional.of(new GameState(number, side, leftScore, rightScore, playSeconds, playMode));
        }
    }

    private OptionalInt readInteger() {
        return reader.nextNumber() ? OptionalInt.of(reader.integer()) : OptionalInt.empty();
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
        if (!isComplete() || count < 3 || heard.size() >= MAX_HEARD) {
            return;
        }
        Optional<String> team = count == 4 ? Optional.of(atoms[0]) : Optional.empty();
        OptionalDouble playSeconds = numbers[count - 3];
        OptionalDouble direction = numbers[count - 2];
        if (playSeconds.isPresent() && (direction.isPresent() || atoms[count - 2].equals("self"))) {
            heard.add(new Heard(team, playSeconds.getAsDouble(), direction, atoms[count - 1]));
        }
    }

    private Optional<Vector3> readTorso(String name) {
        Optional<Vector3> reading = Optional.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs(name)) {
                reading = Readings.vector(reader);
            }
        }
        return isComplete() ? reading : Optional.empty();
    }

    private void readHinge() {
        int joint = -1;
        String extraName = "";
        double degrees = 0;
        boolean degreesSeen = false;
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("n") && reader.next() == Token.ATOM) {
                joint = findJoint();
                extraName = joint < 0 ? words.of(reader) : "";
            } else if (reader.atomIs("ax") && reader.nextNumber()) {
                degrees = reader.number();
                degreesSeen = true;
            }
        }
        if (!isComplete() || !degreesSeen) {
            return;
        }
        if (joint >= 0) {
            jointAngles[joint] = degrees;
            presentJoints |= 1 << joint;
        } else if (!extraName.isEmpty()) {
            extraHinges.add(new ExtraHinge(extraName, degrees));
        }
    }

    /**
     * Finds the joint named by the current atom. Starts after the previous joint, because servers send joints in a
     * fixed order.
     */
    private int findJoint() {
        for (int i = 0; i < JOINTS.length; i++) {
            int candidate = (expectedJoint + i) % JOINTS.length;
            if (reader.atomIs(JOINTS[candidate].perceptorName())) {
                expectedJoint = candidate + 1;
                return candidate;
            }
        }
        return -1;
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
        if (isComplete() && point.isPresent() && force.isPresent()) {
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

    private boolean isComplete() {
        return reader.token() == Token.CLOSE;
    }
}
