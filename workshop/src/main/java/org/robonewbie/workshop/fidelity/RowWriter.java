package org.robonewbie.workshop.fidelity;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.monitor.MonitoredGame;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.simulator.physics.BodyPose;

/** Formatter for the lines of a recording. */
final class RowWriter {

    private static final Gson GSON = new Gson();
    private static final MathContext SIX_DIGITS = new MathContext(6, RoundingMode.HALF_EVEN);

    private RowWriter() {}

    static String header(String test, String base, Optional<JoiningWay> way) {
        JsonObject about = new JsonObject();
        about.addProperty("test", test);
        about.addProperty("base", base);
        way.ifPresent(known -> known.addTo(about));
        JsonObject line = new JsonObject();
        line.add("header", about);
        return GSON.toJson(line);
    }

    /**
     * Formats one cycle of a robot.
     *
     * @param message the perceptor message
     * @param torso torso pose, if the monitor port has sent it
     * @param sent the reply to the previous message
     */
    static String row(PerceptorMessage message, Optional<BodyPose> torso, String sent) {
        JsonObject row = new JsonObject();
        row.addProperty("t", message.seconds().orElse(0));
        row.add("hj", joints(message));
        message.accelerometer().ifPresent(value -> row.add("acc", array(value)));
        message.gyro().ifPresent(value -> row.add("gyr", array(value)));
        row.add("frp", footForces(message.footForces()));
        torso.ifPresent(pose -> row.add("torso", torso(pose)));
        row.addProperty("sent", sent);
        return GSON.toJson(row);
    }

    /**
     * Formats one cycle of a ball.
     *
     * @param ballCase initial condition of the ball
     * @param index number of cycles since the first one in which the ball moved
     * @param ball position, if the monitor port has sent it exactly
     * @param game game state
     */
    static String ballRow(BallCase ballCase, int index, Optional<Vector3> ball, MonitoredGame game) {
        JsonObject row = new JsonObject();
        row.addProperty("case", ballCase.name());
        row.addProperty("i", index);
        ball.ifPresent(place -> row.add("ball", position(place)));
        game.playMode().ifPresent(mode -> row.addProperty("pm", mode.simSparkName()));
        row.addProperty("gt", game.timeSeconds());
        row.addProperty("t", Math.rint(100 * Cycle.SECONDS * (index + 1)) / 100);
        return GSON.toJson(row);
    }

    private static JsonObject joints(PerceptorMessage message) {
        JsonObject joints = new JsonObject();
        for (Joint joint : Joint.values()) {
            message.jointAngles()
                    .degrees(joint)
                    .ifPresent(degrees -> joints.addProperty(joint.perceptorName(), degrees));
        }
        message.jointAngles()
                .extraHinges()
                .forEach(hinge -> joints.addProperty(hinge.perceptorName(), hinge.degrees()));
        return joints;
    }

    private static JsonObject footForces(FootForces forces) {
        JsonObject plates = new JsonObject();
        add(plates, "rf", forces.right());
        add(plates, "lf", forces.left());
        add(plates, "rf1", forces.rightToe());
        add(plates, "lf1", forces.leftToe());
        return plates;
    }

    private static void add(JsonObject plates, String name, Optional<FootForce> force) {
        force.ifPresent(felt -> {
            JsonObject plate = new JsonObject();
            plate.add("c", array(felt.point()));
            plate.add("f", array(felt.force()));
            plates.add(name, plate);
        });
    }

    private static JsonObject torso(BodyPose pose) {
        Vector3 forward = pose.rotation().axisY();
        JsonObject torso = new JsonObject();
        torso.add("pos", position(pose.position()));
        torso.addProperty("up", digits(pose.rotation().axisZ().z()));
        torso.addProperty("yaw", degrees(Math.atan2(forward.y(), forward.x())));
        torso.addProperty("pitch", degrees(arcSine(forward.z())));
        torso.addProperty("roll", degrees(arcSine(pose.rotation().axisX().z())));
        return torso;
    }

    private static JsonElement position(Vector3 position) {
        return GSON.toJsonTree(List.of(digits(position.x()), digits(position.y()), digits(position.z())));
    }

    private static double arcSine(double sine) {
        return Math.asin(Math.max(-1, Math.min(1, sine)));
    }

    /** Rounds to six significant digits, as in monitor messages. */
    private static BigDecimal digits(double value) {
        return new BigDecimal(value).round(SIX_DIGITS);
    }

    private static double degrees(double radians) {
        return Math.rint(Math.toDegrees(radians) * 1e4) / 1e4;
    }

    private static JsonElement array(Vector3 vector) {
        return GSON.toJsonTree(List.of(vector.x(), vector.y(), vector.z()));
    }
}
