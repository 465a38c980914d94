package org.robonewbie.agent.motion;

import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.MotionPlayer;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;

/** Joints that do exactly what they are told, with the simulator's delay: an answer to message k acts before message k + 2. */
final class IdealRobot {

    private final double[] degrees;
    private double[] pending = new double[Joint.COUNT];

    IdealRobot(Posture start) {
        degrees = start.toArray();
    }

    /** One cycle: senses, lets the player think, and turns the joints by what was sent one cycle ago. */
    void cycle(JointStates joints, Motors motors, MotionPlayer player) {
        sense(joints);
        player.step(motors);
        act(motors);
    }

    void sense(JointStates joints) {
        for (Joint joint : Joint.values()) {
            joints.sense(joint, degrees[joint.ordinal()]);
        }
    }

    void act(Motors motors) {
        motors.endCycle();
        double[] sent = new double[Joint.COUNT];
        for (Joint joint : Joint.values()) {
            degrees[joint.ordinal()] += pending[joint.ordinal()] * Cycle.SECONDS;
            sent[joint.ordinal()] = motors.sentDegreesPerSecond(joint);
        }
        pending = sent;
    }

    double degrees(Joint joint) {
        return degrees[joint.ordinal()];
    }
}
