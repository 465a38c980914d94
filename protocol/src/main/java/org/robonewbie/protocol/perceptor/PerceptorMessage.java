package org.robonewbie.protocol.perceptor;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.robonewbie.nao.Vector3;

/**
 * All that a robot senses in one cycle of 20 ms, as SimSpark sends it. Whatever a message leaves out is empty here.
 *
 * <p>Frames: the torso frame has x to the robot's right, y forward and z up.
 *
 * @param seconds simulated time since the server was started, in seconds; grows by 0.02 in each cycle
 * @param gameState what the referee says; in every message of a real server
 * @param heard messages of this and other robots that arrived in this cycle; own, team-mate's, opponent's
 * @param gyro turning speed of the torso about the axes of the torso frame in degrees per second
 * @param accelerometer acceleration of the torso's centre without gravity's pull in the torso frame, in metres per square
 *     second; (0, 0, 9.81) for a robot that stands still
 * @param jointAngles angles of all hinges in degrees
 * @param footForces what presses against the feet
 * @param vision what the camera recognises; present in each third message
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

    /** A message that says nothing. */
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
