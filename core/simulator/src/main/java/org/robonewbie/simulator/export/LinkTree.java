package org.robonewbie.simulator.export;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.MassDistribution;

/** The links of a robot as a tree. Positions are in metres with x forward, y left, z up, relative to the torso's centre. */
final class LinkTree {

    /** Name of the root in exported files; SimSpark calls it {@code body}. */
    static final String TORSO = "torso";

    private final NaoModel model;

    LinkTree(RobotType type) {
        model = NaoModel.of(type);
    }

    Link root() {
        return model.links().get(0);
    }

    List<Hinge> hinges() {
        return model.hinges();
    }

    List<Link> links() {
        return model.links();
    }

    /** Returns the hinge between a link and its parent; empty for the torso. */
    Optional<Hinge> hinge(Link link) {
        return hinges().stream()
                .filter(hinge -> hinge.child().equals(link.name()))
                .findFirst();
    }

    List<Link> children(Link link) {
        return hinges().stream()
                .filter(hinge -> hinge.parent().equals(link.name()))
                .map(hinge -> model.links().get(model.linkIndex(hinge.child())))
                .toList();
    }

    Link parent(Hinge hinge) {
        return model.links().get(model.linkIndex(hinge.parent()));
    }

    static String name(Link link) {
        return link.name().equals(NaoModel.TORSO) ? TORSO : link.name();
    }

    static Vector3 centre(Link link) {
        return SimSparkFrame.toBody(link.position());
    }

    static Vector3 anchor(Hinge hinge) {
        return SimSparkFrame.toBody(hinge.anchor());
    }

    static Vector3 axis(Hinge hinge) {
        return SimSparkFrame.toBody(hinge.axis());
    }

    /** Returns the size of a link's bounding box along x forward, y left and z up. */
    static Vector3 size(Link link) {
        return turned(link.shape().size());
    }

    /** Returns the moments of inertia about the axes forward, left and up through the link's centre, in kg m². */
    static Vector3 inertia(Link link) {
        return turned(MassDistribution.of(link.shape(), link.massKg()).inertia());
    }

    /** Returns the height of the torso's centre above the ground at which the soles touch it, with all joints at 0. */
    double standingHeight() {
        return -links().stream()
                .mapToDouble(link -> centre(link).z() - size(link).z() / 2)
                .min()
                .orElseThrow();
    }

    /** Returns what has a value per axis, without a sign, for the axes of an exported file. */
    private static Vector3 turned(Vector3 perAxis) {
        return new Vector3(perAxis.y(), perAxis.x(), perAxis.z());
    }

    /** Returns the radius of a capsule or a sphere. */
    static double radius(Shape shape) {
        return shape instanceof Shape.Capsule capsule ? capsule.radius() : ((Shape.Sphere) shape).radius();
    }
}
