package org.robonewbie.learning.gym;

import java.util.List;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.ResidualPolicy;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkMoment;
import org.robonewbie.agent.walk.WalkStyle;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.policy.WalkCourse;
import org.robonewbie.nao.kinematics.Leg;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.Posture;
import org.robonewbie.nao.motion.PostureFollower;

/**
 * A walk that actions correct: the engine plans each cycle, and an action is what the network of a {@link ResidualPolicy} would give
 * for what is observed.
 */
final class WalkGuide {

    /** The engine that the tasks of this package correct: steps of 140 ms, and a network that changes nothing. */
    static final Policy ENGINE = WalkCourse.RUN.policy(List.of(), WalkCourse.RUN.start(0));

    /** What is observed of a robot that walks. */
    static final List<ObservedQuantity> QUANTITIES = ResidualPolicy.INPUTS.stream()
            .map(input -> new ObservedQuantity(
                    input.name(), input.unit(), -ResidualPolicy.MAX_INPUT, ResidualPolicy.MAX_INPUT))
            .toList();

    private static final WalkMoment AT_REST = new WalkMoment(
            Leg.LEFT, 0, 0, WalkVelocity.ZERO, WalkVelocity.ZERO, 0, 0, 0, 0, 0, FootPressure.NONE, FootPressure.NONE);

    private final WalkEngine engine;
    private final PostureFollower follower;
    private WalkMoment moment = AT_REST;
    private Posture planned = Stance.POSTURE;
    private boolean walking;

    WalkGuide(WalkStyle style, Motors motors) {
        engine = new WalkEngine(style, this::noted);
        follower = new PostureFollower(motors);
    }

    private Posture noted(Posture posture, WalkMoment now) {
        moment = now;
        return posture;
    }

    /** Plans the next cycle by what a robot perceives that is asked for a velocity. */
    void plan(WalkVelocity wanted, double... perceived) {
        engine.towards(wanted);
        engine.feel(Perception.torso(perceived));
        engine.feel(Perception.leftFoot(perceived), Perception.rightFoot(perceived));
        moment = AT_REST;
        planned = engine.next();
    }

    /** What is observed before the next action: the {@link #QUANTITIES}. */
    double[] inputs() {
        return ResidualPolicy.inputs(moment);
    }

    /** Moves the joints by the plan and an action. */
    void move(double... action) {
        if (!walking) {
            walking = true;
            follower.begin();
        }
        follower.follow(ResidualPolicy.corrected(planned, moment, action));
    }
}
