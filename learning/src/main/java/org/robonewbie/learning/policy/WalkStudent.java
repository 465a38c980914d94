package org.robonewbie.learning.policy;

import java.util.Optional;
import org.robonewbie.agent.perception.FootPressure;
import org.robonewbie.agent.perception.TorsoMotion;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.WalkEngine;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.kinematics.SimSparkFrame;
import org.robonewbie.nao.motion.JointStates;
import org.robonewbie.nao.motion.Motors;
import org.robonewbie.nao.motion.PostureFollower;
import org.robonewbie.protocol.perceptor.FootForce;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.SensorReadings;

/** A robot that learns to walk: the walk engine with a reflex, without an agent around it. */
final class WalkStudent {

    private final JointStates joints = new JointStates();
    private final Motors motors = new Motors(joints);
    private final PostureFollower follower = new PostureFollower(motors);
    private final WalkEngine engine;
    private boolean walking;

    WalkStudent(PolicyWalk walk) {
        engine = new WalkEngine(walk.style(), walk.reflex());
    }

    Performer performer() {
        return Performer.ofPolicy(this::degreesPerSecond);
    }

    void walk(WalkVelocity velocity) {
        engine.towards(velocity);
    }

    private double[] degreesPerSecond(SensorReadings readings) {
        readings.sense(joints);
        engine.feel(
                new TorsoMotion(SimSparkFrame.toBody(readings.gyro()), SimSparkFrame.toBody(readings.acceleration())));
        engine.feel(pressure(readings.feet().left()), pressure(readings.feet().right()));
        if (engine.isStanding()) {
            walking = false;
            motors.stopMotion();
        } else {
            step();
        }
        motors.endCycle();
        return motors.sentDegreesPerSecond();
    }

    private void step() {
        if (!walking) {
            walking = true;
            follower.begin();
        }
        follower.follow(engine.next());
    }

    private static FootPressure pressure(Optional<FootForce> foot) {
        return foot.map(felt ->
                        new FootPressure(SimSparkFrame.toBody(felt.point()), SimSparkFrame.toBody(felt.force())))
                .orElse(FootPressure.NONE);
    }
}
