package org.robonewbie.trial;

import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.Vision;

/** The sensor readings of a robot in one cycle, rounded as in messages. Valid until the next cycle. */
public interface SensorReadings {

    /**
     * Returns the angle of a joint.
     *
     * @param joint the joint
     * @return the angle in degrees, rounded to hundredths
     */
    double degrees(Joint joint);

    /**
     * Copies the angles of all joints.
     *
     * @param joints receives the angles
     */
    default void sense(JointStates joints) {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, degrees(joint));
        }
    }

    /** {@return the angular velocity of the torso in degrees per second, about SimSpark's axes: right, forward, up} */
    Vector3 gyro();

    /**
     * {@return the specific force at the torso, as measured by an accelerometer, in metres per second squared, along SimSpark's
     * axes: right, forward, up}
     */
    Vector3 acceleration();

    /** {@return the contact forces on the feet, along SimSpark's axes} */
    FootForces feet();

    /** {@return the camera image of this cycle, empty if there is none; not rounded in a direct trial} */
    Optional<Vision> picture();

    /** {@return the complete parsed message} */
    PerceptorMessage message();

    /** {@return the text of the message in wire format} */
    MessageBuffer text();
}
