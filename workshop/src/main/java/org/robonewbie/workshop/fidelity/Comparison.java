package org.robonewbie.workshop.fidelity;

import java.util.Map;
import java.util.OptionalDouble;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.BodyPose;

/** Accumulates the differences between the rows of one recording and the simulated world. */
final class Comparison {

    private final Tolerances limits;
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
    private OptionalDouble lastMetres = OptionalDouble.empty();
    private OptionalDouble lastDegrees = OptionalDouble.empty();

    Comparison(Tolerances limits) {
        this.limits = limits;
    }

    void startRun(RecordedRow first) {
        runStart = first.seconds();
        lastMetres = OptionalDouble.empty();
        lastDegrees = OptionalDouble.empty();
    }

    void endRun() {
        lastMetres.ifPresent(restMetres::add);
        lastDegrees.ifPresent(restDegrees::add);
    }

    void compare(RecordedRow row, Measurements measured, BodyPose torso, Vector3 ball) {
        boolean within = compareJoints(row, measured.jointDegrees());
        row.acceleration().ifPresent(printed -> accelerometer.add(Printed.equal(measured.acceleration(), printed)));
        row.gyro().ifPresent(printed -> gyro.add(Printed.equal(measured.gyro(), printed)));
        row.footForces().ifPresent(printed -> footPlates.add(Printed.equal(measured.footForces(), printed)));
        if (row.torso().isPresent()) {
            within &= compareTorso(row.torso().get(), torso);
        }
        if (row.ball().isPresent()) {
            within &= compareBall(row.ball().get(), ball);
        }
        recordDivergence(row, within);
    }

    void compare(RecordedRow row, Vector3 ball) {
        if (row.ball().isPresent()) {
            lastMetres = OptionalDouble.of(row.ball().get().distanceTo(ball));
            recordDivergence(row, compareBall(row.ball().get(), ball));
        }
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

    private boolean compareJoints(RecordedRow row, Map<String, Double> measured) {
        boolean within = true;
        for (Map.Entry<String, Double> recorded : row.jointDegrees().entrySet()) {
            Double degrees = measured.get(recorded.getKey());
            if (degrees != null) {
                double error = rounded(Math.abs(recorded.getValue() - degrees));
                jointDegrees.add(error);
                within &= error <= limits.jointDegrees();
            }
        }
        return within;
    }

    private boolean compareTorso(BodyPose recorded, BodyPose simulated) {
        double metres = recorded.position().distanceTo(simulated.position());
        double degrees = TorsoAngles.degreesBetween(recorded.rotation(), simulated.rotation());
        lastMetres = OptionalDouble.of(metres);
        lastDegrees = OptionalDouble.of(degrees);
        torsoMetres.add(metres);
        torsoDegrees.add(degrees);
        return metres <= limits.torsoMetres() && degrees <= limits.torsoDegrees();
    }

    private boolean compareBall(Vector3 recorded, Vector3 simulated) {
        double metres = recorded.distanceTo(simulated);
        ballMetres.add(metres);
        return metres <= limits.ballMetres();
    }

    /** Removes floating-point error: the difference of two printed decimals, such as 1.01 and 1.00, is not exactly 0.01. */
    private static double rounded(double difference) {
        return Math.rint(difference * 1e9) / 1e9;
    }

    private void recordDivergence(RecordedRow row, boolean within) {
        double seconds = row.seconds() - runStart;
        if (!within && seconds < firstDivergence.orElse(Double.POSITIVE_INFINITY)) {
            firstDivergence = OptionalDouble.of(seconds);
        }
    }
}
