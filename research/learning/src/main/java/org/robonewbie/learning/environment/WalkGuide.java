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
 * Walk engine with residual control: the engine plans each cycle, and an action replaces the output of a {@link
 * ResidualPolicy}.
 */
final class WalkGuide {

    /** Components of the observation. */
    static final List<ObservedQuantity> QUANTITIES =
            ObservedQuantity.symmetric(ResidualPolicy.INPUTS, ResidualPolicy.MAX_INPUT);

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

    /**
     * Creates the guide for a standing robot. At rest, the joints either hold their current angles, like those of an agent, or return to
     * the standard stance.
     */
    WalkGuide(WalkStyle style, Motors motors, boolean holdsAtRest) {
        engine = new WalkEngine(style, this::observe);
        this.motors = motors;
        this.holdsAtRest = holdsAtRest;
        follower = new PostureFollower(motors);
    }

    /** Returns a policy with the standard gait and a network whose outputs are zero. */
    static Policy engine(int stepMillis, WalkVelocity max, double backward) {
        double[] gait = Arrays.copyOf(WalkStyle.coordinates(), FastWalk.PARAMETERS);
        gait[FastWalk.PARAMETERS - 2] = DEFAULT_EASING;
        int[] layers = {ResidualPolicy.INPUTS.size(), ResidualPolicy.OUTPUTS.size()};
        Network zero = Network.of(layers, new double[Network.size(layers)]);
        return PolicyWalk.policy("engine", List.of(), stepMillis, max, backward, gait, zero);
    }

    private Posture observe(Posture posture, WalkMoment now) {
        moment = now;
        return posture;
    }

    /** Plans the next cycle, given the commanded velocity and an observation from {@link Perception}. */
    void plan(WalkVelocity command, double... observation) {
        engine.towards(command);
        engine.update(Perception.torso(observation));
        engine.update(Perception.leftFoot(observation), Perception.rightFoot(observation));
        moment = AT_REST;
        resting = engine.isStanding();
        planned = engine.next();
    }

    /** Returns the observation for the next action, in the order of {@link #QUANTITIES}. */
    double[] inputs() {
        return ResidualPolicy.inputs(moment);
    }

    /** Drives the joints to the planned posture, corrected by an action. */
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
