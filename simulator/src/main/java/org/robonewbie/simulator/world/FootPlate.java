package org.robonewbie.simulator.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Pose;

/** Collects the contacts of one foot during a step and remembers the last force that was felt. */
final class FootPlate {

    private final List<Contact> contacts = new ArrayList<>();
    private FootForce last = FootForce.NOTHING;
    private boolean touching;

    void clear() {
        contacts.clear();
    }

    void add(Contact contact) {
        contacts.add(contact);
    }

    /** While the bodies sleep there are contacts without force; the last reading is repeated then. */
    void update(Pose link) {
        touching = !contacts.isEmpty();
        FootForce now = FootForce.of(contacts, link);
        if (!now.force().equals(Vector3.ZERO)) {
            last = now;
        }
    }

    Optional<FootForce> reading() {
        return touching ? Optional.of(last) : Optional.empty();
    }
}
