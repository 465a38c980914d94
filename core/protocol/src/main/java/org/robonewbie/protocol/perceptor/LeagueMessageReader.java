package org.robonewbie.protocol.perceptor;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.robonewbie.nao.FieldMarking;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * Parser for the perceptor messages of RCSSServerMJ 0.2.1, which have SimSpark's syntax and other words. Unknown lists are skipped
 * and incomplete lists are ignored, so parsing never fails. Each robot has its own reader. Not thread-safe.
 *
 * <pre>{@code
 * LeagueMessageReader reader = new LeagueMessageReader(BoosterT1.MODEL, "Blue", 2);
 * LeaguePerception perception = reader.read(buffer);
 * }</pre>
 */
public final class LeagueMessageReader {

    private static final int MAX_HEARD = 100;

    private final RobotModel model;
    private final OrderedNames joints;
    private final String team;
    private final int number;
    private final SexpReader reader = new SexpReader();
    private final KnownWords words = new KnownWords();
    private final VisionReader visionReader =
            new VisionReader(reader, words, LeagueMessageReader::nameOf, List.of(FieldMarking.values()));
    private final List<Heard> heard = new ArrayList<>();
    private double[] degrees = {};
    private double[] degreesPerSecond = {};
    private OptionalDouble seconds = OptionalDouble.empty();
    private Optional<GameState> gameState = Optional.empty();
    private Optional<Vector3> gyro = Optional.empty();
    private Optional<Vector3> accelerometer = Optional.empty();
    private Optional<Vector3> position = Optional.empty();
    private Optional<Rotation> orientation = Optional.empty();
    private Optional<Vision> vision = Optional.empty();

    /**
     * Creates a reader.
     *
     * @param model the robot
     * @param team name of its team, from which its side follows
     * @param number its player number, which the server does not repeat
     */
    public LeagueMessageReader(RobotModel model, String team, int number) {
        this.model = model;
        this.team = team;
        this.number = number;
        this.joints = new OrderedNames(
                model.joints().stream().map(RobotJoint::perceptorName).toList());
    }

    /**
     * Parses a message.
     *
     * @param message the message as received from the server
     * @return the sensor readings
     */
    public LeaguePerception read(MessageBuffer message) {
        clear();
        reader.start(message);
        while (reader.nextList(0)) {
            readPerceptor();
        }
        PerceptorMessage common = new PerceptorMessage(
                seconds, gameState, heard, gyro, accelerometer, JointAngles.NONE, FootForces.NONE, vision);
        return new LeaguePerception(
                common, new LeaguePerception.Joints(degrees, degreesPerSecond), position, orientation);
    }

    private void clear() {
        degrees = new double[model.joints().size()];
        degreesPerSecond = new double[model.joints().size()];
        Arrays.fill(degrees, Double.NaN);
        Arrays.fill(degreesPerSecond, Double.NaN);
        heard.clear();
        seconds = OptionalDouble.empty();
        gameState = Optional.empty();
        gyro = Optional.empty();
        accelerometer = Optional.empty();
        position = Optional.empty();
        orientation = Optional.empty();
        vision = Optional.empty();
    }

    private void readPerceptor() {
        if (reader.atomIs("HJ")) {
            readJoint();
        } else if (reader.atomIs("GYR")) {
            gyro = Readings.vectorIn(reader, "rt").map(SimSparkFrame::fromBody);
        } else if (reader.atomIs("ACC")) {
            accelerometer = Readings.vectorIn(reader, "a").map(SimSparkFrame::fromBody);
        } else if (reader.atomIs("pos")) {
            position = Readings.vectorIn(reader, "p");
        } else if (reader.atomIs("quat")) {
            orientation = readOrientation();
        } else if (reader.atomIs("See")) {
            vision = visionReader.read();
        } else if (reader.atomIs("GS")) {
            readGameState();
        } else if (reader.atomIs("MIC")) {
            readHeard();
        } else if (reader.atomIs("time")) {
            OptionalDouble now = Readings.numberIn(reader, "now");
            seconds = now.isPresent() ? now : seconds;
        }
    }

