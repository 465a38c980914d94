package org.robonewbie.exercises.solution;

import java.util.Optional;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.skill.Dribble;
import org.robonewbie.team.skill.Footwork;
import org.robonewbie.team.skill.Gaze;
import org.robonewbie.team.skill.Limbs;
import org.robonewbie.team.world.WorldModel;

/** Brings the ball to a point on the left of the opponent, and on from there. */
public final class DribblePast extends Agent {

    private static final double BEYOND_METRES = 0.15;
    private static final double ASIDE_METRES = 0.8;
    private static final double CLOSE_METRES = 0.25;

    private final WorldModel world = new WorldModel();
    private final Dribble dribble = new Dribble(walk, new Footwork(walk));
    private final Gaze gaze = new Gaze(new Limbs(nao, walk, motions, lookAround));
    private Optional<Translation2d> opponent = Optional.empty();

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

    private Translation2d target() {
        world.opponents().stream().findFirst().ifPresent(seen -> opponent = Optional.of(seen));
        return opponent.filter(seen -> world.ball().x() < seen.x() + BEYOND_METRES)
                .map(this::besideIt)
                .orElseGet(world::theirGoal);
    }

    /** First to the side, then straight ahead. */
    private Translation2d besideIt(Translation2d seen) {
        double y = seen.y() + ASIDE_METRES;
        boolean straight = world.ball().y() > y - CLOSE_METRES || world.ball().x() > seen.x() - ASIDE_METRES;
        return new Translation2d(seen.x() + (straight ? 2 * BEYOND_METRES : -ASIDE_METRES), y);
    }
}
