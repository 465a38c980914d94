package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Collision detection: contacts with the ground are computed here, all others by ODE. A broad phase on the bounding boxes of
 * groups skips ODE's detection when nothing overlaps.
 */
final class CollisionDetector {

    private final OdeCollisions collisions = new OdeCollisions();
    private final List<ShapeGroup> groups = new ArrayList<>();
    private final List<CollisionShape> staticShapes = new ArrayList<>();
    private final List<CollisionShape> outdated = new ArrayList<>();
    private final UpdateSequence updates = new UpdateSequence();
    private final double[] points = new double[OdeCollisions.MAX_POINTS * OdeCollisions.DOUBLES_PER_POINT];
    private @Nullable SparseCollider ground;

    OdeCollisions collisions() {
        return collisions;
    }

    UpdateSequence updates() {
        return updates;
    }

    void setGround(SparseCollider collider) {
        ground = collider;
    }

    void add(ShapeGroup group) {
        groups.add(group);
    }

    void remove(ShapeGroup group) {
        groups.remove(group);
    }

    void addStatic(CollisionShape shape) {
        shape.updateBounds();
        shape.updateOdeGeometry();
        staticShapes.add(shape);
    }

    void removeStatic(CollisionShape shape) {
        staticShapes.remove(shape);
    }

    void find(ContactList contacts) {
        for (int i = 0; i < groups.size(); i++) {
            groups.get(i).updateBounds();
        }
        if (hasOverlappingBounds()) {
            updateOdeGeometries();
            collisions.find(contacts);
        }
        if (ground != null) {
            collideWithGround(ground, contacts);
        }
        updates.beginPeriod();
    }

    private boolean hasOverlappingBounds() {
        for (int i = 0; i < groups.size(); i++) {
            ShapeGroup group = groups.get(i);
            for (int j = 0; j < i; j++) {
                if (group.overlaps(groups.get(j))) {
                    return true;
                }
            }
            for (int j = 0; j < staticShapes.size(); j++) {
                if (group.overlaps(staticShapes.get(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    /**
     * Passes the moves since the last search to ODE in their original order, because this order determines the order in
     * which ODE finds pairs.
     */
    private void updateOdeGeometries() {
        for (ShapeGroup group : groups) {
            for (CollisionShape shape : group.shapes()) {
                if (shape.isOdeGeometryOutdated()) {
                    outdated.add(shape);
                }
            }
        }
        outdated.sort(Comparator.comparingInt(CollisionShape::moveNumber));
        outdated.forEach(CollisionShape::updateOdeGeometry);
        outdated.clear();
    }

    private void collideWithGround(SparseCollider plane, ContactList contacts) {
        for (int i = 0; i < groups.size(); i++) {
            List<CollisionShape> shapes = groups.get(i).shapes();
            for (int j = 0; j < shapes.size(); j++) {
                CollisionShape shape = shapes.get(j);
                int count = shape.min[2] <= 0 ? shape.collideWithGround(points) : 0;
                if (count > 0) {
                    contacts.onContact(shape.collider, plane, points, count);
                }
            }
        }
    }
}
