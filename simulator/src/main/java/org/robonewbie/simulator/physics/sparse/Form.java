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
 * a double in ODE's collision, which is put in place only when something is near.
 */
abstract class Form implements Restorable {

    final SparseCollider collider;
    /** Corner of the box around the form with the smallest coordinates. */
    final double[] low = new double[3];
    /** Corner with the largest coordinates. */
    final double[] high = new double[3];
    /** Place of the centre; the very array of the body, if there is one. */
    final double[] position;
    /** The rotation matrix, row by row; the very array of the body, if there is one. */
    final double[] rotation;

    private final OdeCollisions.Form twin;
    private boolean unmeasured = true;
    private boolean misplaced = true;
    private int movedInPeriod = -1;
    private int turn;

    Form(SparseCollider collider, double[] position, double[] rotation, OdeCollisions.Form twin) {
        this.collider = collider;
        this.position = position;
        this.rotation = rotation;
        this.twin = twin;
    }

    static Form of(
            Shape shape, SparseCollider collider, double[] position, double[] rotation, OdeCollisions.Form twin) {
        if (shape instanceof Shape.Box box) {
            return new BoxForm(box, collider, position, rotation, twin);
        }
        if (shape instanceof Shape.Sphere sphere) {
            return new RoundForm(sphere.radius(), 0, collider, position, rotation, twin);
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        return new RoundForm(capsule.radius(), capsule.length() / 2, collider, position, rotation, twin);
    }

    /** Notes that the body has moved. */
    void moved(MoveClock clock) {
        unmeasured = true;
        misplaced = true;
        if (movedInPeriod != clock.period()) {
            movedInPeriod = clock.period();
            turn = clock.nextTurn();
        }
    }

    /** When the form was first moved in the period of its last move; ODE lists the last mover first. */
    int turn() {
        return turn;
    }

    boolean isMisplaced() {
        return misplaced;
    }

    /** Puts the double in ODE's collision where the form is. */
    void placeTwin() {
        twin.place(position, rotation);
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
     * Finds the points at which the form touches the ground, the plane z = 0.
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
        out.putInt(turn);
    }

    /** Takes on a state after its body did so. A double that was up to date is put in place at once. */
    @Override
    public void restore(StateReader in) {
        unmeasured = true;
        misplaced = in.getBoolean();
        movedInPeriod = in.getInt();
        turn = in.getInt();
        if (!misplaced) {
            placeTwin();
        }
    }
}
