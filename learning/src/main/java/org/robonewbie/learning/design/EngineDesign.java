package org.robonewbie.learning.design;

import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.search.Trial;
import org.robonewbie.learning.trial.WalkTrial;

/**
 * What the walk engine is searched for with: in some trials it walks straight on as fast as it can, in others it is commanded
 * without any sense, and it must stay on its feet in all of them.
 *
 * @param stepMillis time of one step
 * @param slip by which factor the feet are set further than the robot shall get
 * @param most the largest speeds
 * @param newtons strength of the pushes
 */
public record EngineDesign(int stepMillis, double slip, WalkVelocity most, double newtons) implements Trial {

    private static final double SECONDS = 7;

    @Override
    public double cost(double[] x, long seed) {
        WalkStyle style = WalkStyle.of(stepMillis, slip, most, x);
        boolean straight = seed % 2 == 0;
        WalkTrial trial = straight
                ? WalkTrial.straight(style, new WalkVelocity(most.forward(), 0, 0), SECONDS, seed, newtons)
                : WalkTrial.erratic(style, SECONDS, seed, newtons);
        double speed = trial.forward() / trial.seconds();
        if (!trial.stood()) {
            return 6
                    - 3 * trial.seconds() / trial.planned()
                    - (straight ? 2 * Math.max(0, Math.min(most.forward(), speed)) : 0);
        }
        double cost = Costs.roughness(trial.watch()) + Costs.beyond(x, 6);
        return straight
                ? cost
                        + 3 * Math.max(0, 1 - speed / most.forward())
                        + 0.3 * Math.abs(trial.left())
                        + Math.abs(trial.turnedDegrees()) / 30
                : cost;
    }
}
