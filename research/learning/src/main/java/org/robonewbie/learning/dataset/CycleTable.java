package org.robonewbie.learning.dataset;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyState;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * Format of the table with a row for each robot and cycle: its sensor readings, its commands, and the true state. The
 * definitions of the columns and the cells of a row are built by adjacent methods, in the same order.
 */
final class CycleTable {

    private static final List<String> AXES = List.of("forward", "left", "up");
    private static final List<String> WORLD_AXES = List.of("x", "y", "z");

    private final boolean withMessages;

    /** Creates the format, optionally with the raw text of the messages. */
    CycleTable(boolean withMessages) {
        this.withMessages = withMessages;
    }

    List<Column> columns() {
        List<Column> all = new ArrayList<>();
        all.add(Column.whole("run", "", "number of the run, from 1"));
        all.add(Column.whole("cycle", "", "number of the 20 ms cycle since the start"));
        all.add(Column.decimal("seconds", "s", "simulated time since the start"));
        all.add(Column.decimal("play_seconds", "s", "game time"));
        all.add(Column.text("play_mode", "the referee's play mode, as named by SimSpark"));
        all.add(Column.text("team", "the robot's team"));
        all.add(Column.whole("number", "", "the robot's number, 1 to 11"));
        addSensed(all);
        addJoints(all, "command", "degrees/s", "last commanded speed");
        addTrue(all);
        if (withMessages) {
            all.add(Column.text("perceptors", "with --messages: the message to the agent"));
            all.add(Column.text("effectors", "with --messages: the agent's message that took effect in this cycle"));
        }
        return List.copyOf(all);
    }

    private static void addSensed(List<Column> all) {
        addJoints(all, "sensed", "degrees", "measured angle, rounded to hundredths");
        addVector(all, "gyro", AXES, "degrees/s", "angular velocity of the torso");
        addVector(all, "accelerometer", AXES, "m/s2", "acceleration of the torso");
        for (String foot : List.of("left_foot", "right_foot")) {
            addVector(all, foot + "_point", AXES, "m", "centre of pressure; empty in the air");
            addVector(all, foot + "_force", AXES, "N", "ground reaction force; empty in the air");
        }
        all.add(Column.whole("picture", "1 or 0", "whether the camera sent a picture, as in every third cycle"));
        SeenAndSaid.addColumns(all);
    }

    private static void addTrue(List<Column> all) {
        addVector(
                all,
                "true_torso",
                WORLD_AXES,
                "m",
                "centre of the torso: x towards the right goal, y to the left of that direction, z up");
        for (String part : List.of("w", "x", "y", "z")) {
            all.add(Column.decimal(
                    "true_torso_q" + part, "", "rotation; the axes of the torso are right, forward, up"));
        }
        all.add(Column.decimal("true_heading", "degrees", "0 towards the right goal, positive to the left"));
        all.add(Column.decimal("true_tilt", "degrees", "0 upright, 90 lying"));
        addJoints(all, "true", "degrees", "true angle");
        addVector(all, "true_ball", WORLD_AXES, "m", "centre of the ball");
    }

    private static void addJoints(List<Column> all, String prefix, String unit, String meaning) {
        for (Joint joint : Joint.values()) {
            all.add(Column.decimal(prefix + '_' + joint.name().toLowerCase(Locale.ROOT), unit, meaning));
        }
    }

    private static void addVector(List<Column> all, String name, List<String> axes, String unit, String meaning) {
        for (String axis : axes) {
            all.add(Column.decimal(name + '_' + axis, unit, meaning));
        }
    }

    List<Object> row(int run, WorldSnapshot world, RobotSnapshot robot, RobotMessages messages) {
        List<Object> row = new ArrayList<>();
        row.add((long) run);
        row.add(world.cycle());
        row.add(rounded(world.seconds()));
        row.add(rounded(world.gameTime()));
        row.add(world.playMode().simSparkName());
        row.add(robot.team());
        row.add((long) robot.number());
        putSensed(row, messages.perceived(), messages.said());
        for (Joint joint : Joint.values()) {
            row.add(messages.commandedDegreesPerSecond(joint));
        }
        putTrue(row, world, robot);
        if (withMessages) {
            row.add(messages.perceptors());
            row.add(messages.effectors());
        }
        return row;
    }

    private static void putSensed(List<Object> row, PerceptorMessage message, String said) {
        for (Joint joint : Joint.values()) {
            row.add(message.jointAngles().degreesOr(joint, Double.NaN));
        }
        putBody(row, message.gyro());
        putBody(row, message.accelerometer());
        putFoot(row, message.footForces().left());
        putFoot(row, message.footForces().right());
        row.add(message.vision().isPresent() ? 1L : 0L);
        SeenAndSaid.put(row, message, said);
    }

    private static void putFoot(List<Object> row, Optional<FootForce> foot) {
        putBody(row, foot.map(FootForce::point));
        putBody(row, foot.map(FootForce::force));
    }

    private static void putBody(List<Object> row, Optional<Vector3> sensed) {
        put(row, sensed.map(SimSparkFrame::toBody).orElse(new Vector3(Double.NaN, Double.NaN, Double.NaN)));
    }

    private static void putTrue(List<Object> row, WorldSnapshot world, RobotSnapshot robot) {
        BodyState body = robot.body();
        Rotation rotation = SimSparkFrame.linkFromBody(body.torso()).rotation();
        put(row, body.position());
        row.addAll(List.of(rotation.w(), rotation.x(), rotation.y(), rotation.z()));
        row.addAll(List.of(body.headingDegrees(), body.tiltDegrees()));
        for (Joint joint : Joint.values()) {
            row.add(body.degrees(joint));
        }
        put(row, world.ballPosition());
    }

    private static void put(List<Object> row, Vector3 vector) {
        row.addAll(List.of(vector.x(), vector.y(), vector.z()));
    }

    /** Rounds a time to hundredths of a second to remove floating-point errors. */
    private static double rounded(double seconds) {
        return Math.round(seconds * 100) / 100.0;
    }
}
