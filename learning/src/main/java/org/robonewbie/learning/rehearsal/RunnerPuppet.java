package org.robonewbie.learning.rehearsal;

import org.robonewbie.agent.localisation.GroundPose;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Vector3;

/**
 * An agent that walks as it has learned and keeps to the line ahead of the place where it began to walk. Where it is it knows from
 * its own messages: {@link SelfLocalisation}.
 */
final class RunnerPuppet extends AgentPuppet {

    private static final double TURN_FOR_A_DEGREE = 1;
    private static final double DEGREES_FOR_A_METRE = 20;
    private static final double MOST_DEGREES = 10;
    private static final double MOST_TURN = 10;

    private final SelfLocalisation self = new SelfLocalisation();
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private GroundPose start = GroundPose.ORIGIN;

    RunnerPuppet(PolicyWalk learned) {
        super(WalkStyle.STANDARD);
        walk.setPolicy(learned);
    }

    @Override
    public void walk(WalkVelocity velocity) {
        if (wanted.isZero()) {
            start = self.pose();
        }
        wanted = velocity;
    }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        walk.towards(wanted.forward(), wanted.left(), wanted.isZero() ? 0 : turn());
    }

    /** Turns towards the line. */
    private double turn() {
        GroundPose now = self.pose();
        double left = start.fromFrame(new Vector3(now.x(), now.y(), 0)).y();
        double heading = start.headingDegrees() - within(MOST_DEGREES, DEGREES_FOR_A_METRE * left);
        return within(MOST_TURN, TURN_FOR_A_DEGREE * Math.IEEEremainder(heading - now.headingDegrees(), 360));
    }

    private static double within(double most, double value) {
        return Math.max(-most, Math.min(most, value));
    }
}
