package org.robonewbie.trial;

import org.robonewbie.agent.Agent;

/** An agent that walks at a constant velocity. */
final class WalkingAgent extends Agent {

    private final double forward;
    private final double left;
    private final double turn;

    WalkingAgent(double forwardMetresPerSecond, double leftMetresPerSecond, double turnDegreesPerSecond) {
        forward = forwardMetresPerSecond;
        left = leftMetresPerSecond;
        turn = turnDegreesPerSecond;
    }

    @Override
    protected void think() {
        walk.towards(forward, left, turn);
    }
}
