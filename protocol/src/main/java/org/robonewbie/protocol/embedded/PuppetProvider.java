package org.robonewbie.protocol.embedded;

import org.robonewbie.protocol.frame.AgentLink;

/**
 * Makes puppets. The agent module offers one by {@link java.util.ServiceLoader}, so that whoever shows a simulation can let people
 * steer a robot without a dependency on it.
 */
public interface PuppetProvider {

    /**
     * Brings a puppet into the game. It returns at once; the robot appears when the simulator has let it in.
     *
     * @param link the puppet's own connection to the simulator, which it closes
     * @param team name of its team
     * @param number its number; 0 takes any that is free
     * @param type its build, 0 to 4
     * @return the puppet
     */
    Puppet start(AgentLink link, String team, int number, int type);
}
