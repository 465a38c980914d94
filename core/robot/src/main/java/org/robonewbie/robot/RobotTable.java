package org.robonewbie.robot;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Shape;

/** Builds a model of the league's robots from the figures of a MuJoCo model, in the units of that: radians and metres. */
final class RobotTable {

    static final Vector3 X = new Vector3(1, 0, 0);
    static final Vector3 Y = new Vector3(0, 1, 0);
    static final Vector3 Z = new Vector3(0, 0, 1);
    static final Rotation ALONG_X = Rotation.about(Y, 90);
    static final Rotation ALONG_Y = Rotation.about(X, 90);

    /** Gains with which T1 and K1 keep their stance for 10 s in MuJoCo. */
    private static final double STIFFNESS = 200;

    private static final double DAMPING = 5;

    /** Angles of the stance, by the end of the joint's name. */
    private static final Map<String, Double> STANCE =
            Map.of("_Hip_Pitch", -20.0, "_Knee_Pitch", 40.0, "_Ankle_Pitch", -20.0);

    private final String name;
    private final double stanceHeight;
    private final List<RobotBody> bodies = new ArrayList<>();
    private final List<RobotJoint> joints = new ArrayList<>();
    private final Map<String, Integer> indexOfBody = new HashMap<>();

    RobotTable(String name, double stanceHeight) {
        this.name = name;
        this.stanceHeight = stanceHeight;
    }

    static Pose at(double x, double y, double z) {
        return at(x, y, z, Rotation.NONE);
    }

    static Pose at(double x, double y, double z, Rotation rotation) {
        return new Pose(new Vector3(x, y, z), rotation);
    }

    /** A pose whose rotation is a quaternion of any length but 0. */
    static Pose at(double x, double y, double z, double qw, double qx, double qy, double qz) {
        double length = Math.sqrt(qw * qw + qx * qx + qy * qy + qz * qz);
        return at(x, y, z, new Rotation(qw / length, qx / length, qy / length, qz / length));
    }

    RobotTable torso(String bodyName) {
        return body(bodyName, RobotBody.NO_PARENT, Pose.ORIGIN);
    }

    RobotTable body(String bodyName, String parent, Pose pose) {
        Integer index = indexOfBody.get(parent);
        if (index == null) {
            throw new IllegalArgumentException(
                    "Body \"" + bodyName + "\" of robot " + name + " has the unknown parent \"" + parent + "\".");
        }
        return body(bodyName, index, pose);
    }

    RobotTable mass(double massKg, Pose inertialPose, double xx, double yy, double zz) {
        RobotBody body = last();
        return replaceLast(new RobotBody(
                body.name(), body.parent(), body.pose(), massKg, inertialPose, new Vector3(xx, yy, zz), body.shapes()));
    }

    RobotTable joint(
            String jointName,
            String perceptorName,
            String effectorName,
            Vector3 axis,
            double minRadians,
            double maxRadians,
            double maxNewtonMetres) {
        joints.add(new RobotJoint(
                joints.size(),
                jointName,
                perceptorName,
                effectorName,
                bodies.size() - 1,
                Vector3.ZERO,
                axis,
                PortableMath.toDegrees(minRadians),
                PortableMath.toDegrees(maxRadians),
                new Motor.Torque(maxNewtonMetres, STIFFNESS, DAMPING),
                stanceDegrees(jointName)));
        return this;
    }

    RobotTable box(Pose pose, double x, double y, double z) {
        return shape(new Shape.Box(new Vector3(x, y, z)), pose);
    }

    RobotTable sphere(Pose pose, double radius) {
        return shape(new Shape.Sphere(radius), pose);
    }

    RobotTable capsule(Pose pose, double radius, double length) {
        return shape(new Shape.Capsule(radius, length), pose);
    }

    RobotModel model() {
        return new RobotModel(name, bodies, joints, stanceHeight);
    }

    private RobotTable body(String bodyName, int parent, Pose pose) {
        indexOfBody.put(bodyName, bodies.size());
        bodies.add(new RobotBody(bodyName, parent, pose, 0, Pose.ORIGIN, Vector3.ZERO, List.of()));
        return this;
    }

    private RobotTable shape(Shape shape, Pose pose) {
        RobotBody body = last();
        List<PlacedShape> shapes = new ArrayList<>(body.shapes());
        shapes.add(new PlacedShape(shape, pose, true));
        return replaceLast(new RobotBody(
                body.name(), body.parent(), body.pose(), body.massKg(), body.inertialPose(), body.inertia(), shapes));
    }

    private RobotBody last() {
        return bodies.get(bodies.size() - 1);
    }

    private RobotTable replaceLast(RobotBody body) {
        bodies.set(bodies.size() - 1, body);
        return this;
    }

    private static double stanceDegrees(String jointName) {
        return STANCE.entrySet().stream()
                .filter(angle -> jointName.endsWith(angle.getKey()))
                .mapToDouble(Map.Entry::getValue)
                .findFirst()
                .orElse(0);
    }
}
