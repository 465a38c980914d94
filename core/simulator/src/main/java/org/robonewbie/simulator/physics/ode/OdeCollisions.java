package org.robonewbie.simulator.physics.ode;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.ode4j.math.DMatrix3;
import org.ode4j.math.DVector3;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DContactGeomBuffer;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHashSpace;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.nao.model.Shape;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Collider;

/**
 * Collision detection by ode4j for a world that computes the dynamics itself.
 *
 * <p>As in SimSpark, each group of shapes has its own nested space, because the nesting determines the order in which
 * pairs are found.
 */
public final class OdeCollisions implements Restorable {

    /** Number of elements per contact point: position, normal towards the first shape, and depth. */
    public static final int DOUBLES_PER_POINT = 7;

    /** Maximum number of contact points per pair of shapes. */
    public static final int MAX_POINTS = 4;

    private static final long MOVABLE = 1;
    private static final long FIXED = 2;

    static {
        OdeHelper.initODE2(0);
    }

    private final DHashSpace space = OdeHelper.createHashSpace();
    private final Group scenery = new Group(space);
    private final List<Group> groups = new ArrayList<>();
    private final DVector3 position = new DVector3();
    private final DMatrix3 rotation = new DMatrix3();
    private int searches;
    private final DContactBuffer buffer = new DContactBuffer(MAX_POINTS);
    private final DContactGeomBuffer found = buffer.getGeomBuffer();
    private final DGeom.DNearCallback collision = this::collide;
    private final double[] points = new double[MAX_POINTS * DOUBLES_PER_POINT];

    /** Listener for pairs of touching shapes. */
    public interface Listener {

        /**
         * Called for each pair.
         *
         * @param first the first collider
         * @param second the second collider
         * @param points {@link #DOUBLES_PER_POINT} elements per point; valid only during the call
         * @param count number of points, at most {@link #MAX_POINTS}
         */
        void onContact(Collider first, Collider second, double[] points, int count);
    }

    /** Collision shape with a pose. */
    public final class Geometry {

        private final DGeom geometry;
        private int firstSearch = searches;

        private Geometry(DGeom geometry) {
            this.geometry = geometry;
        }

        /**
         * Sets the pose of the shape.
         *
         * @param centre position of the centre in metres
         * @param r rotation matrix, nine elements in row-major order
         */
        public void place(double[] centre, double[] r) {
            position.set(centre[0], centre[1], centre[2]);
            rotation.set(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
            geometry.setPosition(position);
            geometry.setRotation(rotation);
        }
    }

    /** Group of shapes that do not collide with each other, except in the scenery. */
    public final class Group {

        private final DHashSpace space;
        private final List<Geometry> shapes = new ArrayList<>();

        private Group(DHashSpace space) {
            this.space = space;
        }

        /**
         * Adds a shape.
         *
         * @param shape its shape
         * @param collider the collider to report on contact
         * @param movable whether the shape can move; pairs of static shapes are ignored
         * @return the new geometry at the origin
         */
        public Geometry add(Shape shape, Collider collider, boolean movable) {
            DGeom geometry = geometry(space, shape);
            geometry.setCategoryBits(movable ? MOVABLE : FIXED);
            geometry.setCollideBits(movable ? MOVABLE | FIXED : MOVABLE);
            geometry.setData(collider);
            Geometry added = new Geometry(geometry);
            shapes.add(added);
            return added;
        }

        /** Removes the group and its shapes. */
        public void remove() {
            groups.remove(this);
            space.destroy();
        }

        private List<DGeom> geometries() {
            return shapes.stream().map(shape -> shape.geometry).toList();
        }

        private void save(StateWriter out) {
            shapes.forEach(shape -> out.putBoolean(shape.firstSearch == searches));
            if (this != scenery) {
                saveOrder(space, geometries(), out);
            }
        }

        private void restore(StateReader in) {
            shapes.forEach(shape -> shape.firstSearch = in.getBoolean() ? searches : searches - 1);
            if (this != scenery) {
                arrange(geometries(), in);
            }
        }

        private void markUnseen() {
            inReverse(space).forEach(this::markUnseen);
        }

