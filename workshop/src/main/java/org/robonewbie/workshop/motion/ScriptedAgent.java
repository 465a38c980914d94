package org.robonewbie.workshop.motion;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.ScriptedRobot;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.trial.Controller;

/** Scripted robot that is controlled through a complete agent. */
class ScriptedAgent extends Agent implements ScriptedRobot {

    ScriptedAgent(WalkStyle style) {
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
