package org.robonewbie.learning.objective;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.world.Robot;
import org.robonewbie.simulator.world.SoccerWorld;

class TrueStateEyeTest {

    private static final double FALL_METRES = 1;

    private final SoccerWorld world = new SoccerWorld(SoccerField.BEGINNER);
    private final Robot robot = world.addRobot(RobotType.TYPE_0);

    @Test
    void seesWhereRobotAndBallAre() {
        robot.moveUpright(new Vector3(-2, 1, 0.39), -90);
        world.ball().place(new Vector3(1, 0, 0.042));

        TrueState state = new TrueStateEye(world, robot).look();

        assertThat(state.torso().distanceTo(new Vector3(-2, 1, 0.39))).isLessThan(1e-9);
        assertThat(state.headingDegrees()).isCloseTo(0, within(1e-6));
        assertThat(state.ahead(state.ball())).isCloseTo(3, within(1e-6));
        assertThat(state.left(state.ball())).isCloseTo(-1, within(1e-6));
        assertThat(state.ballToGoal()).isCloseTo(5, within(1e-9));
        assertThat(state.isFallen()).isFalse();
    }

    @Test
    void measuresTheWayToTheGoalThatItsRobotPlaysTo() {
        world.ball().place(new Vector3(1, 0, 0.042));

        TrueState state = new TrueStateEye(world, robot, TeamSide.LEFT).look();

        assertThat(state.ballToGoal()).isCloseTo(7, within(1e-9));
    }

    @Test
    void remembersAGoal() {
        TrueStateEye eye = new TrueStateEye(world, robot);
        world.ball().place(new Vector3(6.3, 0, 0.042));
        world.step();
        boolean before = eye.look().isScored();
        world.ball().place(new Vector3(0, 0, 0.042));
        world.step();
        world.step();

        assertThat(before).isTrue();
        assertThat(eye.look().isScored()).isTrue();
    }

    @Test
    void fallingFreelyIsNoWork() {
        robot.moveUpright(new Vector3(0, 0, 0.39 + FALL_METRES), -90);
        TrueStateEye eye = new TrueStateEye(world, robot);
        TrueState state = eye.look();

        while (state.seconds() < 0.3) {
            world.step();
            state = eye.look();
        }

        assertThat(state.workJoules()).isLessThan(1);
    }

    @Test
    void liftingTheRobotIsWorkAgainstItsWeight() {
        robot.moveUpright(new Vector3(0, 0, 2), -90);
        TrueStateEye eye = new TrueStateEye(world, robot);
        eye.look();

        for (int i = 0; i < 20; i++) {
            robot.push(new Vector3(0, 0, 4 * 4.607 * 9.81));
            world.step();
            eye.look();
        }

        TrueState state = eye.look();
        double kilograms =
                robot.model().links().stream().mapToDouble(Link::massKg).sum();
        double speed = state.velocity().z();
        double energy = kilograms * (9.81 * (state.torso().z() - 2) + speed * speed / 2);
        assertThat(state.workJoules()).isCloseTo(energy, within(0.15 * energy));
    }
}
