package org.robonewbie.workshop.fidelity;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Vector3;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.BodyPose;

/**
 * What a server showed after one cycle, rounded as it was printed, and what the client answered.
 *
 * @param seconds the server's time
 * @param jointDegrees angle by perceptor name; empty in a recording of the ball alone
 * @param acceleration as sent, m/s²
 * @param gyro as sent, degrees per second
 * @param footForces as sent; empty when the file has none at all
 * @param torso true pose
 * @param ball true position in metres
 * @param playMode SimSpark's name of the play mode; empty when the file has none
 * @param sent the client's answer; it takes effect one row later
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

    private static final int MOST_LOST_CYCLES = 500;

    /**
     * Returns the number of server cycles from this row to another one; more than one when lines got lost.
     *
     * @param next the row after this one
     * @return at least 1
     */
    int cyclesUntil(RecordedRow next) {
        double cycles = (next.seconds - seconds) / Cycle.SECONDS;
        return cycles > 1.75 && cycles < MOST_LOST_CYCLES ? (int) Math.round(cycles) : 1;
    }
}
