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
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.RobotSnapshot;
import org.robonewbie.simulator.WorldSnapshot;

/**
 * The table with a row for each robot and cycle: what it felt, what it had been commanded, and what was true. Columns and rows
 * are made side by side here, so that both have the same order.
 */
final class CycleTable {

    private static final List<String> AXES = List.of("forward", "left", "up");
    private static final List<String> WORLD_AXES = List.of("x", "y", "z");

    private final boolean withMessages;

    /** The rows carry the messages themselves too if they are wanted. */
    CycleTable(boolean withMessages) {
        this.withMessages = withMessages;
    }

    List<Column> columns() {
        List<Column> all = new ArrayList<>();
        all.add(Column.whole("run", "", "number of the run, from 1"));
        all.add(Column.whole("cycle", "", "number of the cycle since the simulator's start, each 20 ms"));
        all.add(Column.decimal("seconds", "s", "simulated time since the simulator's start"));
        all.add(Column.decimal("play_seconds", "s", "time of play"));
        all.add(Column.text("play_mode", "the referee's play mode in SimSpark's spelling"));
        all.add(Column.text("team", "the robot's team"));
        all.add(Column.whole("number", "", "the robot's number, 1 to 11"));
        addSensed(all);
        addJoints(all, "command", "degrees/s", "speed that the motor was told last");
        addTrue(all);
        if (withMessages) {
            all.add(Column.text("perceptors", "the message to the robot's program"));
            all.add(Column.text("effectors", "the program's message that was carried out in this cycle"));
        }
        return List.copyOf(all);
    }

    private static void addSensed(List<Column> all) {
        addJoints(all, "sensed", "degrees", "angle as the robot feels it");
        addVector(all, "gyro", AXES, "degrees/s", "turning of the torso as the robot feels it");
        addVector(all, "accelerometer", AXES, "m/s2", "acceleration of the torso as the robot feels it");
        for (String foot : List.of("left_foot", "right_foot")) {
            addVector(all, foot + "_point", AXES, "m", "where the ground presses; empty in the air");
            addVector(all, foot + "_force", AXES, "N", "how strongly the ground presses; empty in the air");
        }
        all.add(Column.whole("picture", "1 or 0", "whether the camera sent a picture in this cycle"));
        all.add(Column.decimal("ball_distance", "m", "where the picture shows the ball; empty if it does not"));
        all.add(Column.decimal("ball_horizontal", "degrees", "direction of the ball in the picture, left is positive"));
        all.add(Column.decimal("ball_vertical", "degrees", "direction of the ball in the picture, up is positive"));
        SeenAndSaid.addColumns(all);
    }

    private static void addTrue(List<Column> all) {
        addVector(all, "true_torso", WORLD_AXES, "m", "centre of the torso in the world frame");
        for (String part : List.of("w", "x", "y", "z")) {
            all.add(Column.decimal("true_torso_q" + part, "", "rotation of the torso in the world frame, quaternion"));
        }
        all.add(Column.decimal(
                "true_heading", "degrees", "where the torso looks, 0 to the right goal, left is positive"));
        all.add(Column.decimal("true_tilt", "degrees", "how far the torso leans: 0 upright, 90 lying"));
        addJoints(all, "true", "degrees", "true angle");
        addVector(all, "true_ball", WORLD_AXES, "m", "centre of the ball in the world frame");
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

    List<Object> row(int run, WorldSnapshot world, RobotSnapshot robot, HeardRobot heard) {
        List<Object> row = new ArrayList<>();
        row.add((long) run);
        row.add(world.cycle());
        row.add(rounded(world.seconds()));
        row.add(rounded(world.gameTime()));
        row.add(world.playMode().simSparkName());
        row.add(robot.team());
        row.add((long) robot.number());
        putSensed(row, heard.perceived(), heard.said());
        for (Joint joint : Joint.values()) {
            row.add(heard.commandedDegreesPerSecond(joint));
        }
        putTrue(row, world, robot);
        if (withMessages) {
            row.add(heard.perceptors());
            row.add(heard.effectors());
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
        Optional<PolarPosition> ball = message.vision().flatMap(Vision::ball);
        row.add(ball.map(PolarPosition::distanceMetres).orElse(Double.NaN));
        row.add(ball.map(PolarPosition::horizontalDegrees).orElse(Double.NaN));
        row.add(ball.map(PolarPosition::verticalDegrees).orElse(Double.NaN));
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
        Rotation turn = SimSparkFrame.linkFromBody(body.torso()).rotation();
        put(row, body.position());
        row.addAll(List.of(turn.w(), turn.x(), turn.y(), turn.z(), body.headingDegrees(), body.tiltDegrees()));
        for (Joint joint : Joint.values()) {
            row.add(body.degrees(joint));
        }
        put(row, world.ballPosition());
    }

    private static void put(List<Object> row, Vector3 vector) {
        row.add(vector.x());
        row.add(vector.y());
        row.add(vector.z());
    }

    /** Times are whole hundredths; this takes away what arithmetic has added. */
    private static double rounded(double seconds) {
        return Math.round(seconds * 100) / 100.0;
    }
}
