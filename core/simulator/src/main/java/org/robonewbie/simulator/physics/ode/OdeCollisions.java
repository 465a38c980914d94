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
 * Collision detection by ode4j, for a world that computes its motion itself.
 *
 * <p>Shapes are kept in nested spaces as in SimSpark, a space for each group, since that determines the order in which pairs are found.
 */
public final class OdeCollisions implements Restorable {

    /** How many numbers describe a point: its place, the normal that looks towards the first shape, and the depth. */
    public static final int NUMBERS_PER_POINT = 7;

    /** How many points of a pair of shapes are found at most. */
    public static final int MAX_POINTS = 4;

    private static final long MOVABLE = 1;
    private static final long FIXED = 2;

    static {
        OdeHelper.initODE2(0);
    }

    private final DHashSpace space = OdeHelper.createHashSpace();
    private final Group scenery = new Group(space);
    private final List<Group> groups = new ArrayList<>();
    private final Place place = new Place();
    private int searches;
    private final DContactBuffer buffer = new DContactBuffer(MAX_POINTS);
    private final DContactGeomBuffer found = buffer.getGeomBuffer();
    private final DGeom.DNearCallback collision = this::collide;
    private final double[] points = new double[MAX_POINTS * NUMBERS_PER_POINT];

    /** Receives every pair of shapes that touch. */
    public interface Listener {

        /**
         * Takes a pair.
         *
         * @param first the one collider
         * @param second the other collider
         * @param points {@link #NUMBERS_PER_POINT} numbers for each point; only valid during the call
         * @param count how many points there are, at most {@link #MAX_POINTS}
         */
        void touch(Collider first, Collider second, double[] points, int count);
    }

    /** A shape that can be put somewhere. */
    public static final class Geometry {

        private final DGeom geometry;
        private final Place place;
        private int firstSearch;

        private Geometry(DGeom geometry, Place place, int firstSearch) {
            this.geometry = geometry;
            this.place = place;
            this.firstSearch = firstSearch;
        }

        /**
         * Moves the shape.
         *
         * @param position its centre, metres
         * @param rotation the nine elements of its rotation matrix in row-major order
         */
        public void place(double[] position, double[] rotation) {
            place.position.set(position[0], position[1], position[2]);
            place.rotation.set(
                    rotation[0],
                    rotation[1],
                    rotation[2],
                    rotation[3],
                    rotation[4],
                    rotation[5],
                    rotation[6],
                    rotation[7],
                    rotation[8]);
            geometry.setPosition(place.position);
            geometry.setRotation(place.rotation);
        }
    }

    /** A place on its way into ODE, which copies it. */
    private static final class Place {

        private final DVector3 position = new DVector3();
        private final DMatrix3 rotation = new DMatrix3();
    }

    /** Shapes that never touch each other, but for those of the scenery. */
    public final class Group {

        private final DHashSpace space;
        private final List<Geometry> shapes = new ArrayList<>();

        private Group(DHashSpace space) {
            this.space = space;
        }

        /**
         * Adds a shape.
         *
         * @param shape what it looks like
         * @param collider what is reported when it touches something
         * @param movable whether it can move; two shapes that cannot are not looked at
         * @return the shape, at the world's origin
         */
        public Geometry add(Shape shape, Collider collider, boolean movable) {
            DGeom geometry = geometry(space, shape);
            geometry.setCategoryBits(movable ? MOVABLE : FIXED);
            geometry.setCollideBits(movable ? MOVABLE | FIXED : MOVABLE);
            geometry.setData(collider);
            Geometry added = new Geometry(geometry, place, searches);
            shapes.add(added);
            return added;
        }

        /** Takes all its shapes out. */
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

    /**
     * Starts a group whose shapes never touch each other.
     *
     * @return the empty group
     */
    public Group addGroup() {
        Group group = new Group(OdeHelper.createHashSpace(space));
        groups.add(group);
        return group;
    }

    /** Creates a geometry of ODE. */
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

    /** {@return the group whose shapes also touch each other} */
    public Group scenery() {
        return scenery;
    }

    /**
     * Finds the pairs that touch.
     *
     * @param listener receives each of them
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
            ((Listener) listener).touch((Collider) first.getData(), (Collider) second.getData(), points, count);
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

    /**
     * Writes the order of ODE's lists, on which the order of pairs hangs, and which shapes no search has seen yet, for those
     * keep their places in the lists when they are moved.
     */
    @Override
    public void save(StateWriter out) {
        scenery.save(out);
        groups.forEach(group -> group.save(out));
        saveOrder(space, members(), out);
    }

    /** Takes on a state after all shapes have been put in their places; their number must be as it was then. */
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

    /** Brings shapes and groups into the order that was saved: whatever moves comes to the front. */
    @SuppressWarnings("deprecation") // there is no other way to look into a group
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
