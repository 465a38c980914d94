package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.walk.WalkParameter;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;

/** Quicker steps, and numbers of the walk that a random search of four minutes has found. */
public final class FasterWalk extends Agent {

    private static final int STEP_MILLIS = 180;
    private static final double MAX_FORWARD = 0.74;

    private double headingDegrees;

    /** Creates the solution. */
    public FasterWalk() {
        double[] x = WalkStyle.coordinates();
        x[WalkParameter.TORSO_HEIGHT.ordinal()] += 0.34;
        x[WalkParameter.LEAN.ordinal()] += 0.23;
        x[WalkParameter.ANKLE_OFFSET.ordinal()] += 0.49;
        x[WalkParameter.SWAY_AMPLITUDE.ordinal()] -= 0.27;
        x[WalkParameter.SWAY_PHASE.ordinal()] += 0.27;
        x[WalkParameter.ROLL.ordinal()] += 0.69;
        x[WalkParameter.SWING_HIP.ordinal()] -= 0.74;
        x[WalkParameter.BOUNCE_AMPLITUDE.ordinal()] += 0.48;
        x[WalkParameter.ANKLE_PITCH_RATE.ordinal()] += 0.33;
        x[WalkParameter.STEP_FORWARD_RATE.ordinal()] += 0.34;
        x[WalkParameter.STEP_RIGHT.ordinal()] -= 0.47;
        x[WalkParameter.STEP_RIGHT_RATE.ordinal()] += 0.34;
        walk.setStyle(WalkStyle.of(
                STEP_MILLIS, new WalkVelocity(1.104, 1.25, 1.2), new WalkVelocity(MAX_FORWARD, 0.22, 70), x));
    }

    @Override
    protected void think() {
        headingDegrees += nao.getGyro().z() * 0.02; // what the feet turn by mistake
        walk.towards(MAX_FORWARD, 0, -headingDegrees);
    }
}
