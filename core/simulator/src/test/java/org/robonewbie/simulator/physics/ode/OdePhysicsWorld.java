package org.robonewbie.simulator.physics.ode;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.ode4j.ode.DContact;
import org.ode4j.ode.DContactBuffer;
import org.ode4j.ode.DContactJoint;
import org.ode4j.ode.DGeom;
import org.ode4j.ode.DHashSpace;
import org.ode4j.ode.DJointGroup;
import org.ode4j.ode.DSpace;
import org.ode4j.ode.DWorld;
import org.ode4j.ode.OdeHelper;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.simulator.physics.Assembly;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Material;
import org.robonewbie.simulator.physics.PhysicsWorld;

/**
 * The oracle of our own world step: ode4j's world with SimSpark's settings, that is, exact solver, gravity 9.81, soft constraints, sleeping bodies, at most four contacts per
 * pair of colliders.
 *
 * <p>Source: {@code odeworld.cpp}, {@code odespace.cpp} and {@code spark.rb} of SimSpark 0.3.2. Every assembly has its own
 * collision space, as in SimSpark, because that determines the order in which pairs are found.
 */
public final class OdePhysicsWorld implements PhysicsWorld {

    private static final double GRAVITY = -9.81;
    private static final double GLOBAL_CFM = 1e-5;
    private static final double CONTACT_SURFACE_LAYER = 0.001;
    private static final int MAX_CONTACTS_PER_PAIR = 4;

    static {
        OdeHelper.initODE2(0);
    }

    private final DWorld world = OdeHelper.createWorld();
    private final DHashSpace space = OdeHelper.createHashSpace();
    private final Assembly scenery = OdeAssembly.scenery(world, space);
    private final DJointGroup contactJoints = OdeHelper.createJointGroup();
    private final DContactBuffer buffer = new DContactBuffer(MAX_CONTACTS_PER_PAIR);
    private final List<Contact> contacts = new ArrayList<>();
    private double grip = 1;

    /** Creates an empty world. */
    public OdePhysicsWorld() {
        world.setGravity(0, 0, GRAVITY);
        world.setCFM(GLOBAL_CFM);
        world.setContactSurfaceLayer(CONTACT_SURFACE_LAYER);
        world.setAutoDisableFlag(true);
    }

    @Override
    public Assembly addAssembly() {
        return OdeAssembly.within(world, space);
    }

    @Override
    public Assembly scenery() {
        return scenery;
    }

    @Override
    public Collider addGround(Material material, Object owner) {
        return OdeCollider.solid(OdeHelper.createPlane(space, 0, 0, 1, 0), material, owner);
    }

    @Override
    public void findContacts() {
        contactJoints.empty();
        contacts.clear();
        OdeHelper.spaceCollide(space, this, (data, first, second) -> collide(first, second));
    }

    @Override
    public List<Contact> contacts() {
        return Collections.unmodifiableList(contacts);
    }

    @Override
    public void setGrip(double factor) {
        grip = factor;
    }

    /** Uses ODE's exact solver; ode4j advises against it for its cost, but only it holds this robot at 20 ms. */
    @Override
    @SuppressWarnings("deprecation")
    public void step(double seconds) {
        world.step(seconds);
        contactJoints.empty();
    }

    private void collide(DGeom first, DGeom second) {
        if (first instanceof DSpace || second instanceof DSpace) {
            OdeHelper.spaceCollide2(first, second, this, (data, one, two) -> collide(one, two));
            return;
        }
        int count = OdeHelper.collide(first, second, MAX_CONTACTS_PER_PAIR, buffer.getGeomBuffer());
        if (count > 0) {
            addContacts((OdeCollider) first.getData(), (OdeCollider) second.getData(), count);
        }
    }

    private void addContacts(OdeCollider first, OdeCollider second, int count) {
        boolean touching = first.isSolid() && second.isSolid() && (first.hasBody() || second.hasBody());
        Material surface = first.material().mixedWith(second.material());
        for (int i = 0; i < count; i++) {
            OdeContact contact = new OdeContact(first, second, buffer.get(i).geom);
            contacts.add(contact);
            if (touching) {
                join(contact, buffer.get(i), surface);
            }
        }
    }

    private void join(OdeContact contact, DContact details, Material surface) {
        OdeSurface.describe(surface, grip, details.surface);
        DContactJoint joint = OdeHelper.createContactJoint(world, contactJoints, details);
        joint.attach(details.geom.g1.getBody(), details.geom.g2.getBody());
        joint.setFeedback(contact.feedback());
    }

    @Override
    public void save(StateWriter out) {
        throw new UnsupportedOperationException();
    }

    @Override
    public void restore(StateReader in) {
        throw new UnsupportedOperationException();
    }
}
