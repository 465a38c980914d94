package org.robonewbie.simulator.physics.sparse;

import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * A surface with a shape, somewhere in the world.
 *
 * <p>It finds its contacts with the ground itself, since a robot has some in nearly every step; for all other pairs it has
 * an {@code odeGeometry} in ODE's collision, which is put in place only when something is near.
 */
abstract class CollisionShape implements Restorable {

    final SparseCollider collider;
    /** Corner of the box around the shape with the smallest coordinates. */
    final double[] low = new double[3];
    /** Corner with the largest coordinates. */
    final double[] high = new double[3];
    /** Place of the centre; the very array of the body, if there is one. */
    final double[] position;
    /** The rotation matrix, row by row; the very array of the body, if there is one. */
    final double[] rotation;

    private final OdeCollisions.Geometry odeGeometry;
    private boolean unmeasured = true;
    private boolean misplaced = true;
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

    /** Notes that the body has moved. */
    void moved(UpdateSequence order) {
        unmeasured = true;
        misplaced = true;
        if (movedInPeriod != order.period()) {
            movedInPeriod = order.period();
            moveNumber = order.nextMoveNumber();
        }
    }

    /** When the shape was first moved in the period of its last move; ODE lists the last mover first. */
    int moveNumber() {
        return moveNumber;
    }

    boolean isMisplaced() {
        return misplaced;
    }

    /** Moves the geometry in ODE's collision to the place of the shape. */
    void placeTwin() {
        odeGeometry.place(position, rotation);
        misplaced = false;
    }

    /** Updates the bounding box of the shape. */
    final void measure() {
        if (unmeasured) {
            for (int axis = 0; axis < 3; axis++) {
                double reach = reach(axis);
                low[axis] = position[axis] - reach;
                high[axis] = position[axis] + reach;
            }
            unmeasured = false;
        }
    }

    /** The extent of the shape from its centre along an axis of the world. */
    abstract double reach(int axis);

    /**
     * Finds the points at which the shape touches the ground, the plane z = 0.
     *
     * @param points receives {@link OdeCollisions#NUMBERS_PER_POINT} numbers for each point
     * @return how many there are, at most four
     */
    abstract int touchGround(double[] points);

    static void setGroundPoint(double[] points, int index, double x, double y, double z, double depth) {
        int at = index * OdeCollisions.NUMBERS_PER_POINT;
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
        out.putBoolean(misplaced);
        out.putInt(movedInPeriod);
        out.putInt(moveNumber);
    }

    /** Takes on a state after its body did so. A double that was up to date is put in place at once. */
    @Override
    public void restore(StateReader in) {
        unmeasured = true;
        misplaced = in.getBoolean();
        movedInPeriod = in.getInt();
        moveNumber = in.getInt();
        if (!misplaced) {
            placeTwin();
        }
    }
}
