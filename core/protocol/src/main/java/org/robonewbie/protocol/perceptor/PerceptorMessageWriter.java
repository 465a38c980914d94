package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.JointAngles.ExtraHinge;
import org.robonewbie.protocol.perceptor.Vision.SeenBodyPart;
import org.robonewbie.protocol.perceptor.Vision.SeenLandmark;
import org.robonewbie.protocol.perceptor.Vision.SeenLine;
import org.robonewbie.protocol.perceptor.Vision.SeenPlayer;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Formats perceptor messages byte for byte like rcssserver3d 0.7.3: perceptors in the order of the robot's scene file,
 * numbers with two decimal places, sub-lists separated by spaces. The writer does not allocate memory.
 */
public final class PerceptorMessageWriter {

    private static final int DECIMALS = 2;
    private static final String LEFT_TOE = "llj7";
    private static final String RIGHT_TOE = "rlj7";
    private static final Joint[] HEAD = {Joint.NECK_YAW, Joint.NECK_PITCH};
    private static final Joint[] ARMS = {
        Joint.RIGHT_SHOULDER_PITCH, Joint.RIGHT_SHOULDER_YAW, Joint.RIGHT_ARM_ROLL, Joint.RIGHT_ARM_YAW,
        Joint.LEFT_SHOULDER_PITCH, Joint.LEFT_SHOULDER_YAW, Joint.LEFT_ARM_ROLL, Joint.LEFT_ARM_YAW
    };
    private static final Joint[] RIGHT_LEG = jointsAboveAnkleRoll(Leg.RIGHT);
    private static final Joint[] LEFT_LEG = jointsAboveAnkleRoll(Leg.LEFT);

    private final SexpWriter writer;

    /**
     * Creates a writer.
     *
     * @param message the buffer to which each message is appended
     */
    public PerceptorMessageWriter(MessageBuffer message) {
        writer = new SexpWriter(message);
    }

    /** Returns the joints of a leg whose angles precede the foot force in a message. */
    private static Joint[] jointsAboveAnkleRoll(Leg leg) {
        return leg.joints().subList(0, 5).toArray(Joint[]::new);
    }

    /**
     * Rounds a number to the precision of a message.
     *
     * @param value a sensor reading
     * @return the number that the agent receives
     */
    public static double rounded(double value) {
        return SexpWriter.rounded(value, DECIMALS);
    }

    /**
     * Appends a message to the buffer.
     *
     * @param message the sensor readings
     */
    public void write(PerceptorMessage message) {
        if (message.seconds().isPresent()) {
            list("(time (now ", message.seconds().getAsDouble()).text(")");
        }
        if (message.gameState().isPresent()) {
            gameState(message.gameState().get());
        }
        List<Heard> heard = message.heard();
        for (int i = 0; i < heard.size(); i++) {
            heard(heard.get(i));
        }
        torso("(GYR (n torso) (rt ", message.gyro());
        torso("(ACC (n torso) (a ", message.accelerometer());
        hinges(message.jointAngles(), HEAD);
        if (message.vision().isPresent()) {
            vision(message.vision().get());
        }
        hinges(message.jointAngles(), ARMS);
        legs(message.jointAngles(), message.footForces());
    }

    private void gameState(GameState state) {
        writer.text("(GS ");
        if (state.number().isPresent() && state.side().isPresent()) {
            String side = state.side().get() == TeamSide.LEFT ? "left" : "right";
            writer.text("(unum ").integer(state.number().getAsInt());
            writer.text(") (team ").text(side).text(") ");
        }
        if (state.leftScore().isPresent() && state.rightScore().isPresent()) {
            writer.text("(sl ").integer(state.leftScore().getAsInt());
            writer.text(") (sr ").integer(state.rightScore().getAsInt()).text(") ");
        }
        list("(t ", state.playSeconds());
        writer.text(" (pm ").text(state.playModeName()).text("))");
    }

    private void heard(Heard heard) {
        writer.text("(hear ");
        if (heard.team().isPresent()) {
            writer.text(heard.team().get()).text(" ");
        }
        number(heard.playSeconds()).text(" ");
        if (heard.isOwn()) {
            writer.text("self");
        } else {
            number(heard.directionDegrees().getAsDouble());
        }
        writer.text(" ").text(heard.text()).text(")");
    }

    private void torso(String opening, Optional<Vector3> reading) {
        if (reading.isPresent()) {
            vector(opening, reading.get());
            writer.text(")");
        }
    }

