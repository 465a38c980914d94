package org.robonewbie.learning.environment;

import java.util.Optional;
import org.robonewbie.learning.environment.DomainRandomization.Name;
import org.robonewbie.learning.environment.DomainRandomization.Range;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.TrialHook;

/** Domain randomization of the bodies of all robots in an episode: strength of each joint, grip of the soles, and load of the torso. */
final class BodyRandomization implements TrialHook {

    private static final double GRAVITY = 9.81;

    private final double forward;
    private final double left;

    private BodyRandomization(double forward, double left) {
        this.forward = forward;
        this.left = left;
    }

    /**
     * Changes the bodies at the beginning of an episode.
     *
     * @param options the options of the episode, with a range for the strength
     * @param seed the seed of the episode
     * @return a hook for each cycle of the episode
     */
    static BodyRandomization apply(Trial trial, DomainRandomization options, long seed) {
        RandomSource random = new RandomSource(31 * ~seed + 11);
        Optional<Range> strength = options.range(Name.STRENGTH);
        for (int i = 0; i < trial.now().robots().size(); i++) {
            Robot robot = trial.robot(i);
            robot.setMassFactor(options.of(Name.MASS, 1));
            robot.setSoleGrip(options.of(Name.SOLE_FRICTION, 1));
            if (strength.isPresent()) {
                for (Joint joint : Joint.values()) {
                    robot.setStrength(joint, strength.get().draw(random));
                }
            }
        }
        BodyRandomization all = new BodyRandomization(options.of(Name.COM_FORWARD, 0), options.of(Name.COM_LEFT, 0));
        all.act(trial);
        return all;
    }

    /** Applies the moment of the torso's weight about the torso's centre, where the engine applies the weight. */
    @Override
    public void act(Trial trial) {
        if (forward == 0 && left == 0) {
            return;
        }
        for (int i = 0; i < trial.now().robots().size(); i++) {
            Robot robot = trial.robot(i);
            Vector3 offset = robot.torso().rotation().apply(new Vector3(-left, forward, 0));
            double weight = GRAVITY * robot.torsoMass();
            robot.twist(new Vector3(-weight * offset.y(), weight * offset.x(), 0));
        }
    }
}
