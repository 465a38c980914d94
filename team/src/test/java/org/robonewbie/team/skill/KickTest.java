package org.robonewbie.team.skill;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.team.world.WorldModel;
import org.robonewbie.trial.Moment;
import org.robonewbie.trial.Performer;
import org.robonewbie.trial.Place;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;

/** A kick out of the walk, with noise. */
class KickTest {

    private static final Place START = new Place(-8, 0, 0);

    /** Walks to the ball and kicks it along the pitch, once. */
    private static final class Kicker extends Agent {

        private final WorldModel world = new WorldModel();
        private final Limbs body = new Limbs(nao, walk, motions, lookAround);
        private final Kick kick = new Kick(body, new Footwork(walk));
        private final Gaze gaze = new Gaze(body);
        private boolean begun;

        Kicker() {
            fieldView.setTransformation(CameraTransformation.KINEMATICS);
            walk.setStyle(Footwork.STYLE);
        }

        @Override
        protected void think() {
            world.update(nao, fieldView);
            gaze.look(world);
            begun = begun || motions.start("stand");
            if (motions.isFinished() && world.ballAgeSeconds() < 1) {
                kick.kick(world, 0);
            }
        }
    }

    /** Who kicks off may touch the ball only once: a foot that brushes it before the kick is a foul. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theFirstTouchIsTheKick(long seed) {
        Scene scene = Scene.of(RobotStart.at(START).after("stand"))
                .withParameters(SoccerParameters.league())
                .withBall(START.pointAt(1.5, 0.05));
        try (Trial trial = Trial.served(scene, seed, Performer.ofAgent(new Kicker()))) {
            Moment now = trial.now();
            while (trial.seconds() < 12 && now.ballVelocity().length() < 0.05) {
                now = trial.step();
            }
            trial.run(trial.seconds() + 0.06);

            assertThat(trial.now().ballVelocity().length()).isGreaterThan(4);
        }
    }
}
