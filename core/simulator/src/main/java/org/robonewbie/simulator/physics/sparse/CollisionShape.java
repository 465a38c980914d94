package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Collision shape with a pose.
 *
 * <p>Contacts with the ground are computed here, because a robot touches the ground in nearly every step. All other pairs
 * use a geometry in ODE's collision space, whose pose is updated only when bounding boxes overlap.
 */
abstract class CollisionShape implements Restorable {

    final SparseCollider collider;
    /** Minimum corner of the bounding box. */
    final double[] min = new double[3];
    /** Maximum corner of the bounding box. */
    final double[] max = new double[3];
    /** Centre; shared with the body, if it is centred on one. */
    final double[] position;
    /** Rotation matrix, row-major; shared with the body, if it is centred on one. */
    final double[] rotation;

    private final OdeCollisions.Geometry odeGeometry;
    private boolean boundsOutdated = true;
    private boolean odeGeometryOutdated = true;
    private int movedInPeriod = -1;
    private int moveNumber;

    CollisionShape(SparseCollider collider, double[] position, double[] rotation, OdeCollisions.Geometry odeGeometry) {
        this.collider = collider;
        this.position = position;
        this.rotation = rotation;
        this.odeGeometry = odeGeometry;
    }

    static CollisionShape of(
            Shape shape,
            SparseCollider collider,
            double[] position,
            double[] rotation,
            OdeCollisions.Geometry odeGeometry) {
        if (shape instanceof Shape.Box box) {
            return new BoxShape(box, collider, position, rotation, odeGeometry);
        }
        if (shape instanceof Shape.Sphere sphere) {
            return new RoundShape(sphere.radius(), 0, collider, position, rotation, odeGeometry);
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        return new RoundShape(capsule.radius(), capsule.length() / 2, collider, position, rotation, odeGeometry);
    }

    void moved(UpdateSequence updates) {
        boundsOutdated = true;
        odeGeometryOutdated = true;
        if (movedInPeriod != updates.period()) {
            movedInPeriod = updates.period();
            moveNumber = updates.nextMoveNumber();
        }
    }

    /**
     * Returns the sequence number of the first move in the period in which the shape last moved (see
     * {@link UpdateSequence}). This number determines the shape's position in ODE's list, which starts with the most
     * recently moved shape.
     */
    int moveNumber() {
        return moveNumber;
    }

    boolean isOdeGeometryOutdated() {
        return odeGeometryOutdated;
    }

    void updateOdeGeometry() {
        odeGeometry.place(position, rotation);
        odeGeometryOutdated = false;
    }

    final void updateBounds() {
        if (boundsOutdated) {
            for (int axis = 0; axis < 3; axis++) {
                double halfExtent = halfExtent(axis);
                min[axis] = position[axis] - halfExtent;
                max[axis] = position[axis] + halfExtent;
            }
            boundsOutdated = false;
        }
    }

    /** Returns half the extent of the bounding box along a world axis. */
    abstract double halfExtent(int axis);

    /**
     * Computes the contact points with the ground plane z = 0.
     *
     * @param points receives {@link OdeCollisions#DOUBLES_PER_POINT} elements per point
     * @return number of points, at most four
     */
    abstract int collideWithGround(double[] points);

    static void setGroundPoint(double[] points, int index, double x, double y, double z, double depth) {
        int at = index * OdeCollisions.DOUBLES_PER_POINT;
        points[at] = x;
        points[at + 1] = y;
        points[at + 2] = z;
        points[at + 3] = 0;
        points[at + 4] = 0;
        points[at + 5] = 1;
        points[at + 6] = depth;
    }

    @Override
    public void save(StateWriter out) {
        out.putBoolean(odeGeometryOutdated);
        out.putInt(movedInPeriod);
        out.putInt(moveNumber);
    }

    /** Restores the state. Restore the body first. A geometry that was up to date is updated immediately. */
    @Override
    public void restore(StateReader in) {
        boundsOutdated = true;
        odeGeometryOutdated = in.getBoolean();
        movedInPeriod = in.getInt();
        moveNumber = in.getInt();
        if (!odeGeometryOutdated) {
            updateOdeGeometry();
        }
    }
}
