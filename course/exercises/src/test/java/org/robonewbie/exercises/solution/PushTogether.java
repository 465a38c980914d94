package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Pose2d;

/** Walk to the box, wait there for each other, and push at the same speed. */
public final class PushTogether extends Agent {

    private static final double BEFORE_THE_BOX = -3.75;
    private static final double APART = 0.45;

    private final SelfLocalisation self = new SelfLocalisation();
    private double side;
    private boolean isThere;
    private boolean isOtherThere;

    /** Creates the solution. */
    public PushTogether() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        self.update(nao, fieldView);
        lookAround.look();
        isOtherThere |=
                nao.getHeard().stream().anyMatch(message -> message.text().equals("ready"));
        if (nao.getTime() < 3 || !self.isKnown()) {
            walk.stop();
            return;
        }
        Pose2d here = self.pose();
        side = side == 0 ? Math.signum(here.y()) : side;
        isThere |= here.x() > BEFORE_THE_BOX;
        if (isThere) {
            nao.say("ready");
        }
        if (isThere && !isOtherThere) {
            walk.stop();
        } else {
            double away = side * APART - here.y();
            walk.towards(0.25, 0.5 * away, -1.5 * here.degrees());
        }
    }
}
