package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * The contacts of a step: points to be read, and joints between the bodies that they touch.
 *
 * <p>Points and joints are kept and used again, so that contacts cost no memory in the long run.
 */
final class ContactList implements OdeCollisions.Listener {

    private static final int FEW_POINTS_BETWEEN_ROBOTS = 400;

    private final Surfaces surfaces;
    private final List<Contact> points = new ArrayList<>();
    private final List<Contact> readOnly = Collections.unmodifiableList(points);
    private final List<ContactPoint> spentPoints = new ArrayList<>();
    private final List<ContactJoint> joints = new ArrayList<>();
    private final List<ContactJoint> spentJoints = new ArrayList<>();
    private boolean mayPointAtRemoved;
    private long step;
    private int pointsBetweenRobots;

    ContactList(Surfaces surfaces) {
        this.surfaces = surfaces;
    }

    List<Contact> points() {
        return readOnly;
    }

    /** Forgets the contacts of the last step. */
    void begin() {
        step++;
        pointsBetweenRobots = 0;
        dissolve();
        for (int i = 0; i < points.size() && !mayPointAtRemoved; i++) {
            spentPoints.add((ContactPoint) points.get(i));
        }
        points.clear();
        mayPointAtRemoved = false;
    }

    /** Drops all references to bodies that have left the world; the points can still be read. */
    void bodiesLeft() {
        dissolve();
        spentJoints.clear();
        spentPoints.clear();
        mayPointAtRemoved = true;
    }

    /** Takes the joints off the bodies; the points can still be read. */
    void dissolve() {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).detach();
            spentJoints.add(joints.get(i));
        }
        joints.clear();
    }

    @Override
    public void touch(Collider first, Collider second, double[] numbers, int count) {
        SparseCollider one = (SparseCollider) first;
        SparseCollider other = (SparseCollider) second;
        int from = points.size();
        for (int i = 0; i < count; i++) {
            ContactPoint point = newPoint();
            point.set(one, other, numbers, i);
            points.add(point);
        }
        if (one.material() != SparseCollider.NO_MATERIAL
                && other.material() != SparseCollider.NO_MATERIAL
                && mayPush(one.budget(), other.budget(), count)) {
            join(one, other, from);
        }
    }

    /** Where there are many contacts, two robots need room in both their crowds. */
    private boolean mayPush(@Nullable ContactLimit one, @Nullable ContactLimit other, int count) {
        if (one == null || other == null) {
            return true;
        }
        boolean areFew = pointsBetweenRobots < FEW_POINTS_BETWEEN_ROBOTS;
        if (!areFew && (!one.hasRoom(step) || !other.hasRoom(step))) {
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
            add(newJoint().between(first, second, surface, 1, one.lastTouch()), from);
        } else if (second != null) {
            add(newJoint().between(second, null, surface, -1, other.lastTouch()), from);
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
        return spentPoints.isEmpty() ? new ContactPoint() : spentPoints.remove(spentPoints.size() - 1);
    }

    private ContactJoint newJoint() {
        return spentJoints.isEmpty() ? new ContactJoint() : spentJoints.remove(spentJoints.size() - 1);
    }
}
