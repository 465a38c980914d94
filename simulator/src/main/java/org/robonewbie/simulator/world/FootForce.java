package org.robonewbie.simulator.world;

import java.util.List;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Contact;
import org.robonewbie.simulator.physics.Pose;

/**
 * What a plate under a foot feels, in the frame of its link: x right, y forward, z up.
 *
 * @param point centre of pressure relative to the link's centre, metres
 * @param force sum of all contact forces on the link, newtons
 */
public record FootForce(Vector3 point, Vector3 force) {

    /** What a plate reports that has touched something but never felt a force. */
    static final FootForce NOTHING = new FootForce(Vector3.ZERO, Vector3.ZERO);

    /**
     * Adds up contacts: the point is the mean of their places, each weighted with the strength of its force (SimSpark:
     * {@code forceresistanceperceptor.cpp}).
     *
     * @param contacts contacts with the link on the first side, after the step
     * @param link the link's pose after the step
     * @return the sum; its force is zero when all bodies sleep
     */
    static FootForce of(List<Contact> contacts, Pose link) {
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
        if (weight == 0) {
            return NOTHING;
        }
        return new FootForce(
                link.toLocal(weighted.times(1 / weight)), link.rotation().applyInverse(total));
    }
}
