package org.robonewbie.trial;

import java.util.List;
import java.util.function.Function;
import org.robonewbie.protocol.effector.EffectorCommand;

/** A controller that computes joint speeds from sensor readings. */
final class PolicyController implements Controller {

    private final Function<SensorReadings, double[]> policy;
    private final JointSpeeds speeds = new JointSpeeds();

    PolicyController(Function<SensorReadings, double[]> policy) {
        this.policy = policy;
    }

    @Override
    public List<EffectorCommand> respond(SensorReadings readings) {
        return speeds.commands(policy.apply(readings));
    }

    @Override
    public boolean readsMessages() {
        return false;
    }
}
