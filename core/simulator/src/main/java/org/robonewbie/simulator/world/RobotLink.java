package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.BoundingBox;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * A link of a robot. The origin of its rigid body is the centre of mass, and the axes are the principal axes of inertia; the frame of
 * the link can differ from that. All frames have SimSpark's axes.
 */
final class RobotLink {

    private final RigidBody body;
    private final BodyPose start;
    private final BodyPose inertial;
    private final BodyPose fromInertial;
    private final boolean centred;
    private final List<Part> parts = new ArrayList<>();

    /** A shape that collides, with its pose relative to the link's frame. */
    private record Part(Shape shape, BodyPose pose) {}

    /**
     * Creates a link.
     *
     * @param body the rigid body
     * @param start frame of the link relative to the torso's frame while all joints are at 0°
     * @param inertial pose of the rigid body relative to the link's frame
     */
    RobotLink(RigidBody body, BodyPose start, BodyPose inertial) {
        this.body = body;
        this.start = start;
        this.inertial = inertial;
        this.fromInertial = inertial.inverse();
        this.centred = inertial.equals(BodyPose.ORIGIN);
    }

    RigidBody body() {
        return body;
    }

    BodyPose start() {
        return start;
    }

    BodyPose pose() {
        return centred ? body.pose() : body.pose().times(fromInertial);
    }

    Vector3 position() {
        return centred ? body.position() : pose().position();
    }

    /** Returns the direction of the frame's y axis in the world frame. */
    Vector3 axisY() {
        return centred ? body.axisY() : pose().rotation().axisY();
    }

    /** Returns the vertical component of the frame's z axis. */
    double upwards() {
        return centred ? body.upwards() : pose().rotation().zz();
    }

    /** Adds a shape that collides; returns its pose relative to the rigid body. */
    BodyPose addShape(Shape shape, BodyPose relative) {
        parts.add(new Part(shape, relative));
        return centred ? relative : fromInertial.times(relative);
    }

    /** Extends a bounding box by the shapes of this link. */
    BoundingBox addTo(BoundingBox box) {
        BoundingBox extended = box;
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            BodyPose pose = part.pose.equals(BodyPose.ORIGIN) ? pose() : pose().times(part.pose);
            extended = extended.union(BoundingBox.of(part.shape, pose));
        }
        return extended;
    }

    /** Places the link's frame in the world frame. */
    void place(BodyPose pose) {
        BodyPose placed = centred ? pose : pose.times(inertial);
        body.setPosition(placed.position());
        body.setRotation(placed.rotation());
    }

    /** Places the link as it is while all joints are at 0° and the torso's axes are those of the world. */
    void putToStart(Vector3 torso) {
        place(new BodyPose(torso.plus(start.position()), start.rotation()));
    }
}
