package org.robonewbie.simulator.physics.sparse;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.function.IntConsumer;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Crew;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.PhysicsWorld;
import org.robonewbie.simulator.physics.ode.OdeCollisions;

/**
 * Physics world with a sparse LCP solver and ODE's collision detection.
 *
 * <p>Settings are SimSpark's. Islands are built and shapes are moved in the same order as in SimSpark, because this
 * determines the order of contacts.
 */
public final class SparsePhysicsWorld implements PhysicsWorld {

    /** One solver per thread, so that hundreds of worlds share its arrays and factorizations in the processor's cache. */
    private static final ThreadLocal<IslandSolver> SOLVER = ThreadLocal.withInitial(IslandSolver::new);

    private final Surfaces surfaces = new Surfaces();
    private final CollisionDetector detector = new CollisionDetector();
    private final List<SparseAssembly> assemblies = new ArrayList<>();
    private final Assembly scenery = add(detector.collisions().scenery(), false);
    private final List<Body> bodies = new ArrayList<>();
    private final ContactList contacts = new ContactList(surfaces);
    private final List<Island> islands = new ArrayList<>();
    private final IntConsumer islandTask = this::solveIsland;
    private Crew crew = Crew.ALONE;
    private double stepSeconds;

    /** Creates an empty world. */
    public SparsePhysicsWorld() {}

    Surfaces surfaces() {
        return surfaces;
    }

    CollisionDetector detector() {
        return detector;
    }

    void add(Body body) {
        bodies.add(body);
    }

    void remove(SparseAssembly assembly, Collection<Body> removed) {
        contacts.releaseRemovedBodies();
        islands.forEach(Island::clear);
        bodies.removeAll(removed);
        assemblies.remove(assembly);
    }

    @Override
    public Assembly addAssembly() {
        return add(detector.collisions().addGroup(), true);
    }

    private SparseAssembly add(OdeCollisions.Group geometries, boolean removable) {
        SparseAssembly assembly = new SparseAssembly(this, geometries, removable);
        assemblies.add(assembly);
        return assembly;
    }

    @Override
    public Assembly scenery() {
        return scenery;
    }

    @Override
    public Collider addGround(Material material, Object owner) {
        SparseCollider ground = new SparseCollider(null, surfaces.indexOf(material), owner, null);
        detector.setGround(ground);
        return ground;
    }

    @Override
    public void setGrip(double factor) {
        surfaces.setGrip(factor);
    }

    @Override
    public void setCrew(Crew newCrew) {
        crew = newCrew;
    }

    @Override
    public void findContacts() {
        contacts.begin();
        detector.find(contacts);
    }

    @Override
    public List<Contact> contacts() {
        return contacts.points();
    }

    @Override
    public void step(double seconds) {
        stepSeconds = seconds;
        int count = collectIslands();
        crew.divide(count, islandTask);
        for (int i = 0; i < count; i++) {
            islands.get(i).integrate(seconds);
        }
        contacts.detachJoints();
    }

    private int collectIslands() {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).updateSleep();
            bodies.get(i).unvisit();
        }
        int count = 0;
        for (int i = bodies.size() - 1; i >= 0; i--) {
            Body body = bodies.get(i);
            if (!body.visited && !body.isAsleep()) {
                if (count == islands.size()) {
                    islands.add(new Island());
                }
                islands.get(count++).collect(body);
            }
        }
        return count;
    }

    /** Solves one island. Islands do not depend on each other, so they can be solved in parallel. */
    private void solveIsland(int island) {
        SOLVER.get().solve(islands.get(island), stepSeconds);
    }

    @Override
    public void save(StateWriter out) {
        detector.updates().save(out);
        assemblies.forEach(assembly -> assembly.save(out));
        detector.collisions().save(out);
    }

    /** Restores the state. Cached factorizations and arrays are not part of it, because results do not depend on them. */
    @Override
    public void restore(StateReader in) {
        contacts.begin();
        detector.updates().restore(in);
        assemblies.forEach(assembly -> assembly.restore(in));
        detector.collisions().restore(in);
    }
}
