package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;

/** An agent of this process. */
final class AgentPerformer implements Performer {

    private final AgentDriver agent;

    AgentPerformer(Agent agent) {
        this.agent = new AgentDriver(agent);
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        agent.introduce(Options.none().withTeam(team).withNumber(number), side);
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        return agent.respond(readings.message());
    }
}
