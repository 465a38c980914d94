package org.robonewbie.studio;

import org.robonewbie.nao.Joint;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.order.PlayerNumber;

/** Command for a puppet, a robot that the user steers by hand. */
sealed interface PuppetOrder {

    /**
     * Applies the command.
     *
     * @param puppet the robot
     */
    void applyTo(Puppet puppet);

    /**
     * Walks with the given velocity; all components range from -1 to 1.
     *
     * @param forward negative for backward
     * @param left negative for right
     * @param turn negative for clockwise
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
     * @param yawDegrees angle in degrees, positive to the left
     * @param pitchDegrees angle in degrees, positive upward
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
     * @param degrees target angle in degrees
     */
    record Hold(Joint joint, double degrees) implements PuppetOrder {
        @Override
        public void applyTo(Puppet puppet) {
            puppet.hold(joint, degrees);
        }
    }

    /**
     * Command addressed to one robot.
     *
     * @param player the robot
     * @param order the command
     */
    record To(PlayerNumber player, PuppetOrder order) implements StudioRequest {
        @Override
        public void applyTo(StudioContext context) {
            order.applyTo(context.puppets().puppet(player));
        }
    }
}
