package org.robonewbie.exercises;

import java.util.List;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.Options;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** An agent of this process. */
final class AgentProgram implements Program {

    private final Agent agent;
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    AgentProgram(Agent agent) {
        this.agent = agent;
    }

    @Override
    public void introduce(String team, int number, TeamSide side) {
        agent.introduce(Options.none().withTeam(team).withNumber(number), side);
    }

    @Override
    public List<EffectorCommand> respond(MessageBuffer message) {
        return agent.respond(reader.read(message));
    }
}
