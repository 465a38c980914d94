package org.robonewbie.studio;

import java.util.function.Consumer;
import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.order.PlayerNumber;

/**
 * Command for a puppet, which is a robot that the user controls manually.
 *
 * @param player the robot
 * @param action the command
 */
record PuppetOrder(PlayerNumber player, Consumer<Puppet> action) implements StudioRequest {
    @Override
    public void applyTo(StudioContext context) {
        action.accept(context.puppets().puppet(player));
    }
}
