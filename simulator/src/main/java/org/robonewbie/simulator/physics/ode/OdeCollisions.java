package org.robonewbie.simulator.physics.ode;

import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHashSpace;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.simulator.physics.Collider;

/**
 * The collision half of the engine, for a world that computes its motion itself.
 *
 * <p>Forms are kept in the same nested spaces as in {@link OdePhysicsWorld}, so that pairs are found in the same order.
 */
public final class OdeCollisions {

    /** How many numbers describe a point: its place, the normal that looks towards the first form, and the depth. */
    public static final int NUMBERS_PER_POINT = 7;

    private static final long MOVABLE = 1;
    private static final long FIXED = 2;
    private static final int MAX_CONTACTS_PER_PAIR = 4;

    static {
        OdeHelper.initODE2(0);
    }

    private final DHashSpace space = OdeHelper.createHashSpace();
    private final Group scenery = new Group(space);
    private final DContactBuffer buffer = new DContactBuffer(MAX_CONTACTS_PER_PAIR);
    private final double[] points = new double[MAX_CONTACTS_PER_PAIR * NUMBERS_PER_POINT];

    /** Is told of every pair of forms that touch. */
    public interface Listener {

        /**
         * Takes a pair.
         *
         * @param first the one collider
         * @param second the other collider
         * @param points {@link #NUMBERS_PER_POINT} numbers for each point; only valid during the call
         * @param count how many points there are, at most four
         */
        void touch(Collider first, Collider second, double[] points, int count);
    }

    /** A form that can be put somewhere. */
    public static final class Form {

        private final DGeom geometry;

        private Form(DGeom geometry) {
            this.geometry = geometry;
        }

        /**
         * Puts the form somewhere.
         *
         * @param position its centre, metres
         * @param rotation the nine numbers of its rotation matrix, row by row
         */
        public void place(double[] position, double[] rotation) {
            geometry.setPosition(position[0], position[1], position[2]);
            geometry.setRotation(OdeVectors.rotation(rotation));
        }
    }

    /** Forms that never touch each other, but for those of the scenery. */
    public static final class Group {

        private final DHashSpace space;

        private Group(DHashSpace space) {
            this.space = space;
        }

        /**
         * Adds a form.
         *
         * @param shape what it looks like
         * @param collider what is reported when it touches something
         * @param movable whether it can move; two forms that cannot are not looked at
         * @return the form, at the world's origin
         */
        public Form add(Shape shape, Collider collider, boolean movable) {
            DGeom geometry = OdeAssembly.geometry(space, shape);
            geometry.setCategoryBits(movable ? MOVABLE : FIXED);
            geometry.setCollideBits(movable ? MOVABLE | FIXED : MOVABLE);
            geometry.setData(collider);
            return new Form(geometry);
        }

        /** Takes all its forms out. */
        public void remove() {
            space.destroy();
        }
    }

    /**
     * Starts a group whose forms never touch each other.
     *
     * @return the empty group
     */
    public Group addGroup() {
        return new Group(OdeHelper.createHashSpace(space));
    }

    /**
     * Gives access to the group whose forms touch each other too.
     *
     * @return the scenery
     */
    public Group scenery() {
        return scenery;
    }

    /**
     * Looks for pairs that touch.
     *
     * @param listener is told of each of them
     */
    public void find(Listener listener) {
        OdeHelper.spaceCollide(space, listener, (data, first, second) -> collide(listener, first, second));
    }

    private void collide(Listener listener, DGeom first, DGeom second) {
        if (first instanceof DSpace || second instanceof DSpace) {
            OdeHelper.spaceCollide2(first, second, listener, (data, one, two) -> collide(listener, one, two));
            return;
        }
        int count = OdeHelper.collide(first, second, MAX_CONTACTS_PER_PAIR, buffer.getGeomBuffer());
        if (count > 0) {
            copyPoints(count);
            listener.touch((Collider) first.getData(), (Collider) second.getData(), points, count);
        }
    }

    private void copyPoints(int count) {
        for (int i = 0; i < count; i++) {
            DContactGeom point = buffer.get(i).geom;
            int at = i * NUMBERS_PER_POINT;
            for (int axis = 0; axis < 3; axis++) {
                points[at + axis] = point.pos.get(axis);
                points[at + 3 + axis] = point.normal.get(axis);
            }
            points[at + 6] = point.depth;
        }
    }
}
