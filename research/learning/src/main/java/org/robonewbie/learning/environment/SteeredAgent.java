package org.robonewbie.learning.environment;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkVelocity;

/** An agent that walks with the learned walk at the velocity that it is told, and gets up whenever it has fallen. */
final class SteeredAgent extends Agent {

    private static final PolicyWalk LEARNED = new PolicyWalk(PolicyFile.shipped("walk"));

    private WalkVelocity velocity = WalkVelocity.ZERO;

    void steer(WalkVelocity wanted) {
        velocity = wanted;
    }

    @Override
    protected void think() {
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (motions.isFinished()) {
            walk.setPolicy(LEARNED);
            walk.towards(velocity.forward(), velocity.left(), velocity.turn());
        }
    }
}
