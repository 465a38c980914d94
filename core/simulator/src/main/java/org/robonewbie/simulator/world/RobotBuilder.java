package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.HingeDefinition;
import org.robonewbie.simulator.physics.MotorHinge;
import org.robonewbie.simulator.physics.RigidBody;

/** Creates the bodies and hinges of a robot in its initial pose (SimSpark: hingejoint.rsg and the NAO's scene files). */
final class RobotBuilder {

    private static final double STOP_BOUNCE = 1;

    private final Robot robot;
    private final Assembly assembly;

    RobotBuilder(Robot robot, Assembly assembly) {
        this.robot = robot;
        this.assembly = assembly;
    }

    List<RigidBody> addBodies(Vector3 torso) {
        List<RigidBody> bodies = new ArrayList<>();
        for (Link link : robot.model().links()) {
            RigidBody body =
                    assembly.addBody(MassDistribution.of(link.shape(), link.massKg()), torso.plus(link.position()));
            if (link.collides()) {
                assembly.addCollider(body, link.shape(), SurfaceMaterials.ROBOT, new RobotPart(robot, bodies.size()));
            }
            bodies.add(body);
        }
        return bodies;
    }

    List<MotorHinge> addHinges(List<RigidBody> bodies, Vector3 torso) {
        List<MotorHinge> hinges = new ArrayList<>();
        for (Hinge hinge : robot.model().hinges()) {
            RigidBody child = bodies.get(robot.model().linkIndex(hinge.child()));
            RigidBody parent = bodies.get(robot.model().linkIndex(hinge.parent()));
            hinges.add(assembly.addHinge(child, parent, definition(hinge, torso)));
        }
        return hinges;
    }

    private static HingeDefinition definition(Hinge hinge, Vector3 torso) {
        return new HingeDefinition(
                torso.plus(hinge.anchor()),
                hinge.axis(),
                PortableMath.toRadians(hinge.minDegrees()),
                PortableMath.toRadians(hinge.maxDegrees()),
                Robot.MAX_TORQUE,
                STOP_BOUNCE);
    }
}
