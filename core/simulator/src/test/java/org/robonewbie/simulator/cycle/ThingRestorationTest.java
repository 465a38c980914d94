package org.robonewbie.simulator.cycle;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.simulator.Console;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.recording.RecordingTarget;
import org.robonewbie.simulator.world.LinkMotion;

class ThingRestorationTest {

    private static final Thing BOX = Landscape.BOX.things().get(0);

    private final SimulationCycle cycle = new SimulationCycle(
            WorldSettings.beginner().withLandscape(Landscape.BOX),
            RecordingTarget.NONE,
            Console.silent(),
            Console.silent());

    private WorldSnapshot after(int cycles) {
        for (int i = 0; i < cycles; i++) {
            cycle.run();
        }
        return cycle.snapshot(false, 1, 1);
    }

    private static double x(WorldSnapshot snapshot) {
        return snapshot.things().get(0).centre().x();
    }

    /** A box that slips on its way through the air, where nothing slows it down. */
    @Test
    void movingThingGoesOnFromTheMomentThatIsRestored() {
        BodyPose high = BodyPose.of(new Pose(new Vector3(-3, 0, 2), Rotation.NONE));
        cycle.world().things().place(0, new LinkMotion(high, new Vector3(2, 0, 0), Vector3.ZERO));
        WorldSnapshot before = after(1);
        WorldSnapshot moment = after(1);
        WorldSnapshot later = after(10);

        cycle.restore(before, moment);
        WorldSnapshot again = after(10);

        assertThat(x(later)).isGreaterThan(x(moment) + 0.3);
        assertThat(x(again)).isCloseTo(x(later), within(0.001));
    }

    @Test
    void newGameBeginsWithThingsAtTheirPlaces() {
        BodyPose aside = BodyPose.of(new Pose(new Vector3(2, 2, 0.2), Rotation.NONE));
        cycle.world().things().place(0, LinkMotion.between(aside, aside, 0));

        cycle.reset();

        assertThat(cycle.world().things().now()).containsExactly(BOX);
    }
}
