package org.robonewbie.protocol.embedded;

import org.robonewbie.protocol.frame.AgentLink;

/**
 * Factory for manually controlled robots. The agent module provides it through {@link java.util.ServiceLoader}, so that
 * the studio does not depend on that module.
 */
public interface PuppetProvider {

    /**
     * Adds a manually controlled robot to the game. Returns immediately; the robot appears once the simulator has
     * admitted it.
     *
     * @param link the robot's connection to the simulator; the returned {@link Puppet} closes it
     * @param team name of the team
     * @param number shirt number; 0 for any free number
     * @param type robot type, 0 to 4
     * @return the puppet
     */
    Puppet start(AgentLink link, String team, int number, int type);
}
