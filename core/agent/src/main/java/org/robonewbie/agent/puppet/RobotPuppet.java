package org.robonewbie.agent.puppet;

import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Nao;
import org.robonewbie.agent.Options;
import org.robonewbie.agent.StartUpException;
import org.robonewbie.protocol.frame.AgentLink;

/** A manually controlled robot that runs its cycle in its own thread. */
final class RobotPuppet extends SteeredRobot {

    private final AgentLink link;
    private final Options options;

    private RobotPuppet(AgentLink link, Options options) {
        this.link = link;
        this.options = options;
    }

    static RobotPuppet start(AgentLink link, Options options) {
        RobotPuppet puppet = new RobotPuppet(link, options);
        Thread thread = new Thread(puppet::run, "puppet");
        thread.setDaemon(true);
        thread.start();
        return puppet;
    }

    private void run() {
        try (Nao nao = AgentDriver.connect(link, options)) {
            begin(nao);
            while (nao.sense()) {
                move(nao);
                nao.act();
            }
        } catch (StartUpException refused) {
            link.close();
        }
    }

    @Override
    public void close() {
        link.close();
    }
}
