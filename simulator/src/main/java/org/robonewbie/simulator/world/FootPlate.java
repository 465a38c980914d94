package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.physics.Contact;

/**
 * Adds up the contacts of one foot during a step (SimSpark: {@code forceresistanceperceptor.cpp}).
 *
 * <p>The point is the mean of the contacts' places as they were before the step, each weighted with the strength of its
 * force, in the frame of the foot as it is after the step. While the bodies sleep there are contacts without force; the
 * last reading is repeated then.
 */
final class FootPlate implements Restorable {

    private final int link;
    private final List<Contact> contacts = new ArrayList<>();
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

    void add(Contact contact) {
        contacts.add(contact);
        touching = true;
    }

    void update(BodyPose foot) {
        Vector3 total = Vector3.ZERO;
        Vector3 weighted = Vector3.ZERO;
        double weight = 0;
        for (Contact contact : contacts) {
            Vector3 force = contact.forceOnFirst();
            double strength = force.length();
            total = total.plus(force);
            weighted = weighted.plus(contact.position().times(strength));
            weight += strength;
        }
        if (weight > 0) {
            last = new FootForce(
                    foot.toLocal(weighted.times(1 / weight)), foot.rotation().applyInverse(total));
        }
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
