package org.robonewbie.studio;

import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.order.PlayerNumber;

/** What a page wants from a robot that people steer by hand. */
sealed interface PuppetOrder {

    /**
     * Does what is wanted.
     *
     * @param puppet the robot
     */
    void applyTo(Puppet puppet);

    /**
     * Walks; all parts are from -1 to 1.
     *
     * @param forward negative is backward
     * @param left negative is to the right
     * @param turn negative is to the right
     */
    record Walk(double forward, double left, double turn) implements PuppetOrder {
        @Override
        public void applyTo(Puppet puppet) {
            puppet.walk(forward, left, turn);
        }
    }

    /**
     * Performs a motion.
     *
     * @param motion its name
     */
    record Perform(String motion) implements PuppetOrder {
        @Override
        public void applyTo(Puppet puppet) {
            puppet.perform(motion);
        }
    }

    /**
     * Turns the head.
     *
     * @param yawDegrees to the left
     * @param pitchDegrees up
     */
    record Look(double yawDegrees, double pitchDegrees) implements PuppetOrder {
        @Override
        public void applyTo(Puppet puppet) {
            puppet.look(yawDegrees, pitchDegrees);
        }
    }

    /**
     * Moves a joint.
     *
     * @param joint the joint
     * @param degrees its angle
     */
    record Hold(Joint joint, double degrees) implements PuppetOrder {
        @Override
        public void applyTo(Puppet puppet) {
            puppet.hold(joint, degrees);
        }
    }

    /**
     * An order for a certain robot.
     *
     * @param player the robot
     * @param order what it is to do
     */
    record To(PlayerNumber player, PuppetOrder order) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            order.applyTo(context.puppets().puppet(player));
        }
    }
}
