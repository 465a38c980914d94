package org.robonewbie.exercises.solution;

import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/** Brings the ball to a point beside each opponent, on the side that is asked for. */
public final class DribblePast extends Agent {

    private static final double MIDDLE_X = 0.3;
    private static final double BEYOND_METRES = 0.15;
    private static final double ASIDE_METRES = 0.8;

    private final WorldModel world = new WorldModel();
    private final Dribble dribble = new Dribble(walk, new Footwork(walk));
    private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));
    private Optional<Spot> first = Optional.empty();
    private Optional<Spot> second = Optional.empty();

    /** Creates the solution. */
    public DribblePast() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        walk.setStyle(Footwork.STYLE);
    }

    @Override
    protected void think() {
        world.update(nao, fieldView);
        gaze.look(world);
        if (nao.isFallen()) {
            motions.startGetUp();
        } else if (motions.isFinished() && world.ballAgeSeconds() < 3) {
            dribble.bring(world, target());
        }
    }

    private Spot target() {
        remember();
        double ball = world.ball().x();
        if (first.isPresent() && ball < first.get().x() + BEYOND_METRES) {
            return beside(first.get(), 1);
        }
        if (second.isPresent() && ball < second.get().x() + BEYOND_METRES) {
            return beside(second.get(), -1);
        }
        return world.theirGoal();
    }

    /** What is beside the ball is out of sight soon. */
    private void remember() {
        for (Spot opponent : world.opponents()) {
            if (opponent.x() < MIDDLE_X) {
                first = Optional.of(opponent);
            } else {
                second = Optional.of(opponent);
            }
        }
    }

    private static Spot beside(Spot opponent, int side) {
        return opponent.plus(new Spot(2 * BEYOND_METRES, side * ASIDE_METRES));
    }
}
