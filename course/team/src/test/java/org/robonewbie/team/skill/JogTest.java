package org.robonewbie.team.skill;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.simulator.landscape.Landscape;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.world.WorldModel;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** Long ways: the robot jogs, and arrives at a walk. */
class JogTest {

    private static final Translation2d TARGET = new Translation2d(4, 1);

    private static final class Going extends Agent {

        private final WorldModel world = new WorldModel();
        private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));
        private final Footwork feet = new Footwork(walk, true);

        Going() {
            fieldView.setTransformation(CameraTransformation.KINEMATICS);
        }

        @Override
        protected void think() {
            world.update(nao, fieldView);
            walk.setStyle(Footwork.STYLE);
            feet.go(world, TARGET, 90);
            gaze.look(world);
        }
    }

    @Test
    void itIsFasterOnALongWayThanTheWalkAndStandsAtItsEnd() {
        Pose2d start = new Pose2d(-6, 0, 0);
        List<RobotStart> robots = List.of(new RobotStart("Team", 2, RobotType.TYPE_0, start, List.of()));
        Scene scene =
                new Scene(SoccerParameters.league(), true, Landscape.SOCCER, robots, Optional.of(new Vector3(6, 0, 0)));
        try (Trial trial = Trial.served(scene, 1, Controller.ofAgent(new Going()))) {
            trial.run(10);
            double metres = trial.now().place(0).x() - start.x();
            trial.run(20);
            Pose2d end = trial.now().place(0);

            assertThat(metres).isGreaterThan(10 * Footwork.STYLE.most().forward());
            assertThat(end.translation().distanceTo(TARGET)).isLessThan(0.5);
            assertThat(end.degrees()).isBetween(60.0, 120.0);
            assertThat(trial.now().robots().get(0).isStanding()).isTrue();
        }
    }
}