        private void markUnseen(DGeom geometry) {
            for (Geometry shape : shapes) {
                if (shape.geometry == geometry && shape.firstSearch == searches) {
                    move(geometry);
                }
            }
        }
    }

    /** {@return a new empty group whose shapes do not collide with each other} */
    public Group addGroup() {
        Group group = new Group(OdeHelper.createHashSpace(space));
        groups.add(group);
        return group;
    }

    static DGeom geometry(DHashSpace space, Shape shape) {
        if (shape instanceof Shape.Box box) {
            return OdeHelper.createBox(
                    space, box.size().x(), box.size().y(), box.size().z());
        }
        if (shape instanceof Shape.Sphere sphere) {
            return OdeHelper.createSphere(space, sphere.radius());
        }
        Shape.Capsule capsule = (Shape.Capsule) shape;
        return OdeHelper.createCapsule(space, capsule.radius(), capsule.length());
    }

    /** {@return the group whose shapes also collide with each other} */
    public Group scenery() {
        return scenery;
    }

    /**
     * Finds all pairs of touching shapes.
     *
     * @param listener receives each pair
     */
    public void find(Listener listener) {
        searches++;
        OdeHelper.spaceCollide(space, listener, collision);
    }

    private void collide(Object listener, DGeom first, DGeom second) {
        if (first instanceof DSpace || second instanceof DSpace) {
            OdeHelper.spaceCollide2(first, second, listener, collision);
            return;
        }
        int count = OdeHelper.collide(first, second, MAX_POINTS, found);
        if (count > 0) {
            copyPoints(count);
            ((Listener) listener).onContact((Collider) first.getData(), (Collider) second.getData(), points, count);
        }
    }

    private void copyPoints(int count) {
        for (int i = 0; i < count; i++) {
            DContactGeom point = buffer.get(i).geom;
            int at = i * DOUBLES_PER_POINT;
            for (int axis = 0; axis < 3; axis++) {
                points[at + axis] = point.pos.get(axis);
                points[at + 3 + axis] = point.normal.get(axis);
            }
            points[at + 6] = point.depth;
        }
    }

    /**
     * Saves the order of shapes in ODE's lists, which determines the order of pairs. Also saves which shapes have not yet
     * taken part in a search, because moving such a shape does not change its position in the lists.
     */
    @Override
    public void save(StateWriter out) {
        scenery.save(out);
        groups.forEach(group -> group.save(out));
        saveOrder(space, members(), out);
    }

    /** Restores the state. Call after all shapes are positioned; the shape count must match. */
    @Override
    public void restore(StateReader in) {
        space.cleanGeoms();
        scenery.restore(in);
        groups.forEach(group -> group.restore(in));
        arrange(members(), in);
        for (DGeom member : inReverse(space)) {
            groups.stream().filter(group -> group.space == member).forEach(Group::markUnseen);
            scenery.markUnseen(member);
        }
    }

    private List<DGeom> members() {
        List<DGeom> members = new ArrayList<>(scenery.geometries());
        groups.forEach(group -> members.add(group.space));
        return members;
    }

    private static void saveOrder(DSpace list, List<DGeom> members, StateWriter out) {
        for (DGeom member : list.getGeoms()) {
            out.putInt(members.indexOf(member));
        }
    }

    /** Restores the saved order of shapes and groups. Moving a geometry moves it to the front of its list. */
    @SuppressWarnings("deprecation") // the only way to access the members of a group
    private void arrange(List<DGeom> members, StateReader in) {
        DGeom[] order = new DGeom[members.size()];
        Arrays.setAll(order, i -> members.get(in.getIndex(order.length)));
        for (int i = order.length - 1; i >= 0; i--) {
            move(order[i] instanceof DSpace group ? group.getGeoms().iterator().next() : order[i]);
        }
        space.cleanGeoms();
    }

    private static void move(DGeom geometry) {
        geometry.setPosition(geometry.getPosition());
    }

    private static List<DGeom> inReverse(DSpace list) {
        List<DGeom> members = new ArrayList<>(list.getNumGeoms());
        list.getGeoms().forEach(members::add);
        Collections.reverse(members);
        return members;
    }
}
