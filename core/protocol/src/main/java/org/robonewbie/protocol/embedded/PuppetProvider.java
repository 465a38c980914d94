package org.robonewbie.protocol.embedded;

import org.robonewbie.protocol.frame.AgentLink;

/**
 * Creates puppets. The agent module registers one with {@link java.util.ServiceLoader}, so that the studio can offer steering
 * by hand without depending on that module.
 */
public interface PuppetProvider {

    /**
     * Brings a puppet into the game. Returns at once; the robot appears when the simulator has admitted it.
     *
     * @param link the puppet's own connection to the simulator, which it closes
     * @param team name of its team
     * @param number its number; 0 takes any free one
     * @param type its robot type, 0 to 4
     * @return the puppet
     */
    Puppet start(AgentLink link, String team, int number, int type);
}
