package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.RigidBody;

/**
 * Force sensor of one foot (SimSpark: {@code forceresistanceperceptor.cpp}).
 *
 * <p>The reading is the total contact force and its centre: the mean of the contact points as detected before the step,
 * weighted by the magnitude of their forces, in the frame of the foot after the step. Contacts between sleeping bodies
 * have no force, so the sensor repeats its last reading.
 */
final class FootPlate implements Restorable {

    private final int link;
    private final List<Contact> contacts = new ArrayList<>();
    private final double[] sums = new double[7];
    private boolean touching;
    private FootForce last = new FootForce(Vector3.ZERO, Vector3.ZERO);

    FootPlate(int link) {
        this.link = link;
    }

    int link() {
        return link;
    }

    void clear() {
        contacts.clear();
        touching = false;
    }

    void addContact(int touchedLink, Contact contact) {
        if (touchedLink == link) {
            contacts.add(contact);
            touching = true;
        }
    }

    void update(RigidBody foot) {
        Arrays.fill(sums, 0);
        for (int i = 0; i < contacts.size(); i++) {
            contacts.get(i).addTo(sums);
        }
        if (sums[6] > 0) {
            double weight = 1 / sums[6];
            Vector3 centre = foot.position();
            last = new FootForce(
                    foot.directionToLocal(
                            weight * sums[3] - centre.x(),
                            weight * sums[4] - centre.y(),
                            weight * sums[5] - centre.z()),
                    foot.directionToLocal(sums[0], sums[1], sums[2]));
        }
    }

    /** Sets the reading that another physics engine has computed. */
    void set(Optional<FootForce> reading) {
        touching = reading.isPresent();
        last = reading.orElse(last);
    }

    Optional<FootForce> reading() {
        return touching ? Optional.of(last) : Optional.empty();
    }

    @Override
    public void save(StateWriter out) {
        out.putBoolean(touching);
        out.putVector(last.point());
        out.putVector(last.force());
    }

    @Override
    public void restore(StateReader in) {
        contacts.clear();
        touching = in.getBoolean();
        last = new FootForce(in.getVector(), in.getVector());
    }
}
