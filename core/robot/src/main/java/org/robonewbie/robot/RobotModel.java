package org.robonewbie.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.motion.JointSpace;

/**
 * A robot as data: a tree of rigid bodies joined by motorised hinges.
 *
 * <p>All frames have x forward, y to the left and z up while every joint is at 0°, unless a body's pose turns them.
 *
 * <pre>{@code
 * RobotModel t1 = BoosterT1.MODEL;
 * double range = t1.joint("lle4").orElseThrow().maxDegrees();   // the left knee
 * }</pre>
 *
 * @param name name of the model, such as {@code T1}
 * @param bodies the bodies: the torso first, and each parent before its children
 * @param joints the joints in the order of the server's messages
 * @param stanceHeight height of the torso's frame above the ground in the stance, in metres
 */
public record RobotModel(String name, List<RobotBody> bodies, List<RobotJoint> joints, double stanceHeight) {

    /**
     * Copies the lists and checks the order of bodies and joints.
     *
     * @throws IllegalArgumentException if a body precedes its parent, or a joint's index is not its place in the list
     */
    public RobotModel {
        bodies = List.copyOf(bodies);
        joints = List.copyOf(joints);
        for (int i = 0; i < bodies.size(); i++) {
            int parent = bodies.get(i).parent();
            if (i == 0 ? parent != RobotBody.NO_PARENT : parent < 0 || parent >= i) {
                throw new IllegalArgumentException(
                        "Body \"" + bodies.get(i).name() + "\" of robot " + name + " has the parent " + parent
                                + ". The torso comes first, and each parent before its children.");
            }
        }
        for (int i = 0; i < joints.size(); i++) {
            RobotJoint joint = joints.get(i);
            if (joint.index() != i || joint.body() < 1 || joint.body() >= bodies.size()) {
                throw new IllegalArgumentException("Joint \"" + joint.name() + "\" of robot " + name
                        + " has index " + joint.index() + " and body " + joint.body() + " at place " + i
                        + ". The index is the joint's place, and the body is one that has a parent.");
            }
        }
    }

    /**
     * Returns the joint with a given name.
     *
     * @param anyName name of the joint, of its sensor or of its motor
     * @return the joint; empty if the robot has none of that name
     */
    public Optional<RobotJoint> joint(String anyName) {
        return joints.stream()
                .filter(joint -> joint.name().equals(anyName)
                        || joint.perceptorName().equals(anyName)
                        || joint.effectorName().equals(anyName))
                .findFirst();
    }

    /**
     * Returns the index of a body.
     *
     * @param bodyName name of the body
     * @return its index in {@link #bodies()}
     * @throws IllegalArgumentException if the robot has no such body
     */
    public int bodyIndex(String bodyName) {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).name().equals(bodyName)) {
                return i;
            }
        }
        throw new IllegalArgumentException("Robot " + name + " has no body \"" + bodyName + "\".");
    }

    /** {@return the joints in the order of the robot's motion files; for a NAO of any type, {@link JointSpace#NAO}} */
    public JointSpace jointSpace() {
        return NaoRobot.isNao(this)
                ? JointSpace.NAO
                : new JointSpace(name, joints.stream().map(RobotJoint::limits).toList());
    }

    /** {@return the mass of the whole robot in kilograms} */
    public double massKg() {
        return bodies.stream().mapToDouble(RobotBody::massKg).sum();
    }

    /** {@return the angles of all joints in the stance in degrees, by index} */
    public double[] stanceDegrees() {
        return joints.stream().mapToDouble(RobotJoint::stanceDegrees).toArray();
    }

    /**
     * Computes where each body is (forward kinematics).
     *
     * @param degrees the angle of each joint in degrees, by index
     * @return the frame of each body relative to the torso's frame, in the order of {@link #bodies()}
     * @throws IllegalArgumentException if the number of angles is not the number of joints
     */
    public List<Pose> bodyPoses(double[] degrees) {
        if (degrees.length != joints.size()) {
            throw new IllegalArgumentException("Robot " + name + " has " + joints.size() + " joints, but "
                    + degrees.length + " angles were given.");
        }
        Pose[] turns = new Pose[bodies.size()];
        joints.forEach(joint -> turns[joint.body()] = turn(joint, degrees[joint.index()]));
        List<Pose> poses = new ArrayList<>();
        for (int i = 0; i < turns.length; i++) {
            RobotBody body = bodies.get(i);
            Pose fixed = i == 0 ? body.pose() : poses.get(body.parent()).times(body.pose());
            poses.add(turns[i] == null ? fixed : fixed.times(turns[i]));
        }
        return List.copyOf(poses);
    }

    private static Pose turn(RobotJoint joint, double degrees) {
        Rotation rotation = Rotation.about(joint.axis(), degrees);
        return new Pose(joint.anchor().minus(rotation.apply(joint.anchor())), rotation);
    }
}
