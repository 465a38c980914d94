package org.robonewbie.trial;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.AgentDriver;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.protocol.effector.EffectorCommand;

/** A controller that runs an in-process agent. */
final class AgentController implements Controller {

    private final AgentDriver agent;
    private RobotType type = RobotType.TYPE_0;

    AgentController(Agent agent) {
        this.agent = new AgentDriver(agent);
    }

    @Override
    public void embody(RobotType newType) {
        type = newType;
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        Options identity = Options.none().withTeam(team).withNumber(number);
        agent.introduce(identity.with("type", Integer.toString(type.ordinal())), side);
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        return agent.respond(readings.message());
    }
}
