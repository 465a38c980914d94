package org.robonewbie.learning.environment;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.agent.policy.Quantity;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.protocol.perceptor.FootForces;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.world.Ball;
import org.robonewbie.simulator.world.Robot;

/**
 * Complete true state of a robot and the ball, without noise or delay, for asymmetric critics and rewards. Positions and velocities are in
 * the world frame. Directions of the torso and forces are along the axes of an agent: forward, left, up.
 */
final class TrueState {

    /** Names and units of the components. */
    static final List<Quantity> QUANTITIES = quantities();

    private static final Joint[] JOINTS = Joint.values();

    private TrueState() {}

    private static List<Quantity> quantities() {
        List<Quantity> all = new ArrayList<>();
        add(all, "torso", "m", "x", "y", "z");
        add(all, "torso.velocity", "m/s", "x", "y", "z");
        add(all, "torso.up", "1", "forward", "left", "up");
        add(all, "torso.heading", "1", "cosine", "sine");
        add(all, "torso.turn", "degrees/s", "forward", "left", "up");
        for (Joint joint : Joint.values()) {
            all.add(new Quantity("joint." + joint, "degrees"));
        }
        for (Joint joint : Joint.values()) {
            all.add(new Quantity("speed." + joint, "degrees/s"));
        }
        for (Joint joint : Joint.values()) {
            all.add(new Quantity("torque." + joint, "N m"));
        }
        add(all, "leftFoot.force", "N", "forward", "left", "up");
        add(all, "rightFoot.force", "N", "forward", "left", "up");
        add(all, "ball", "m", "x", "y", "z");
        add(all, "ball.velocity", "m/s", "x", "y", "z");
        return List.copyOf(all);
    }

    private static void add(List<Quantity> all, String name, String unit, String... parts) {
        for (String part : parts) {
            all.add(new Quantity(name + "." + part, unit));
        }
    }

    /** Returns the current state, in the order of {@link #QUANTITIES}. */
    static float[] of(Robot robot, Ball ball) {
        Row row = new Row();
        BodyPose torso = robot.torso();
        row.add(torso.position());
        row.add(robot.torsoVelocity());
        row.add(SimSparkFrame.toBody(torso.rotation().inverse().apply(new Vector3(0, 0, 1))));
        double heading = Math.toRadians(robot.headingDegrees());
        row.add(Math.cos(heading));
        row.add(Math.sin(heading));
        row.add(SimSparkFrame.toBody(robot.gyroDegreesPerSecond()));
        for (Joint joint : JOINTS) {
            row.add(robot.jointDegrees(joint));
        }
        for (Joint joint : JOINTS) {
            row.add(robot.jointDegreesPerSecond(joint));
        }
        for (Joint joint : JOINTS) {
            row.add(robot.jointTorque(joint));
        }
        FootForces feet = robot.footForces();
        row.add(force(feet.left()));
        row.add(force(feet.right()));
        row.add(ball.position());
        row.add(ball.velocity());
        return row.values;
    }

    private static Vector3 force(Optional<FootForce> foot) {
        return foot.map(FootForce::force).map(SimSparkFrame::toBody).orElse(Vector3.ZERO);
    }

    private static final class Row {

        private final float[] values = new float[QUANTITIES.size()];
        private int count;

        void add(double value) {
            values[count++] = (float) value;
        }

        void add(Vector3 vector) {
            add(vector.x());
            add(vector.y());
            add(vector.z());
        }
    }
}
