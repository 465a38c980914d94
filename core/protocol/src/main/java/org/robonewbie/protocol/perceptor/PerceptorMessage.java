package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.Vector3;

/**
 * Everything that a robot senses in one cycle of 20 ms, as SimSpark sends it. Whatever a message omits is empty here.
 *
 * <p>Frames: the torso frame has x to the robot's right, y forward and z up.
 *
 * @param seconds simulated time since the server was started, in seconds; grows by 0.02 in each cycle
 * @param gameState what the referee reports; in every message of a real server
 * @param heard messages of this and other robots that arrived in this cycle; own, team-mate's, opponent's
 * @param gyro angular velocity of the torso about the axes of the torso frame in degrees per second
 * @param accelerometer specific force at the torso's centre in the torso frame, as an IMU measures it, in metres per square
 *     second: (0, 0, 9.81) at rest, (0, 0, 0) in free fall
 * @param jointAngles angles of all hinges in degrees
 * @param footForces contact forces on the feet
 * @param vision what the camera recognises; present in every third message
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

    /** Makes the list unmodifiable. */
    public PerceptorMessage {
        heard = List.copyOf(heard);
    }
}
