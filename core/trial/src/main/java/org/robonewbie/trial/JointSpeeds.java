package org.robonewbie.trial;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.protocol.effector.EffectorCommand;

/** Converts joint speeds to commands. As with an agent, no command is sent for a motor that remains at rest. */
final class JointSpeeds {

    private static final Joint[] JOINTS = Joint.values();

    private final boolean[] turning = new boolean[Joint.COUNT];

    static double[] checked(double... degreesPerSecond) {
        if (degreesPerSecond.length == 0) {
            return new double[Joint.COUNT];
        }
        if (degreesPerSecond.length != Joint.COUNT) {
            throw new IllegalArgumentException(degreesPerSecond.length + " joint speeds for a robot with " + Joint.COUNT
                    + " joints. Pass one speed for each Joint, in the order of the joints.");
        }
        return degreesPerSecond.clone();
    }

    List<EffectorCommand> commands(Motors motors) {
        return commands(motors.sentDegreesPerSecond());
    }

    List<EffectorCommand> commands(double... degreesPerSecond) {
        List<EffectorCommand> commands = new ArrayList<>(Joint.COUNT);
        for (Joint joint : JOINTS) {
            int i = joint.ordinal();
            double speed = degreesPerSecond[i];
            if (Double.isNaN(speed)) {
                throw new IllegalArgumentException("Joint speed NaN for " + joint + ". Was something divided by zero?");
            }
            if (speed != 0 || turning[i]) {
                commands.add(new EffectorCommand.SetHingeSpeed(joint.effectorName(), PortableMath.toRadians(speed)));
            }
            turning[i] = speed != 0;
        }
        return commands;
    }
}
