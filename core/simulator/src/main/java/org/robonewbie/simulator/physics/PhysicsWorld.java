package org.robonewbie.simulator.physics;

import java.util.List;
import org.robonewbie.nao.state.Restorable;

/**
 * Rigid bodies under gravity with motorised hinges and contacts, advanced in fixed steps.
 *
 * <p>One step is {@link #findContacts()} and then {@link #step}; contacts live from the one to the next {@code
 * findContacts()}. Equal calls in equal order give bit-identical results. A world that is dropped needs no closing.
 *
 * <p>Between two steps the state can be saved, and be restored in any world that was built by the same calls. Its contacts
 * are then empty until they are looked for again.
 *
 * <pre>{@code
 * world.findContacts();
 * world.step(0.02);
 * world.contacts().forEach(contact -> System.out.println(contact.forceOnFirst()));
 * }</pre>
 */
public interface PhysicsWorld extends Restorable {

    /**
     * Starts an empty group of parts that never touch each other, such as one robot.
     *
     * @return the new assembly
     */
    Assembly addAssembly();

    /**
     * {@return the assembly for what belongs to no group, such as ball and outer walls: its parts touch each other and
     * everything else; it always exists and cannot be removed}
     */
    Assembly scenery();

    /**
     * Adds the ground: an endless plane at z = 0 that looks up.
     *
     * @param material what its surface is made of
     * @param owner what it belongs to, see {@link Collider#owner()}
     * @return its collider
     */
    Collider addGround(Material material, Object owner);

    /**
     * Changes how well all surfaces hold on to each other.
     *
     * @param factor above 0; 1 is the usual, with 0.5 they slip twice as fast under the same force
     */
    void setGrip(double factor);

    /**
     * Lets others help with the next steps, in an engine that can share its work; results stay the same to the bit.
     *
     * @param crew who does the work
     */
    default void setCrew(Crew crew) {}

    /** Looks where colliders touch and replaces the list of contacts. */
    void findContacts();

    /**
     * {@return the contacts of the present step, at most four per pair of colliders, in the engine's own fixed order;
     * unmodifiable}
     */
    List<Contact> contacts();

    /**
     * Moves all bodies that are awake.
     *
     * @param seconds length of the step
     */
    void step(double seconds);
}
