package org.robonewbie.exercises.solution;

import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

/** The ball moves to the right by as much as the robot turns to the left. */
public final class UnseenBall extends Agent {

    private static final double CYCLE_SECONDS = 0.02;
    private static final double ENOUGH_DEGREES = 165;

    private double bearing;
    private double turned;
    private boolean known;

    /** Creates the solution. */
    public UnseenBall() {}

    @Override
    protected void think() {
        double step = nao.getGyro().z() * CYCLE_SECONDS;
        bearing -= step;
        if (fieldView.ball().isVisible()) {
            bearing = fieldView.ball().bearing();
            known = true;
        } else if (!known) {
            nao.setJointAngle(Joint.NECK_PITCH, -15, 60);
            return;
        }
        turned += step;
        nao.say(String.format(Locale.ROOT, "ball:%.1f", Math.IEEEremainder(bearing, 360)));
        if (turned < ENOUGH_DEGREES) {
            walk.towards(0, 0, 30);
        } else {
            walk.stop();
        }
    }
}
