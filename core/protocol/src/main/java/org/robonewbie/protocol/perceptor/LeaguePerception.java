package org.robonewbie.protocol.perceptor;

import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Rotation;

/**
 * The sensor readings of a robot in one cycle, as sent by RCSSServerMJ, the server of the RoboCup 3D league since 2026.
 *
 * @param message what SimSpark sends too, in SimSpark's frames; without joint angles and foot forces
 * @param joints angles and speeds of the joints
 * @param position true position of the torso in metres, in a frame with its origin at the centre spot and x towards the right goal
 * @param orientation true orientation of the torso in that frame
 */
public record LeaguePerception(
        PerceptorMessage message, Joints joints, Optional<Vector3> position, Optional<Rotation> orientation) {

    /** Angles and speeds of a robot's joints. Immutable. */
    public static final class Joints {

        private final double[] degrees;
        private final double[] degreesPerSecond;

        /** Takes ownership of the arrays; NaN means that the message does not contain the joint. */
        Joints(double[] degrees, double[] degreesPerSecond) {
            this.degrees = degrees;
            this.degreesPerSecond = degreesPerSecond;
        }

        /**
         * Returns the angle of a joint.
         *
         * @param index index of the joint in the robot's model
         * @return its angle in degrees; NaN if the message does not contain it
         */
        public double degrees(int index) {
            return degrees[index];
        }

        /**
         * Returns the speed of a joint.
         *
         * @param index index of the joint in the robot's model
         * @return its speed in degrees per second; NaN if the message does not contain it
         */
        public double degreesPerSecond(int index) {
            return degreesPerSecond[index];
        }
    }
}
