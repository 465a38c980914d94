package org.robonewbie.workshop.motion;

import org.robonewbie.agent.PolicyPlayer;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.policy.file.PolicyFile;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.geometry.Pose2d;

/** Agent that sprints as soon as it is to walk at any velocity, along the line ahead of its pose at that time. */
final class ScriptedSprinter extends ScriptedAgent {

    private final SelfLocalisation self = new SelfLocalisation();
    private final PolicyPlayer sprint = new PolicyPlayer(PolicyFile.shipped("sprint"));
    private boolean sprinting;
    private Pose2d start = Pose2d.ORIGIN;

    ScriptedSprinter() {
        super(WalkStyle.STANDARD);
    }

    @Override
    public void walk(WalkVelocity velocity) {
        if (!sprinting) {
            start = self.pose();
        }
        sprinting = !velocity.isZero();
    }

    @Override
    protected void think() {
        self.update(nao, fieldView);
        if (sprinting) {
            sprint.setCommand("heading", LineKeeping.SPRINT.turn(start, self.pose()));
            sprint.act(nao);
        }
    }
}
