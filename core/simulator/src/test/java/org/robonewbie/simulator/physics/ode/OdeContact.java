package org.robonewbie.simulator.physics.ode;

import org.ode4j.ode.DContactGeom;
import org.ode4j.ode.DJoint.DJointFeedback;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.physics.Collider;
import org.robonewbie.simulator.physics.Contact;

/** A contact point together with the place where ODE leaves its force. */
final class OdeContact implements Contact {

    private final OdeCollider first;
    private final OdeCollider second;
    private final Vector3 position;
    private final DJointFeedback feedback = new DJointFeedback();

    OdeContact(OdeCollider first, OdeCollider second, DContactGeom geometry) {
        this.first = first;
        this.second = second;
        this.position = OdeVectors.from(geometry.pos);
    }

    DJointFeedback feedback() {
        return feedback;
    }

    @Override
    public Collider first() {
        return first;
    }

    @Override
    public Collider second() {
        return second;
    }

    @Override
    public Vector3 position() {
        return position;
    }

    @Override
    public void addTo(double[] sums) {
        Vector3 force = OdeVectors.from(feedback.f1);
        double magnitude = force.length();
        double[] terms = {
            force.x(),
            force.y(),
            force.z(),
            magnitude * position.x(),
            magnitude * position.y(),
            magnitude * position.z(),
            magnitude
        };
        for (int i = 0; i < terms.length; i++) {
            sums[i] += terms[i];
        }
    }
}
