package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/** The contacts of a step: points to be read, and joints between the bodies that they touch. */
final class ContactList implements OdeCollisions.Listener {

    /** Two materials that met. */
    private record Pair(Material first, Material second) {}

    private final Map<Pair, ContactSurface> surfaces = new HashMap<>();
    private final List<Contact> points = new ArrayList<>();
    private final List<Contact> readOnly = Collections.unmodifiableList(points);
    private final List<ContactJoint> joints = new ArrayList<>();

    List<Contact> points() {
        return readOnly;
    }

    /** Forgets the contacts of the last step. */
    void begin() {
        dissolve();
        points.clear();
    }

    /** Takes the joints off the bodies; the points can still be read. */
    void dissolve() {
        for (ContactJoint joint : joints) {
            joint.detach();
        }
        joints.clear();
    }

    @Override
    public void touch(Collider first, Collider second, double[] numbers, int count) {
        SparseCollider one = (SparseCollider) first;
        SparseCollider other = (SparseCollider) second;
        int from = points.size();
        for (int i = 0; i < count; i++) {
            ContactPoint point = new ContactPoint(one, other);
            point.set(one, other, numbers, i);
            points.add(point);
        }
        if (one.material() != null && other.material() != null) {
            join(one, other, surface(one.material(), other.material()), from);
        }
    }

    private void join(SparseCollider one, SparseCollider other, ContactSurface surface, int from) {
        ContactJoint joint;
        if (one.body() != null) {
            joint = new ContactJoint(one.body(), other.body(), surface, 1);
        } else if (other.body() != null) {
            joint = new ContactJoint(other.body(), null, surface, -1);
        } else {
            return;
        }
        for (int i = from; i < points.size(); i++) {
            joint.add((ContactPoint) points.get(i));
        }
        joint.attach();
        joints.add(joint);
    }

    private ContactSurface surface(Material one, Material other) {
        return surfaces.computeIfAbsent(
                new Pair(one, other), pair -> ContactSurface.of(pair.first().mixedWith(pair.second())));
    }
}
