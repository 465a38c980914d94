package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.robot.Motor;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;

/**
 * The model of a robot that is not shipped, from the nodes of an RSMP scene.
 *
 * <p>Each body turns about three axes in its origin, because RSMP does not send joints: a body is preceded by two without mass, which
 * turn about x and y. Shapes are those that the server sends: boxes, spheres and cylinders; it sends no capsules, and meshes only by
 * the name of their file.
 */
final class RsmpModel {

    private static final Vector3[] AXES = {new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)};
    private static final String[] AXIS_NAMES = {"x", "y", "z"};
    private static final String UNNAMED = "robot";

    private final List<RobotBody> bodies = new ArrayList<>();
    private final List<RobotJoint> joints = new ArrayList<>();

    private RsmpModel() {}

    static RobotModel of(RsmpNode torso) {
        RsmpModel model = new RsmpModel();
        model.bodies.add(body("torso", RobotBody.NO_PARENT, Pose.ORIGIN, shapes(torso)));
        model.addChildren(torso, 0);
        return new RobotModel(name(torso), model.bodies, model.joints, 0);
    }

    /** Returns the angles of all joints for the current poses of the nodes that the model was made from. */
    static double[] degrees(RobotModel model, RsmpNode torso) {
        List<RsmpNode> moving = new ArrayList<>();
        collect(torso, moving);
        double[] degrees = new double[model.joints().size()];
        for (int i = 0; i < moving.size(); i++) {
            Rotation start = model.bodies().get(1 + 3 * i).pose().rotation();
            double[] angles = angles(start.inverse().times(moving.get(i).pose().rotation()));
            System.arraycopy(angles, 0, degrees, 3 * i, angles.length);
        }
        return degrees;
    }

    private static void collect(RsmpNode node, List<RsmpNode> moving) {
        for (RsmpNode child : node.transforms()) {
            if (isBody(child)) {
                moving.add(child);
                collect(child, moving);
            }
        }
    }

    /** A transform that carries nothing, or one mesh, is a shape of its parent. */
    private static boolean isBody(RsmpNode node) {
        return !node.transforms().isEmpty() || node.children().size() > 1;
    }

    private void addChildren(RsmpNode node, int parent) {
        for (RsmpNode child : node.transforms()) {
            if (isBody(child)) {
                addChildren(child, add(child, parent));
            }
        }
    }

    /** Adds a body with its three joints; returns its index. */
    private int add(RsmpNode node, int parent) {
        String name = Integer.toString(joints.size() / 3 + 1);
        int inner = parent;
        for (int axis = 0; axis < AXES.length; axis++) {
            boolean last = axis == AXES.length - 1;
            Pose pose = axis == 0 ? node.pose() : Pose.ORIGIN;
            bodies.add(body(last ? name : name + AXIS_NAMES[axis], inner, pose, last ? shapes(node) : List.of()));
            inner = bodies.size() - 1;
            joints.add(joint(name + AXIS_NAMES[axis], inner, AXES[axis]));
        }
        return inner;
    }

    private static RobotBody body(String name, int parent, Pose pose, List<PlacedShape> shapes) {
        return new RobotBody(name, parent, pose, 0, Pose.ORIGIN, Vector3.ZERO, shapes);
    }

    private RobotJoint joint(String name, int body, Vector3 axis) {
        Motor none = new Motor.Torque(0, 0, 0);
        return new RobotJoint(joints.size(), name, name, name, body, Vector3.ZERO, axis, -180, 180, none, 0);
    }

    private static List<PlacedShape> shapes(RsmpNode node) {
        List<PlacedShape> shapes = new ArrayList<>();
        for (RsmpNode child : node.children()) {
            if (!child.isTransform()) {
                child.mesh().ifPresent(mesh -> add(mesh, Pose.ORIGIN, shapes));
            } else if (!isBody(child)) {
                child.meshes().forEach(mesh -> add(mesh, child.pose(), shapes));
            }
        }
        return shapes;
    }

    private static void add(MeshNode mesh, Pose pose, List<PlacedShape> shapes) {
        double x = Math.abs(mesh.scaleX());
        double z = Math.abs(mesh.scaleZ());
        switch (mesh.form().name()) {
            case "StdUnitBox" ->
                shapes.add(new PlacedShape(new Shape.Box(new Vector3(x, Math.abs(mesh.scaleY()), z)), pose, true));
            case "StdUnitSphere" -> shapes.add(new PlacedShape(new Shape.Sphere(x), pose, true));
            case "StdUnitCylinder" ->
                shapes.add(new PlacedShape(new Shape.Capsule(x, Math.max(0, z - 2 * x)), pose, true));
            default -> {} // a mesh file
        }
    }

    /** Returns the name of the folder of the robot's meshes, such as {@code models/T1/Trunk.STL}, if it has some. */
    private static String name(RsmpNode torso) {
        return torso.meshes()
                .map(mesh -> mesh.form().name().split("/", -1))
                .filter(path -> path.length == 3 && path[0].equals("models"))
                .map(path -> path[1])
                .findFirst()
                .orElse(UNNAMED);
    }

    /** Splits a rotation into one about x, then one about the new y, then one about the new z; in degrees. */
    private static double[] angles(Rotation r) {
        double sinY = 2 * (r.x() * r.z() + r.w() * r.y());
        return new double[] {
            atan2(2 * (r.w() * r.x() - r.y() * r.z()), 1 - 2 * (r.x() * r.x() + r.y() * r.y())),
            PortableMath.toDegrees(PortableMath.asin(Math.max(-1, Math.min(1, sinY)))),
            atan2(2 * (r.w() * r.z() - r.x() * r.y()), 1 - 2 * (r.y() * r.y() + r.z() * r.z()))
        };
    }

    private static double atan2(double y, double x) {
        return PortableMath.toDegrees(PortableMath.atan2(y, x));
    }
}
