package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.Vector3;

/**
 * The sensor readings of a robot in one cycle of 20 ms, as sent by SimSpark. Perceptors that a message omits are empty.
 *
 * <p>The torso frame has x to the robot's right, y forward and z up.
 *
 * @param seconds simulated time since the start of the server in seconds, which increases by 0.02 in each cycle
 * @param gameState state of the game as reported by the referee; sent in every message
 * @param heard voice messages received in this cycle from the robot itself, a teammate or an opponent
 * @param gyro angular velocity of the torso about the axes of the torso frame in degrees per second
 * @param accelerometer specific force at the torso's centre in the torso frame, as measured by an IMU, in metres per second
 *     squared: (0, 0, 9.81) at rest, (0, 0, 0) in free fall
 * @param jointAngles angles of all hinges in degrees
 * @param footForces contact forces on the feet
 * @param vision objects recognised by the camera, in every third message
 */
public record PerceptorMessage(
        OptionalDouble seconds,
        Optional<GameState> gameState,
        List<Heard> heard,
        Optional<Vector3> gyro,
        Optional<Vector3> accelerometer,
        JointAngles jointAngles,
        FootForces footForces,
        Optional<Vision> vision) {

    /** An empty message. */
    public static final PerceptorMessage NOTHING = new PerceptorMessage(
            OptionalDouble.empty(),
            Optional.empty(),
            List.of(),
            Optional.empty(),
            Optional.empty(),
            JointAngles.NONE,
            FootForces.NONE,
            Optional.empty());

    /** Stores an unmodifiable copy of the list. */
    public PerceptorMessage {
        heard = List.copyOf(heard);
    }
}
