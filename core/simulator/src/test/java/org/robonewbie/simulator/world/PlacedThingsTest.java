package org.robonewbie.simulator.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.kinematics.Rotation;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.landscape.Thing;
import org.robonewbie.simulator.physics.BodyPose;
import org.robonewbie.simulator.state.WorldState;

class PlacedThingsTest {

    private static final Thing CRATE = Thing.movable("crate", new Vector3(0.2, 0.2, 0.2), new Vector3(1, 0, 0.1), 0.5);
    private static final Thing WALL = Thing.fixed("wall", new Vector3(0.2, 2, 1), new Vector3(-1, 0, 0.5));
    private static final Landscape BOTH = new Landscape("both", "a crate and a wall", List.of(CRATE, WALL));

    private static SoccerWorld world(PhysicsEngine engine, Landscape landscape) {
        return new SoccerWorld(SoccerField.BEGINNER, BallProperties.STANDARD, engine.newWorld(), landscape);
    }

    private static SoccerWorld world() {
        return world(PhysicsEngine.FAST, BOTH);
    }

    private static void step(SoccerWorld world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    @ParameterizedTest
    @EnumSource
    void restingThingsStayWhereTheyAre(PhysicsEngine engine) {
        SoccerWorld world = world(engine, BOTH);

        step(world, 200);

        assertThat(world.things().now().get(0).centre().distanceTo(CRATE.centre()))
                .isLessThan(0.002);
        assertThat(world.things().now().get(1)).isEqualTo(WALL);
    }

    @ParameterizedTest
    @EnumSource
    void ballPushesACrateAndIsStoppedByAWall(PhysicsEngine engine) {
        SoccerWorld world = world(engine, BOTH);
        world.ball().place(new Vector3(0.6, 0, 0.042));
        world.ball().setVelocity(new Vector3(8, 0, 0));
        step(world, 50);
        double pushed = world.things().now().get(0).centre().x();

        world.ball().place(new Vector3(0, 0, 0.042));
        world.ball().setVelocity(new Vector3(-3, 0, 0));
        step(world, 100);

        assertThat(pushed).isGreaterThan(1.004);
        assertThat(world.ball().position().x()).isGreaterThan(-0.9);
    }

    @ParameterizedTest
    @EnumSource
    void robotThatFallsOnATableLiesOnIt(PhysicsEngine engine) {
        Thing table = Thing.fixed("table", new Vector3(3, 3, 0.5), new Vector3(3, 0, 0.25));
        SoccerWorld world = world(engine, new Landscape("table", "a table", List.of(table)));
        Robot robot = world.addRobot(RobotType.TYPE_0);
        robot.moveUpright(new Vector3(3, 0, 1), 0);

        step(world, 150);

        assertThat(robot.torso().position().z()).isGreaterThan(0.5);
    }

    @Test
    void savedWorldGoesOnToTheBit() {
        SoccerWorld world = world();
        world.ball().place(new Vector3(0.6, 0.05, 0.042));
        world.ball().setVelocity(new Vector3(8, 0, 0));
        step(world, 6);
        WorldState state = world.save();
        step(world, 40);
        SoccerWorld other = world();

        other.restore(WorldState.ofBytes(state.toBytes()));
        step(other, 40);

        assertThat(other.save()).isEqualTo(world.save());
        assertThat(other.things().now()).isEqualTo(world.things().now());
        assertThat(other.things().now().get(0)).isNotEqualTo(CRATE);
    }

    @Test
    void stateOfAnotherLandscapeIsRefused() {
        WorldState state = world().save();
        SoccerWorld bare = world(PhysicsEngine.FAST, Landscape.SOCCER);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> bare.restore(state))
                .withMessageContaining("a crate and a wall");
    }

    @Test
    void resetReturnsWhatWasMoved() {
        SoccerWorld world = world();
        move(world, new Vector3(3, 1, 0.1));

        world.things().reset();

        assertThat(world.things().now()).isEqualTo(BOTH.things());
    }

    @Test
    void thingBeyondAllLimitsReturnsToItsBeginning() {
        SoccerWorld world = world();
        Vector3 upwards = new Vector3(0, 0, 1000);
        for (int i = 0; i < 600; i++) {
            Thing crate = world.things().now().get(0);
            BodyPose pose = BodyPose.of(crate.pose());
            world.things()
                    .place(0, new LinkMotion(new BodyPose(pose.position(), pose.rotation()), upwards, Vector3.ZERO));
            world.step();
        }

        assertThat(world.things().now().get(0).centre().z()).isLessThan(10_000);
    }

    private static void move(SoccerWorld world, Vector3 place) {
        BodyPose pose = BodyPose.of(new Pose(place, Rotation.about(new Vector3(0, 0, 1), 30)));
        world.things().place(0, LinkMotion.between(pose, pose, 0));
    }
}
