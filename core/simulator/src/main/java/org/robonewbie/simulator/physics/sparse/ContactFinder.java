package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Looks where shapes touch: the ground by itself, all else with ODE's collision, and that only if the boxes around two
 * groups overlap.
 */
final class ContactFinder {

    private final OdeCollisions collisions = new OdeCollisions();
    private final List<ShapeGroup> movers = new ArrayList<>();
    private final List<CollisionShape> fixtures = new ArrayList<>();
    private final List<CollisionShape> misplaced = new ArrayList<>();
    private final UpdateSequence order = new UpdateSequence();
    private final double[] points = new double[OdeCollisions.MAX_POINTS * OdeCollisions.NUMBERS_PER_POINT];
    private @Nullable SparseCollider ground;

    OdeCollisions collisions() {
        return collisions;
    }

    UpdateSequence order() {
        return order;
    }

    void setGround(SparseCollider collider) {
        ground = collider;
    }

    void add(ShapeGroup group) {
        movers.add(group);
    }

    void remove(ShapeGroup group) {
        movers.remove(group);
    }

    void addFixture(CollisionShape shape) {
        shape.measure();
        shape.placeTwin();
        fixtures.add(shape);
    }

    void removeFixture(CollisionShape shape) {
        fixtures.remove(shape);
    }

    void find(ContactList contacts) {
        for (int i = 0; i < movers.size(); i++) {
            movers.get(i).measure();
        }
        if (isAnythingNear()) {
            placeTwins();
            collisions.find(contacts);
        }
        if (ground != null) {
            findOnGround(ground, contacts);
        }
        order.beginPeriod();
    }

    private boolean isAnythingNear() {
        for (int i = 0; i < movers.size(); i++) {
            ShapeGroup mover = movers.get(i);
            for (int j = 0; j < i; j++) {
                if (mover.isNear(movers.get(j))) {
                    return true;
                }
            }
            for (int j = 0; j < fixtures.size(); j++) {
                if (mover.isNear(fixtures.get(j))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Reports all moves to ODE since the last time, in their order, since ODE's order of pairs comes from it. */
    private void placeTwins() {
        for (ShapeGroup mover : movers) {
            for (CollisionShape shape : mover.shapes()) {
                if (shape.isMisplaced()) {
                    misplaced.add(shape);
                }
            }
        }
        misplaced.sort(Comparator.comparingInt(CollisionShape::moveNumber));
        misplaced.forEach(CollisionShape::placeTwin);
        misplaced.clear();
    }

    private void findOnGround(SparseCollider plane, ContactList contacts) {
        for (int i = 0; i < movers.size(); i++) {
            List<CollisionShape> shapes = movers.get(i).shapes();
            for (int j = 0; j < shapes.size(); j++) {
                CollisionShape shape = shapes.get(j);
                int count = shape.low[2] <= 0 ? shape.touchGround(points) : 0;
                if (count > 0) {
                    contacts.touch(shape.collider, plane, points, count);
                }
            }
        }
    }
}
