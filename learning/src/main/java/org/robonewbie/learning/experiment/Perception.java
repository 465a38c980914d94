package org.robonewbie.learning.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PolarPosition;
import org.robonewbie.protocol.perceptor.Vision;
import org.robonewbie.simulator.world.Robot;

/**
 * What a robot perceives, as a row of numbers in the hundredths that messages carry. Axes are those of an agent: forward,
 * left, up. What the camera sees stays until the next picture, 60 ms later.
 */
final class Perception {

    private static final double FAR_METRES = 40;
    private static final double STRONG_NEWTONS = 1000;
    private static final int NUMBERS_PER_FOOT = 6;

    private final Robot robot;
    private final boolean camera;
    private Optional<PolarPosition> ball = Optional.empty();
    private double ballInSight;

    Perception(Robot robot, boolean camera) {
        this.robot = robot;
        this.camera = camera;
    }

    static List<ObservedQuantity> quantities(boolean camera) {
        List<ObservedQuantity> all = new ArrayList<>();
        for (Joint joint : Joint.values()) {
            all.add(new ObservedQuantity("joint." + joint, "degrees", joint.minDegrees(), joint.maxDegrees()));
        }
        addVector(all, "gyro", "degrees/s", 2000);
        addVector(all, "accelerometer", "m/s²", 500);
        for (String foot : List.of("leftFoot", "rightFoot")) {
            addVector(all, foot + ".point", "m", 0.2);
            addVector(all, foot + ".force", "N", STRONG_NEWTONS);
        }
        if (camera) {
            all.add(new ObservedQuantity("ball.inSight", "1 or 0", 0, 1));
            all.add(new ObservedQuantity("ball.distance", "m", 0, FAR_METRES));
            all.add(new ObservedQuantity("ball.horizontal", "degrees", -180, 180));
            all.add(new ObservedQuantity("ball.vertical", "degrees", -90, 90));
        }
        return List.copyOf(all);
    }

    private static void addVector(List<ObservedQuantity> all, String name, String unit, double most) {
        for (String axis : List.of("forward", "left", "up")) {
            all.add(new ObservedQuantity(name + "." + axis, unit, -most, most));
        }
    }

    /** Takes in a picture; without one nothing changes. */
    void look(Optional<Vision> picture) {
        if (picture.isPresent()) {
            ballInSight = picture.get().ball().isPresent() ? 1 : 0;
            ball = picture.get().ball().or(() -> ball);
        }
    }

    double[] observation(double[] jointDegrees) {
        double[] row = new double[Joint.COUNT + 6 + 2 * NUMBERS_PER_FOOT + (camera ? 4 : 0)];
        for (int i = 0; i < Joint.COUNT; i++) {
            row[i] = hundredths(jointDegrees[i]);
        }
        put(row, Joint.COUNT, SimSparkFrame.toBody(robot.gyroDegreesPerSecond()));
        put(row, Joint.COUNT + 3, SimSparkFrame.toBody(robot.acceleration()));
        FootForces feet = robot.footForces();
        putFoot(row, Joint.COUNT + 6, feet.left());
        putFoot(row, Joint.COUNT + 6 + NUMBERS_PER_FOOT, feet.right());
        if (camera) {
            putBall(row, row.length - 4);
        }
        return row;
    }

    private void putBall(double[] row, int index) {
        row[index] = ballInSight;
        ball.ifPresent(seen -> {
            row[index + 1] = hundredths(seen.distanceMetres());
            row[index + 2] = hundredths(seen.horizontalDegrees());
            row[index + 3] = hundredths(seen.verticalDegrees());
        });
    }

    private static void putFoot(double[] row, int index, Optional<FootForce> foot) {
        foot.ifPresent(felt -> {
            put(row, index, SimSparkFrame.toBody(felt.point()));
            put(row, index + 3, SimSparkFrame.toBody(felt.force()));
        });
    }

    private static void put(double[] row, int index, Vector3 vector) {
        row[index] = hundredths(vector.x());
        row[index + 1] = hundredths(vector.y());
        row[index + 2] = hundredths(vector.z());
    }

    static double hundredths(double value) {
        return Math.round(value * 100) / 100.0;
    }
}
