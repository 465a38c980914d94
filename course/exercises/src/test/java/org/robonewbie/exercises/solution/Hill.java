package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.Vector3;

/** To the foot of the hill, then straight up, and stop in the middle of the top. */
public final class Hill extends Agent {

    private static final Vector3 FOOT = new Vector3(-4.45, 0, 0);
    private static final Vector3 FAR = new Vector3(0, 0, 0);
    private static final double STOP_X = -2.75;

    private final SelfLocalisation self = new SelfLocalisation();
    private boolean climbing;

    /** Creates the solution. */
    public Hill() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        self.update(nao, fieldView);
        lookAround.look();
        if (nao.getTime() < 3 || !self.isKnown() || self.pose().x() > STOP_X) {
            walk.stop();
            return;
        }
        Vector3 foot = self.pose().fromFrame(FOOT);
        climbing |= Math.hypot(foot.x(), foot.y()) < 0.15;
        Vector3 goal = climbing ? self.pose().fromFrame(FAR) : foot;
        double bearing = Math.toDegrees(Math.atan2(goal.y(), goal.x()));
        walk.towards(Math.abs(bearing) < 20 ? 0.2 : 0, 0, bearing);
    }
}
