package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Controller;

/** An agent as puppet, with all that lies between an agent and its motors. */
class AgentPuppet extends Agent implements Puppet {

    AgentPuppet(WalkStyle style) {
        walk.setStyle(style);
    }

    @Override
    public Controller controller() {
        return Controller.ofAgent(this);
    }

    @Override
    public void play(Motion motion) {
        motions.start(motion);
    }

    @Override
    public void walk(WalkVelocity velocity) {
        walk.towards(velocity.forward(), velocity.left(), velocity.turn());
    }

    @Override
    public boolean isBusy() {
        return walk.isWalking() || !motions.isFinished();
    }
}
