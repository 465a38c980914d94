package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.robot.PlacedShape;
import org.robonewbie.robot.RobotBody;
import org.robonewbie.robot.RobotJoint;
import org.robonewbie.robot.RobotModel;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;
import org.robonewbie.simulator.physics.RotationMatrix;

/**
 * Creates the bodies and hinges of a robot with all joints at 0° (SimSpark: hingejoint.rsg and the NAO's scene files). Converts
 * the model's axes (x forward, y left) to SimSpark's (x right, y forward).
 */
final class RobotBuilder {

    private static final double STOP_BOUNCE = 1;

    private final Robot robot;
    private final Assembly assembly;
    private final RobotModel model;

    RobotBuilder(Robot robot, Assembly assembly) {
        this.robot = robot;
        this.assembly = assembly;
        this.model = robot.model();
    }

    /**
     * Checks that a robot can be built.
     *
     * @throws IllegalArgumentException if a body lacks mass, or a joint that connects it; the message says so
     */
    static void check(RobotModel model) {
        int[] joints = new int[model.bodies().size()];
        model.joints().forEach(joint -> joints[joint.body()]++);
        for (int i = 0; i < joints.length; i++) {
            RobotBody body = model.bodies().get(i);
            Vector3 inertia = body.inertia();
            if (!(body.massKg() > 0 && inertia.x() > 0 && inertia.y() > 0 && inertia.z() > 0)) {
                throw new IllegalArgumentException("Body \"" + body.name() + "\" of robot " + model.name()
                        + " has no mass or no inertia. Give each body both, so that it can be simulated.");
            }
            if (i > 0 && joints[i] != 1) {
                throw new IllegalArgumentException("Body \"" + body.name() + "\" of robot " + model.name() + " has "
                        + joints[i] + " joints. Give each body but the torso exactly one.");
            }
        }
    }

    List<RobotLink> addLinks(Vector3 torso) {
        List<RobotLink> links = new ArrayList<>();
        for (Pose pose : model.bodyPoses(new double[model.joints().size()])) {
            RobotBody body = model.bodies().get(links.size());
            BodyPose inertial = simSpark(body.inertialPose());
            BodyPose start = simSpark(pose);
            Vector3 inertia = exchanged(body.inertia());
            RigidBody rigid = assembly.addBody(new MassDistribution(body.massKg(), inertia), Vector3.ZERO);
            RobotLink link = new RobotLink(rigid, start, inertial);
            link.putToStart(torso);
            for (PlacedShape placed : body.shapes()) {
                addCollider(link, placed, links.size());
            }
            links.add(link);
        }
        return links;
    }

    private void addCollider(RobotLink link, PlacedShape placed, int index) {
        if (placed.collides()) {
            Shape shape = simSpark(placed.shape());
            BodyPose pose = link.addShape(shape, simSpark(placed.pose()));
            assembly.addCollider(link.body(), pose, shape, SurfaceMaterials.ROBOT, new RobotPart(robot, index));
        }
    }

    List<MotorHinge> addHinges(List<RobotLink> links, Vector3 torso) {
        List<MotorHinge> hinges = new ArrayList<>();
        for (RobotJoint joint : model.joints()) {
            RobotLink child = links.get(joint.body());
            RobotLink parent = links.get(model.bodies().get(joint.body()).parent());
            hinges.add(assembly.addHinge(child.body(), parent.body(), definition(joint, child.start(), torso)));
        }
        return hinges;
    }

    private static HingeDefinition definition(RobotJoint joint, BodyPose child, Vector3 torso) {
        return new HingeDefinition(
                torso.plus(child.toWorld(SimSparkFrame.fromBody(joint.anchor()))),
                child.rotation().apply(SimSparkFrame.fromBody(joint.axis())),
                PortableMath.toRadians(joint.minDegrees()),
                PortableMath.toRadians(joint.maxDegrees()),
                Robot.maxTorque(joint),
                STOP_BOUNCE);
    }

    /** Converts both frames of a pose. A rotation by 0 becomes exactly the identity. */
    private static BodyPose simSpark(Pose pose) {
        Pose converted = SimSparkFrame.fromBody(pose);
        RotationMatrix rotation =
                pose.rotation().w() == 1 ? RotationMatrix.IDENTITY : RotationMatrix.of(converted.rotation());
        return new BodyPose(converted.position(), rotation);
    }

    private static Shape simSpark(Shape shape) {
        return shape instanceof Shape.Box box ? new Shape.Box(exchanged(box.size())) : shape;
    }

    /** Exchanges x and y: the axes are the same but for their directions. */
    private static Vector3 exchanged(Vector3 sizes) {
        return new Vector3(sizes.y(), sizes.x(), sizes.z());
    }
}
