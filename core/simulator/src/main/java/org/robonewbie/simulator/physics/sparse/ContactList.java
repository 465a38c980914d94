package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** Contacts of a step: the points to report, and the joints for the solver. Both are pooled. */
final class ContactList implements OdeCollisions.Listener {

    private static final int MAX_UNLIMITED_POINTS = 400;

    private final Surfaces surfaces;
    private final List<Contact> points = new ArrayList<>();
    private final List<Contact> readOnly = Collections.unmodifiableList(points);
    private final List<ContactPoint> pointPool = new ArrayList<>();
    private final List<ContactJoint> joints = new ArrayList<>();
    private final List<ContactJoint> jointPool = new ArrayList<>();
    private boolean holdsRemovedBodies;
    private long step;
    private int pointsBetweenRobots;

    ContactList(Surfaces surfaces) {
        this.surfaces = surfaces;
    }

    List<Contact> points() {
        return readOnly;
    }

    /** Removes the contacts of the last step. */
    void begin() {
        step++;
        pointsBetweenRobots = 0;
        detachJoints();
        for (int i = 0; i < points.size() && !holdsRemovedBodies; i++) {
            pointPool.add((ContactPoint) points.get(i));
        }
        points.clear();
        holdsRemovedBodies = false;
    }

    /** Drops all references to removed bodies. The points stay readable. */
    void releaseRemovedBodies() {
        detachJoints();
        jointPool.clear();
        pointPool.clear();
        holdsRemovedBodies = true;
    }

    /** Detaches the joints from the bodies. The points stay readable. */
    void detachJoints() {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).detach();
            jointPool.add(joints.get(i));
        }
        joints.clear();
    }

    @Override
    public void onContact(Collider first, Collider second, double[] geometry, int count) {
        SparseCollider one = (SparseCollider) first;
        SparseCollider other = (SparseCollider) second;
        int from = points.size();
        for (int i = 0; i < count; i++) {
            ContactPoint point = newPoint();
            point.set(one, other, geometry, i);
            points.add(point);
        }
        if (one.material() != SparseCollider.NO_MATERIAL
                && other.material() != SparseCollider.NO_MATERIAL
                && isWithinLimit(one.contactLimit(), other.contactLimit(), count)) {
            join(one, other, from);
        }
    }

    /**
     * Returns whether a contact is used. Once the total number of points between robots is large, both robots must be
     * below their own limits.
     */
    private boolean isWithinLimit(@Nullable ContactLimit one, @Nullable ContactLimit other, int count) {
        if (one == null || other == null) {
            return true;
        }
        boolean unlimited = pointsBetweenRobots < MAX_UNLIMITED_POINTS;
        if (!unlimited && (!one.hasRoom(step) || !other.hasRoom(step))) {
            return false;
        }
        pointsBetweenRobots += count;
        one.add(step, count);
        other.add(step, count);
        return true;
    }

    private void join(SparseCollider one, SparseCollider other, int from) {
        ContactSurface surface = surfaces.between(one.material(), other.material());
        Body first = one.body();
        Body second = other.body();
        if (first != null) {
            add(newJoint().reset(first, second, surface, 1, one.contactStates()), from);
        } else if (second != null) {
            add(newJoint().reset(second, null, surface, -1, other.contactStates()), from);
        }
    }

    private void add(ContactJoint joint, int from) {
        for (int i = from; i < points.size(); i++) {
            joint.add((ContactPoint) points.get(i));
        }
        joint.attach();
        joints.add(joint);
    }

    private ContactPoint newPoint() {
        return pointPool.isEmpty() ? new ContactPoint() : pointPool.remove(pointPool.size() - 1);
    }

    private ContactJoint newJoint() {
        return jointPool.isEmpty() ? new ContactJoint() : jointPool.remove(jointPool.size() - 1);
    }
}
