package org.robonewbie.workshop.motion;

import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Pose2d;

/**
 * Agent with a learned gait that keeps to the line ahead of its start pose and locates itself with {@link
 * SelfLocalisation}.
 */
final class ScriptedRunner extends ScriptedAgent {

    private final SelfLocalisation self = new SelfLocalisation();
    private final LineKeeping keeping;
    private WalkVelocity wanted = WalkVelocity.ZERO;
    private Pose2d start = Pose2d.ORIGIN;

    ScriptedRunner(PolicyWalk learned, LineKeeping keeping) {
        super(WalkStyle.STANDARD);
        walk.setPolicy(learned);
        this.keeping = keeping;
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
        walk.towards(wanted.forward(), wanted.left(), wanted.isZero() ? 0 : keeping.turn(start, self.pose()));
    }
}
