package org.robonewbie.workshop.fidelity;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.simulator.world.Robot;

/**
 * Sensor values of the simulated robot in one cycle.
 *
 * @param jointDegrees joint angles, keyed by perceptor name
 * @param acceleration acceleration in m/s²
 * @param gyro angular velocity in degrees per second
 * @param footForces forces in newtons at points in metres
 */
record Measurements(Map<String, Double> jointDegrees, Vector3 acceleration, Vector3 gyro, FootForces footForces) {

    /** Reads the values from the robot, before they are rounded for a message. */
    static Measurements of(Robot robot) {
        Map<String, Double> joints = new HashMap<>();
        List<Hinge> hinges = robot.nao().hinges();
        for (int i = 0; i < hinges.size(); i++) {
            joints.put(hinges.get(i).perceptorName(), robot.jointDegrees(i));
        }
        return new Measurements(joints, robot.acceleration(), robot.gyroDegreesPerSecond(), robot.footForces());
    }

    /** Reads the values from a server message, rounded as printed. */
    static Measurements of(PerceptorMessage message) {
        Map<String, Double> joints = new HashMap<>();
        for (Joint joint : Joint.values()) {
            message.jointAngles().degrees(joint).ifPresent(degrees -> joints.put(joint.perceptorName(), degrees));
        }
        message.jointAngles().extraHinges().forEach(hinge -> joints.put(hinge.perceptorName(), hinge.degrees()));
        return new Measurements(
                joints, orNotANumber(message.accelerometer()), orNotANumber(message.gyro()), message.footForces());
    }

    private static Vector3 orNotANumber(Optional<Vector3> measured) {
        return measured.orElse(new Vector3(Double.NaN, Double.NaN, Double.NaN));
    }
}
