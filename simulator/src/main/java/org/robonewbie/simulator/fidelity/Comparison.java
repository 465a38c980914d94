package org.robonewbie.simulator.fidelity;

import java.util.OptionalDouble;
import org.robonewbie.simulator.physics.Pose;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/** Adds up the differences between the rows of one recording and our world. */
final class Comparison {

    private final Limits limits;
    private final Deviations jointDegrees = new Deviations();
    private final Deviations torsoMetres = new Deviations();
    private final Deviations torsoDegrees = new Deviations();
    private final Deviations ballMetres = new Deviations();
    private final Deviations restMetres = new Deviations();
    private final Deviations restDegrees = new Deviations();
    private final EqualRows accelerometer = new EqualRows();
    private final EqualRows gyro = new EqualRows();
    private final EqualRows footPlates = new EqualRows();
    private OptionalDouble firstDivergence = OptionalDouble.empty();
    private double runStart;
    private double lastMetres;
    private double lastDegrees;

    Comparison(Limits limits) {
        this.limits = limits;
    }

    void startRun(RecordedRow first) {
        runStart = first.seconds();
    }

    void endRun(RecordedRow last) {
        restMetres.add(lastMetres);
        if (last.torso().isPresent()) {
            restDegrees.add(lastDegrees);
        }
    }

    void compare(RecordedRow row, Robot robot) {
        boolean within = compareJoints(row, robot);
        row.acceleration().ifPresent(printed -> accelerometer.add(Printed.equal(robot.acceleration(), printed)));
        row.gyro().ifPresent(printed -> gyro.add(Printed.equal(robot.gyroDegreesPerSecond(), printed)));
        row.footForces().ifPresent(printed -> footPlates.add(Printed.equal(robot.footForces(), printed)));
        if (row.torso().isPresent()) {
            within &= compareTorso(row.torso().get(), robot.torso());
        }
        noteDivergence(row, within);
    }

    void compare(RecordedRow row, Ball ball) {
        lastMetres = row.ball().orElseThrow().distanceTo(ball.position());
        ballMetres.add(lastMetres);
        noteDivergence(row, lastMetres <= limits.ballMetres());
    }

    RecordingFidelity result(String name) {
        return new RecordingFidelity(
                name,
                jointDegrees.median(),
                jointDegrees.max(),
                torsoMetres.median(),
                torsoMetres.max(),
                torsoDegrees.max(),
                ballMetres.max(),
                accelerometer.share(),
                gyro.share(),
                footPlates.share(),
                restMetres.max(),
                restDegrees.max(),
                firstDivergence);
    }

    private boolean compareJoints(RecordedRow row, Robot robot) {
        boolean within = true;
        for (int i = 0; i < robot.model().hinges().size(); i++) {
            Double recorded =
                    row.jointDegrees().get(robot.model().hinges().get(i).perceptorName());
            if (recorded != null) {
                double error = Math.abs(recorded - robot.jointDegrees(i));
                jointDegrees.add(error);
                within &= error <= limits.jointDegrees();
            }
        }
        return within;
    }

    private boolean compareTorso(Pose recorded, Pose simulated) {
        lastMetres = recorded.position().distanceTo(simulated.position());
        lastDegrees = TorsoAngles.degreesBetween(recorded.rotation(), simulated.rotation());
        torsoMetres.add(lastMetres);
        torsoDegrees.add(lastDegrees);
        return lastMetres <= limits.torsoMetres() && lastDegrees <= limits.torsoDegrees();
    }

    private void noteDivergence(RecordedRow row, boolean within) {
        double seconds = row.seconds() - runStart;
        if (!within && seconds < firstDivergence.orElse(Double.POSITIVE_INFINITY)) {
            firstDivergence = OptionalDouble.of(seconds);
        }
    }
}
