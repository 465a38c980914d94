package org.robonewbie.trial;

import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision;

/** What a robot senses in one cycle, in the precision that messages carry. Valid until the next cycle. */
public interface SensorReadings {

    /**
     * Reads a joint's angle.
     *
     * @param joint the joint
     * @return degrees, in hundredths
     */
    double degrees(Joint joint);

    /**
     * Passes the angles of all joints on.
     *
     * @param joints takes the angles
     */
    default void sense(JointStates joints) {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, degrees(joint));
        }
    }

    /** {@return the angular velocity of the torso in degrees per second, about SimSpark's axes: right, forward, up} */
    Vector3 gyro();

    /** {@return the acceleration that the torso feels in metres per second squared, along SimSpark's axes: right, forward, up} */
    Vector3 acceleration();

    /** {@return the contact forces on the feet, along SimSpark's axes} */
    FootForces feet();

    /**
     * {@return the camera's picture of this cycle, empty if there is none; in a direct trial its numbers are more precise than
     * those of a message}
     */
    Optional<Vision> picture();

    /** {@return the whole message, as an agent gets it} */
    PerceptorMessage message();

    /** {@return the text of the message, as it is sent} */
    MessageBuffer text();
}
