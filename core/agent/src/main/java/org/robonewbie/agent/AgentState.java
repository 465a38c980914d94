package org.robonewbie.agent;

import org.robonewbie.nao.state.Restorable;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** State of an agent in a saved world: its own fields, if its class implements {@link Restorable}. */
final class AgentState implements Restorable {

    private final Agent agent;

    AgentState(Agent agent) {
        this.agent = agent;
    }

    @Override
    public void save(StateWriter out) {
        if (agent instanceof Restorable own) {
            own.save(out);
        }
    }

    /** Resets the motions, the walk and the field view, and restores the agent's own fields. */
    @Override
    public void restore(StateReader in) {
        agent.runtime().startOver();
        if (agent instanceof Restorable own) {
            own.restore(in);
        }
    }
}
