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
 * A world that steps with our own solver and finds contacts with ODE's collision detection.
 *
 * <p>Its settings are those of SimSpark, and so is the order in which islands are gathered and shapes are moved, since the
 * order of contacts depends on it.
 */
public final class SparsePhysicsWorld implements PhysicsWorld {

    /**
     * Factorizations and arrays, which all islands share that a thread works on: hundreds of worlds of learning robots would drive
     * each other's out of the processor's cache.
     */
    private static final ThreadLocal<IslandSolver> SOLVER = ThreadLocal.withInitial(IslandSolver::new);

    private final Surfaces surfaces = new Surfaces();
    private final ContactFinder finder = new ContactFinder();
    private final List<SparseAssembly> assemblies = new ArrayList<>();
    private final Assembly scenery = add(finder.collisions().scenery(), false);
    private final List<Body> bodies = new ArrayList<>();
    private final ContactList contacts = new ContactList(surfaces);
    private final List<Island> islands = new ArrayList<>();
    private final IntConsumer forces = this::findForces;
    private Crew crew = Crew.ALONE;
    private double stepSeconds;

    /** Creates an empty world. */
    public SparsePhysicsWorld() {}

    Surfaces surfaces() {
        return surfaces;
    }

    ContactFinder finder() {
        return finder;
    }

    void add(Body body) {
        bodies.add(body);
    }

    void remove(SparseAssembly assembly, Collection<Body> removed) {
        contacts.bodiesLeft();
        islands.forEach(Island::clear);
        bodies.removeAll(removed);
        assemblies.remove(assembly);
    }

    @Override
    public Assembly addAssembly() {
        return add(finder.collisions().addGroup(), true);
    }

    private SparseAssembly add(OdeCollisions.Group twins, boolean removable) {
        SparseAssembly assembly = new SparseAssembly(this, twins, removable);
        assemblies.add(assembly);
        return assembly;
    }

    @Override
    public Assembly scenery() {
        return scenery;
    }

    @Override
    public Collider addGround(Material material, Object owner) {
        SparseCollider ground = new SparseCollider(null, surfaces.numberOf(material), owner, null);
        finder.setGround(ground);
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
        finder.find(contacts);
    }

    @Override
    public List<Contact> contacts() {
        return contacts.points();
    }

    @Override
    public void step(double seconds) {
        stepSeconds = seconds;
        int count = gatherIslands();
        crew.divide(count, forces);
        for (int i = 0; i < count; i++) {
            islands.get(i).move(seconds);
        }
        contacts.dissolve();
    }

    private int gatherIslands() {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).watchRest();
            bodies.get(i).unvisit();
        }
        int count = 0;
        for (int i = bodies.size() - 1; i >= 0; i--) {
            Body body = bodies.get(i);
            if (!body.visited && !body.isAsleep()) {
                if (count == islands.size()) {
                    islands.add(new Island());
                }
                islands.get(count++).gather(body);
            }
        }
        return count;
    }

    /** What happens on one island matters to no other. */
    private void findForces(int island) {
        SOLVER.get().solve(islands.get(island), stepSeconds);
    }

    @Override
    public void save(StateWriter out) {
        finder.order().save(out);
        assemblies.forEach(assembly -> assembly.save(out));
        finder.collisions().save(out);
    }

    /** Takes on a state; factorizations and arrays stay, since what they are reused for does not depend on them. */
    @Override
    public void restore(StateReader in) {
        contacts.begin();
        finder.order().restore(in);
        assemblies.forEach(assembly -> assembly.restore(in));
        finder.collisions().restore(in);
    }
}
