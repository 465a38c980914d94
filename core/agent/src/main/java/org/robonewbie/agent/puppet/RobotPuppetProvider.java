package org.robonewbie.agent.puppet;

import org.robonewbie.protocol.embedded.Puppet;
import org.robonewbie.protocol.embedded.PuppetProvider;
import org.robonewbie.protocol.frame.AgentLink;

/**
 * Provider of manually controlled robots that use this framework's walk and motions; found by {@link
 * java.util.ServiceLoader}.
 */
public final class RobotPuppetProvider implements PuppetProvider {

    /** Creates the provider. */
    public RobotPuppetProvider() {}

    @Override
    public Puppet start(AgentLink link, String team, int number, int type) {
        return RobotPuppet.start(link, SteeredRobot.options(team, number, type));
    }
}