    private void hinges(JointAngles angles, Joint[] joints) {
        for (Joint joint : joints) {
            hinge(angles, joint);
        }
    }

    private void hinge(JointAngles angles, Joint joint) {
        if (angles.has(joint)) {
            hinge(joint.perceptorName(), angles.degreesOr(joint, 0));
        }
    }

    private void hinge(String perceptorName, double degrees) {
        writer.text("(HJ (n ").text(perceptorName);
        list(") (ax ", degrees).text(")");
    }

    private void legs(JointAngles angles, FootForces forces) {
        hinges(angles, RIGHT_LEG);
        force("rf", forces.right());
        hinge(angles, Joint.RIGHT_FOOT_ROLL);
        force("rf1", forces.rightToe());
        extraHinges(angles, RIGHT_TOE);
        hinges(angles, LEFT_LEG);
        force("lf", forces.left());
        hinge(angles, Joint.LEFT_FOOT_ROLL);
        force("lf1", forces.leftToe());
        extraHinges(angles, LEFT_TOE);
    }

    private void extraHinges(JointAngles angles, String perceptorName) {
        List<ExtraHinge> hinges = angles.extraHinges();
        for (int i = 0; i < hinges.size(); i++) {
            if (hinges.get(i).perceptorName().equals(perceptorName)) {
                hinge(perceptorName, hinges.get(i).degrees());
            }
        }
    }

    private void force(String name, Optional<FootForce> force) {
        if (force.isPresent()) {
            writer.text("(FRP (n ").text(name);
            vector(") (c ", force.get().point());
            vector(" (f ", force.get().force());
            writer.text(")");
        }
    }

    private void vision(Vision vision) {
        writer.text("(See ");
        int empty = writer.length();
        List<SeenLandmark> landmarks = vision.landmarks();
        for (int i = 0; i < landmarks.size(); i++) {
            position(
                    landmarks.get(i).landmark().simSparkName(), landmarks.get(i).position(), empty);
        }
        if (vision.ball().isPresent()) {
            position("B", vision.ball().get(), empty);
        }
        List<SeenPlayer> players = vision.players();
        for (int i = 0; i < players.size(); i++) {
            player(players.get(i), empty);
        }
        groundTruth(vision, empty);
        List<SeenLine> lines = vision.lines();
        for (int i = 0; i < lines.size(); i++) {
            line(lines.get(i), empty);
        }
        writer.text(")");
    }

    private void groundTruth(Vision vision, int empty) {
        if (vision.ownPosition().isPresent()) {
            separate(empty);
            vector("(mypos ", vision.ownPosition().get());
        }
        if (vision.ownOrientationDegrees().isPresent()) {
            separate(empty);
            list("(myorien ", vision.ownOrientationDegrees().getAsDouble());
        }
        if (vision.ballPosition().isPresent()) {
            separate(empty);
            vector("(ballpos ", vision.ballPosition().get());
        }
    }

    private void position(String name, PolarPosition position, int empty) {
        separate(empty);
        writer.text("(").text(name);
        polar(position);
        writer.text(")");
    }

    private void player(SeenPlayer player, int empty) {
        separate(empty);
        writer.text("(P (team ").text(player.team());
        writer.text(") (id ").integer(player.number()).text(")");
        List<SeenBodyPart> parts = player.parts();
        for (int i = 0; i < parts.size(); i++) {
            position(parts.get(i).part().simSparkName(), parts.get(i).position(), empty);
        }
        if (player.position().isPresent()) {
            polar(player.position().get());
        }
        writer.text(")");
    }

    private void line(SeenLine line, int empty) {
        separate(empty);
        writer.text("(L");
        polar(line.start());
        polar(line.end());
        writer.text(")");
    }

    private void polar(PolarPosition position) {
        writer.text(" (pol ");
        number(position.distanceMetres()).text(" ");
        number(position.horizontalDegrees()).text(" ");
        number(position.verticalDegrees()).text(")");
    }

    /** Writes the space before an item of a {@code See} list, unless it is the first item. */
    private void separate(int empty) {
        if (writer.length() > empty) {
            writer.text(" ");
        }
    }

    private void vector(String opening, Vector3 vector) {
        writer.text(opening);
        number(vector.x()).text(" ");
        number(vector.y()).text(" ");
        number(vector.z()).text(")");
    }

    private SexpWriter list(String opening, double value) {
        writer.text(opening);
        return number(value).text(")");
    }

    private SexpWriter number(double value) {
        return writer.fixed(value, DECIMALS);
    }
}
