package org.robonewbie.simulator.export;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot of the simulator in the Unified Robot Description Format. The frame of each link is at its joint, because the format requires it;
 * collision shapes are those of the simulator.
 */
public final class UrdfFile {

    private final RobotModel robot;
    private final XmlText xml;

    private UrdfFile(RobotModel robot, String head) {
        this.robot = robot;
        xml = new XmlText(head);
    }

    /**
     * Describes a robot.
     *
     * @param robot the robot; its bodies are parallel to their parents while all joints are at 0°
     * @param head text of the comment at the beginning, such as licence and version; without two hyphens in a row
     * @return the contents of the file
     */
    public static String of(RobotModel robot, String head) {
        return new UrdfFile(robot, head).written();
    }

    private String written() {
        xml.begin("robot", "name", robot.name());
        for (int i = 0; i < robot.bodies().size(); i++) {
            addLink(robot.bodies().get(i), origin(i));
        }
        for (RobotJoint joint : robot.joints()) {
            addJoint(joint);
        }
        xml.end("robot");
        return xml.toString();
    }

    /** Returns the origin of a link's frame in the frame of the body. */
    private Vector3 origin(int body) {
        return robot.joints().stream()
                .filter(joint -> joint.body() == body)
                .findFirst()
                .map(RobotJoint::anchor)
                .orElse(Vector3.ZERO);
    }

    private void addLink(RobotBody body, Vector3 origin) {
        Vector3 centre = body.inertialPose().position().minus(origin);
        Vector3 inertia = body.inertia();
        xml.begin("link", "name", name(body));
        xml.begin("inertial");
        xml.add("origin", "xyz", centre);
        xml.add("mass", "value", body.massKg());
        xml.add("inertia", "ixx", inertia.x(), "ixy", 0, "ixz", 0, "iyy", inertia.y(), "iyz", 0, "izz", inertia.z());
        xml.end("inertial");
        for (PlacedShape placed : body.shapes()) {
            Vector3 at = placed.pose().position().minus(origin);
            addShape("visual", placed.shape(), at);
            if (placed.collides()) {
                addShape("collision", placed.shape(), at);
            }
        }
        xml.end("link");
    }

    private static String name(RobotBody body) {
        return body.parent() == RobotBody.NO_PARENT ? MjcfFile.TORSO : body.name();
    }

    private void addShape(String use, Shape shape, Vector3 centre) {
        xml.begin(use);
        xml.add("origin", "xyz", centre);
        xml.begin("geometry");
        if (shape instanceof Shape.Box box) {
            xml.add("box", "size", box.size());
        } else if (shape instanceof Shape.Capsule capsule) {
            // The format has no capsules; the cylinder has the length of the capsule with its ends.
            xml.add(
                    "cylinder",
                    "radius",
                    capsule.radius(),
                    "length",
                    capsule.size().z());
        } else {
            xml.add("sphere", "radius", ((Shape.Sphere) shape).radius());
        }
        xml.end("geometry");
        xml.end(use);
    }

    private void addJoint(RobotJoint joint) {
        RobotBody body = robot.bodies().get(joint.body());
        Vector3 place = body.pose().position().plus(joint.anchor());
        xml.begin("joint", "name", joint.perceptorName(), "type", "revolute");
        xml.add("origin", "xyz", place.minus(origin(body.parent())));
        xml.add("parent", "link", name(robot.bodies().get(body.parent())));
        xml.add("child", "link", body.name());
        xml.add("axis", "xyz", joint.axis());
        xml.add(
                "limit",
                "lower",
                PortableMath.toRadians(joint.minDegrees()),
                "upper",
                PortableMath.toRadians(joint.maxDegrees()),
                "effort",
                Robot.MAX_TORQUE,
                "velocity",
                MjcfFile.maxRadiansPerSecond(joint));
        xml.end("joint");
    }
}
