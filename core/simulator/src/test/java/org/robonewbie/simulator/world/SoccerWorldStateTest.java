package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.physics.sparse.SparsePhysicsWorld;
import org.robonewbie.simulator.state.WorldState;

class SoccerWorldStateTest {

    private static final int MOMENTS_PER_SCENE = 20;
    private static final int STEPS = 200;
    private static final int STEPS_AFTER_MOMENT = 20;

    /** What happens in a world; the same at the same step, whatever happened before. */
    enum Scene {
        ALONE(1, 1),
        AT_GOAL(2, 1),
        PILE(4, 0.25),
        HEAP(5, 0.12),
        COMING_AND_GOING(4, 0.3);

        private final int robots;
        private final double spread;

        Scene(int robots, double spread) {
            this.robots = robots;
            this.spread = spread;
        }

        void begin(SoccerWorld world) {
            for (int i = 0; i < robots; i++) {
                world.addRobot(RobotType.values()[i % RobotType.values().length])
                        .moveUpright(place(i), 70.0 * i);
            }
        }

        private Vector3 place(int robot) {
            double x = this == AT_GOAL ? -14.7 : 0;
            int row = robot / 3;
            return new Vector3(x + spread * (robot % 3), spread * row, 0.4 + spread * (robot % 2));
        }

        /** What happens before a step; it depends on nothing but the number of the step. */
        void act(SoccerWorld world, int step) {
            Random random = new Random(1000L * ordinal() + step);
            if (step % 50 == 10) {
                Robot target = world.robots().get(0);
                world.ball().place(target.torso().position().plus(new Vector3(0.3, 0, 0)));
                world.ball().setVelocity(new Vector3(-4, random.nextGaussian(), 1));
            }
            if (this == COMING_AND_GOING && step % 60 == 59) {
                world.removeRobot(world.robots().get(random.nextInt(3)));
                world.addRobot(RobotType.TYPE_4).beam(place(step / 60), 30);
            }
            for (Robot robot : world.robots()) {
                int hinge = random.nextInt(robot.nao().hinges().size());
                robot.setMotorSpeed(hinge, 8 * random.nextDouble() - 4);
            }
        }
    }

    private static SoccerWorld newWorld() {
        return new SoccerWorld(SoccerField.LEAGUE);
    }

    private static void run(Scene scene, SoccerWorld world, int from, int to) {
        for (int step = from; step < to; step++) {
            scene.act(world, step);
            world.step();
        }
    }

    @ParameterizedTest
    @EnumSource
    void anyMomentGoesOnToTheBit(Scene scene) {
        List<WorldState> states = new ArrayList<>();
        SoccerWorld uninterrupted = newWorld();
        scene.begin(uninterrupted);
        for (int step = 0; step < STEPS; step++) {
            states.add(uninterrupted.save());
            scene.act(uninterrupted, step);
            uninterrupted.step();
        }
        SoccerWorld reused = newWorld();
        Random random = new Random(scene.ordinal());

        for (int i = 0; i < MOMENTS_PER_SCENE; i++) {
            int moment = random.nextInt(STEPS - STEPS_AFTER_MOMENT);
            SoccerWorld fresh = newWorld();
            reused.restore(states.get(moment));
            fresh.restore(WorldState.ofBytes(states.get(moment).toBytes()));
            assertThat(fresh.save()).isEqualTo(states.get(moment));
            run(scene, reused, moment, moment + STEPS_AFTER_MOMENT);
            run(scene, fresh, moment, moment + STEPS_AFTER_MOMENT);

            assertThat(reused.save()).isEqualTo(states.get(moment + STEPS_AFTER_MOMENT));
            assertThat(fresh.save()).isEqualTo(states.get(moment + STEPS_AFTER_MOMENT));
        }
    }

    @Test
    void whatSensorsAndContactsSaidIsThereAtOnce() {
        SoccerWorld world = newWorld();
        Scene.HEAP.begin(world);
        run(Scene.HEAP, world, 0, 60);
        WorldState state = world.save();
        SoccerWorld other = newWorld();

        other.restore(state);

        assertThat(world.robotContacts()).isNotEmpty();
        assertThat(other.robotContacts()).hasSameSizeAs(world.robotContacts());
        for (int i = 0; i < world.robots().size(); i++) {
            Robot before = world.robots().get(i);
            Robot after = other.robots().get(i);
            assertThat(after.acceleration()).isEqualTo(before.acceleration());
            assertThat(after.footForces()).isEqualTo(before.footForces());
            assertThat(after.gyroDegreesPerSecond()).isEqualTo(before.gyroDegreesPerSecond());
        }
    }

    @Test
    void robotsOfTheSameTypesStayTheSameObjects() {
        SoccerWorld world = newWorld();
        Robot kept = world.addRobot(RobotType.TYPE_0);
        WorldState one = world.save();
        Robot second = world.addRobot(RobotType.TYPE_1);
        WorldState two = world.save();

        world.restore(one);
        List<Robot> afterFirst = List.copyOf(world.robots());
        world.restore(two);

        assertThat(afterFirst).containsExactly(kept);
        assertThat(world.robots()).hasSize(2).first().isSameAs(kept);
        assertThat(world.robots()).doesNotContain(second);
    }

    @Test
    void aStateOfAnotherPitchIsRefused() {
        WorldState state = newWorld().save();
        SoccerWorld other = new SoccerWorld(
                SoccerField.LEAGUE, new BallProperties(0.1, 0.2), new SparsePhysicsWorld(), Landscape.SOCCER);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> other.restore(state))
                .withMessage(
                        "The saved state belongs to a world with BallProperties[radius=0.042, massKg=0.026], but this"
                                + " one has BallProperties[radius=0.1, massKg=0.2]. Start a world with the same settings.");
    }
}
