package org.robonewbie.simulator.export;

import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.world.Robot;

/**
 * A robot in the Unified Robot Description Format. The frame of each link is at its joint, because the format requires it; collision
 * shapes are those of the simulator.
 */
public final class UrdfFile {

    private final LinkTree tree;
    private final XmlText xml;
    private final String name;

    private UrdfFile(RobotType type, String head) {
        tree = new LinkTree(type);
        xml = new XmlText(head);
        name = MjcfFile.nameOf(type);
    }

    /**
     * Describes a robot.
     *
     * @param type the robot type
     * @param head text of the comment at the beginning, such as licence and version; without two hyphens in a row
     * @return the contents of the file
     */
    public static String of(RobotType type, String head) {
        return new UrdfFile(type, head).written();
    }

    private String written() {
        xml.begin("robot", "name", name);
        for (Link link : tree.links()) {
            addLink(link);
        }
        for (Hinge hinge : tree.hinges()) {
            addJoint(hinge);
        }
        xml.end("robot");
        return xml.toString();
    }

    private Vector3 origin(Link link) {
        return tree.hinge(link).map(LinkTree::anchor).orElse(LinkTree.centre(link));
    }

    private void addLink(Link link) {
        Vector3 centre = LinkTree.centre(link).minus(origin(link));
        Vector3 inertia = LinkTree.inertia(link);
        xml.begin("link", "name", LinkTree.name(link));
        xml.begin("inertial");
        xml.add("origin", "xyz", centre);
        xml.add("mass", "value", link.massKg());
        xml.add("inertia", "ixx", inertia.x(), "ixy", 0, "ixz", 0, "iyy", inertia.y(), "iyz", 0, "izz", inertia.z());
        xml.end("inertial");
        addShape("visual", link, centre);
        if (link.collides()) {
            addShape("collision", link, centre);
        }
        xml.end("link");
    }

    private void addShape(String use, Link link, Vector3 centre) {
        xml.begin(use);
        xml.add("origin", "xyz", centre);
        xml.begin("geometry");
        if (link.shape() instanceof Shape.Box) {
            xml.add("box", "size", LinkTree.size(link));
        } else if (link.shape() instanceof Shape.Capsule capsule) {
            // The format has no capsules; the cylinder has the length of the capsule with its ends.
            xml.add(
                    "cylinder",
                    "radius",
                    capsule.radius(),
                    "length",
                    capsule.size().z());
        } else {
            xml.add("sphere", "radius", LinkTree.radius(link.shape()));
        }
        xml.end("geometry");
        xml.end(use);
    }

    private void addJoint(Hinge hinge) {
        Link parent = tree.parent(hinge);
        xml.begin("joint", "name", hinge.perceptorName(), "type", "revolute");
        xml.add("origin", "xyz", LinkTree.anchor(hinge).minus(origin(parent)));
        xml.add("parent", "link", LinkTree.name(parent));
        xml.add("child", "link", hinge.child());
        xml.add("axis", "xyz", LinkTree.axis(hinge));
        xml.add(
                "limit",
                "lower",
                PortableMath.toRadians(hinge.minDegrees()),
                "upper",
                PortableMath.toRadians(hinge.maxDegrees()),
                "effort",
                Robot.MAX_TORQUE,
                "velocity",
                hinge.maxRadiansPerSecond());
        xml.end("joint");
    }
}
