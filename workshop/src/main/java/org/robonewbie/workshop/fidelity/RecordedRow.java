package org.robonewbie.workshop.fidelity;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * Output of a server after one cycle, rounded as printed, and the client's reply.
 *
 * @param seconds server time
 * @param jointDegrees joint angles, keyed by perceptor name; empty in a recording of only a ball
 * @param acceleration accelerometer value in m/s²
 * @param gyro gyro value in degrees per second
 * @param footForces foot forces; empty if the file contains none
 * @param torso true pose
 * @param ball true position in metres
 * @param playMode SimSpark name of the play mode; empty if unknown
 * @param sent the client's reply, which takes effect one row later
 */
public record RecordedRow(
        double seconds,
        Map<String, Double> jointDegrees,
        Optional<Vector3> acceleration,
        Optional<Vector3> gyro,
        Optional<FootForces> footForces,
        Optional<BodyPose> torso,
        Optional<Vector3> ball,
        String playMode,
        String sent) {

    private static final int MAX_LOST_CYCLES = 500;

    /** Returns the number of server cycles until the next row, at least 1; more than one if lines were lost. */
    int cyclesUntil(RecordedRow next) {
        double cycles = (next.seconds - seconds) / Cycle.SECONDS;
        return cycles > 1.75 && cycles < MAX_LOST_CYCLES ? (int) Math.round(cycles) : 1;
    }
}
