package org.robonewbie.simulator.physics;

import java.util.List;
import org.robonewbie.nao.state.Restorable;

/**
 * Rigid body world with gravity, motorised hinges and contacts, advanced in fixed steps.
 *
 * <p>A step consists of {@link #findContacts()} and {@link #step}. Contacts are valid until the next {@code
 * findContacts()}. The same calls in the same order produce bit-identical results. A world need not be closed.
 *
 * <p>The state can be saved between two steps and restored in any world that was built by the same calls. After a
 * restore, there are no contacts until the next {@code findContacts()}.
 *
 * <pre>{@code
 * world.findContacts();
 * world.step(0.02);
 * world.contacts().forEach(contact -> System.out.println(contact.position()));
 * }</pre>
 */
public interface PhysicsWorld extends Restorable {

    /** {@return a new empty assembly, for example for one robot; its bodies do not collide with each other} */
    Assembly addAssembly();

    /**
     * {@return the permanent assembly for everything else, such as the ball and the outer walls; its bodies collide
     * with each other and with all other bodies}
     */
    Assembly scenery();

    /**
     * Adds the ground, an infinite plane at z = 0.
     *
     * @param material material of the surface
     * @param owner the object that the collider belongs to; see {@link Collider#owner()}
     * @return its collider
     */
    Collider addGround(Material material, Object owner);

    /**
     * Scales the grip of all surfaces.
     *
     * @param factor above 0; 1 is nominal, and at 0.5 surfaces slip twice as fast as at 1 under the same force
     */
    void setGrip(double factor);

    /**
     * Sets the executor for the following steps, if the engine supports parallel steps. Results stay bit-identical.
     *
     * @param crew executor
     */
    default void setCrew(Crew crew) {}

    /** Runs collision detection and replaces the list of contacts. */
    void findContacts();

    /**
     * {@return the contacts of the current step, at most four per pair of colliders, in a deterministic order;
     * unmodifiable}
     */
    List<Contact> contacts();

    /**
     * Advances all bodies that are awake.
     *
     * @param seconds duration of the step
     */
    void step(double seconds);
}
