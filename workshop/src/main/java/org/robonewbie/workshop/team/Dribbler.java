package org.robonewbie.workshop.team;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.CloseDribble;
import org.robonewbie.team.skill.CloseDribbleNumbers;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.world.WorldModel;

/**
 * Robot that dribbles straight along the pitch, keeping the ball close. It starts walking as soon as it has seen the
 * ball.
 */
final class Dribbler extends Agent {

    private static final double FAR_METRES = 10;

    private final WorldModel world = new WorldModel();
    private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));
    private final CloseDribble dribble;

    Dribbler(CloseDribbleNumbers numbers) {
        dribble = new CloseDribble(walk, new Footwork(walk), numbers);
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(numbers.style());
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        gaze.look(world);
        if (Double.isFinite(world.ballAgeSeconds())) {
            dribble.bring(world, new Translation2d(world.place().x() + FAR_METRES, 0));
        }
    }
}