    private void readJoint() {
        int joint = -1;
        OptionalDouble angle = OptionalDouble.empty();
        OptionalDouble speed = OptionalDouble.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("n")) {
                joint = reader.next() == Token.ATOM ? joints.indexOf(reader) : -1;
            } else if (reader.atomIs("ax")) {
                angle = Readings.number(reader);
            } else if (reader.atomIs("vx")) {
                speed = Readings.number(reader);
            }
        }
        if (Readings.isComplete(reader) && joint >= 0) {
            degrees[joint] = angle.orElse(Double.NaN);
            degreesPerSecond[joint] = speed.orElse(Double.NaN);
        }
    }

    private Optional<Rotation> readOrientation() {
        Optional<Rotation> reading = Optional.empty();
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("q")) {
                OptionalDouble w = Readings.number(reader);
                Optional<Vector3> axis = w.isPresent() ? Readings.vector(reader) : Optional.empty();
                reading = axis.flatMap(part -> unit(w.getAsDouble(), part));
            }
        }
        return Readings.isComplete(reader) ? reading : Optional.empty();
    }

    /** Normalises a quaternion, since the server sends three decimal places; empty if it is zero or not finite. */
    private static Optional<Rotation> unit(double w, Vector3 part) {
        double length = Math.sqrt(w * w + part.x() * part.x() + part.y() * part.y() + part.z() * part.z());
        return length > 0 && length < Double.POSITIVE_INFINITY
                ? Optional.of(new Rotation(w / length, part.x() / length, part.y() / length, part.z() / length))
                : Optional.empty();
    }

    private void readGameState() {
        Optional<TeamSide> side = Optional.empty();
        OptionalInt leftScore = OptionalInt.empty();
        OptionalInt rightScore = OptionalInt.empty();
        double playSeconds = 0;
        String playMode = "";
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            if (reader.atomIs("t")) {
                playSeconds = Readings.number(reader).orElse(playSeconds);
            } else if (reader.atomIs("pm")) {
                playMode = reader.next() == Token.ATOM ? words.of(reader) : playMode;
            } else if (reader.atomIs("sl")) {
                leftScore = Readings.integer(reader);
            } else if (reader.atomIs("sr")) {
                rightScore = Readings.integer(reader);
            } else if (reader.atomIs("tl")) {
                side = isOwnTeam() ? Optional.of(TeamSide.LEFT) : side;
            } else if (reader.atomIs("tr")) {
                side = isOwnTeam() ? Optional.of(TeamSide.RIGHT) : side;
            }
        }
        if (Readings.isComplete(reader)) {
            OptionalInt own = side.isPresent() ? OptionalInt.of(number) : OptionalInt.empty();
            gameState = Optional.of(new GameState(own, side, leftScore, rightScore, playSeconds, playMode));
        }
    }

    private boolean isOwnTeam() {
        return reader.next() == Token.ATOM && reader.atomIs(team);
    }

    /** Parses {@code (MIC NAME (DIRECTION TEXT) …)}, with the texts in Base64. */
    private void readHeard() {
        int depth = reader.depth();
        while (reader.nextList(depth)) {
            OptionalDouble direction = reader.isNumber() ? OptionalDouble.of(reader.number()) : OptionalDouble.empty();
            Optional<String> text = reader.next() == Token.ATOM ? decoded(reader.text()) : Optional.empty();
            if (direction.isPresent() && text.isPresent() && heard.size() < MAX_HEARD) {
                heard.add(new Heard(
                        Optional.empty(), gameState.map(GameState::playSeconds).orElse(0.0), direction, text.get()));
            }
        }
    }

    private static Optional<String> decoded(String base64) {
        try {
            return Optional.of(new String(Base64.getDecoder().decode(base64), StandardCharsets.UTF_8));
        } catch (IllegalArgumentException unreadable) {
            return Optional.empty();
        }
    }

    private static String nameOf(Landmark landmark) {
        return switch (landmark) {
            case GOAL_POST_1_LEFT -> "g_lup";
            case GOAL_POST_2_LEFT -> "g_llp";
            case GOAL_POST_1_RIGHT -> "g_rup";
            case GOAL_POST_2_RIGHT -> "g_rlp";
            case FLAG_1_LEFT -> "l_luf";
            case FLAG_2_LEFT -> "l_llf";
            case FLAG_1_RIGHT -> "l_ruf";
            case FLAG_2_RIGHT -> "l_rlf";
        };
    }
}
