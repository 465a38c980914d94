package org.robonewbie.learning.environment;

import java.util.Arrays;
import java.util.List;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.policy.Network;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.FastWalk;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkMoment;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.PostureFollower;

/**
 * A walk that actions correct: the engine plans each cycle, and an action is what the network of a {@link ResidualPolicy} would give
 * for what is observed.
 */
final class WalkGuide {

    /** What is observed of a robot that walks. */
    static final List<ObservedQuantity> QUANTITIES = ResidualPolicy.INPUTS.stream()
            .map(input -> new ObservedQuantity(
                    input.name(), input.unit(), -ResidualPolicy.MAX_INPUT, ResidualPolicy.MAX_INPUT))
            .toList();

    private static final double DEFAULT_EASING = 4;

    private static final WalkMoment AT_REST = new WalkMoment(
            Leg.LEFT, 0, 0, WalkVelocity.ZERO, WalkVelocity.ZERO, 0, 0, 0, 0, 0, FootPressure.NONE, FootPressure.NONE);

    private final WalkEngine engine;
    private final Motors motors;
    private final PostureFollower follower;
    private final boolean holdsAtRest;
    private WalkMoment moment = AT_REST;
    private Posture planned = Stance.POSTURE;
    private boolean resting;
    private boolean walking;

    /** Prepares a walk; at rest the joints hold as those of an agent do, or follow the stance. */
    WalkGuide(WalkStyle style, Motors motors, boolean holdsAtRest) {
        engine = new WalkEngine(style, this::noted);
        this.motors = motors;
        this.holdsAtRest = holdsAtRest;
        follower = new PostureFollower(motors);
    }

    /** The numbers of an engine that walks with the standard gait, and a network that changes nothing. */
    static Policy engine(int stepMillis, WalkVelocity max, double backward) {
        double[] gait = Arrays.copyOf(WalkStyle.coordinates(), FastWalk.PARAMETERS);
        gait[FastWalk.PARAMETERS - 2] = DEFAULT_EASING;
        int[] layers = {ResidualPolicy.INPUTS.size(), ResidualPolicy.OUTPUTS.size()};
        Network zero = Network.of(layers, new double[Network.size(layers)]);
        return PolicyWalk.policy("engine", List.of(), stepMillis, max, backward, gait, zero);
    }

    private Posture noted(Posture posture, WalkMoment now) {
        moment = now;
        return posture;
    }

    /** Plans the next cycle by what a robot perceives that is asked for a velocity. */
    void plan(WalkVelocity wanted, double... perceived) {
        engine.towards(wanted);
        engine.update(Perception.torso(perceived));
        engine.update(Perception.leftFoot(perceived), Perception.rightFoot(perceived));
        moment = AT_REST;
        resting = engine.isStanding();
        planned = engine.next();
    }

    /** What is observed before the next action: the {@link #QUANTITIES}. */
    double[] inputs() {
        return ResidualPolicy.inputs(moment);
    }

    /** Moves the joints by the plan and an action. */
    void move(double... action) {
        if (holdsAtRest && resting) {
            walking = false;
            motors.stopMotion();
            return;
        }
        if (!walking) {
            walking = true;
            follower.begin();
        }
        follower.follow(ResidualPolicy.corrected(planned, moment, action));
    }
}
