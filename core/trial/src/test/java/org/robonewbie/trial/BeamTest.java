package org.robonewbie.trial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.protocol.effector.EffectorCommand;
import org.robonewbie.protocol.order.Order;

/** Beams of robots in a trial. */
class BeamTest {

    private static final int CYCLES = 10;

    @Test
    void robotStaysWhereTheSceneSaysUntilBeamsAreAllowed() {
        Controller beaming = readings -> List.of(new EffectorCommand.Beam(new Pose2d(-3, 1, 0)));
        try (Trial trial = Trial.served(Scene.of(RobotStart.at(-2, 0)), 1, beaming)) {
            trial.order(new Order.ChangePlayMode(PlayMode.BEFORE_KICK_OFF));
            double before = xAfterSomeCycles(trial);

            trial.allowBeams();
            double after = xAfterSomeCycles(trial);

            assertThat(before).isCloseTo(-2, within(0.1));
            assertThat(after).isCloseTo(-3, within(0.1));
        }
    }

    private static double xAfterSomeCycles(Trial trial) {
        for (int cycle = 0; cycle < CYCLES; cycle++) {
            trial.step();
        }
        return trial.now().place().x();
    }
}
