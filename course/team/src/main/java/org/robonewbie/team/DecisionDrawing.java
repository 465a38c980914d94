package org.robonewbie.team;

import java.util.List;
import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Translation2d;
import org.robonewbie.team.tactics.KickChoice;
import org.robonewbie.team.tactics.Plan;
import org.robonewbie.team.talk.TeamRole;
import org.robonewbie.team.world.BallFilter;
import org.robonewbie.team.world.WorldModel;

/**
 * Draws a player's beliefs and decisions in the studio: its role and path, the ball with its predicted path and target, and
 * the receiver of a pass. Each of the striker's options is a ray from the ball: the longer the ray, the higher the gain.
 */
final class DecisionDrawing {

    private static final double HEAD_METRES = -0.5;
    private static final double MAX_RAY_METRES = 1;
    private static final String KICK_COLOUR = "white";
    private static final String DRIBBLE_COLOUR = "grey";

    private final Robot nao;
    private final WorldModel world;

    DecisionDrawing(Robot nao, WorldModel world) {
        this.nao = nao;
        this.world = world;
    }

    /** Draws the plan, the options and the planned path. */
    void show(Plan plan, List<KickChoice.Option> options, List<Translation2d> way) {
        nao.publishPose(world.pose().x(), world.pose().y(), world.pose().degrees());
        nao.drawText(
                new Vector3(0, 0, 0.3),
                plan.role() + " " + plan.action(),
                plan.role().colour());
        nao.plot("seconds since the ball was seen", Math.min(10, world.ballAgeSeconds()));
        if (!world.isFallen()) { // lines that start at a fallen robot would be misplaced
            showWay(plan, way);
            if (plan.role() == TeamRole.STRIKER) {
                showBall();
                showChoice(plan, options);
            }
        }
    }

    private void showWay(Plan plan, List<Translation2d> way) {
        String colour = plan.role().colour();
        Translation2d before = world.place();
        for (Translation2d bend : way) {
            nao.drawLine(seen(before), seen(bend), colour);
            before = bend;
        }
        nao.drawPoint(seen(plan.target()), colour);
    }

    /** Draws the ball and the position at which it will come to rest. */
    private void showBall() {
        Translation2d rest = world.ball().plus(world.ballVelocity().times(BallFilter.ROLLING_SECONDS));
        nao.drawCircle(seen(world.ball()), 0.15, "orange");
        nao.drawLine(seen(world.ball()), seen(rest), "orange");
    }

    /** Draws the options as rays, and a line from the ball to its target. */
    private void showChoice(Plan plan, List<KickChoice.Option> options) {
        boolean kick = plan.isKick();
        if (!kick && plan.action() != Plan.Action.DRIBBLE) {
            return;
        }
        double most =
                options.stream().mapToDouble(KickChoice.Option::gain).max().orElse(0);
        options.stream().filter(option -> option.gain() > 0).forEach(option -> showRay(option, most));
        nao.drawLine(seen(world.ball()), seen(plan.target()), kick ? KICK_COLOUR : DRIBBLE_COLOUR);
        if (plan.receiver() > 0) {
            Translation2d middle =
                    world.ball().plus(plan.target().minus(world.ball()).times(0.5));
            nao.drawText(seen(middle), "pass to " + plan.receiver(), KICK_COLOUR);
        }
    }

    private void showRay(KickChoice.Option option, double most) {
        boolean kick = option.plan().isKick();
        Translation2d ray = Translation2d.polar(option.plan().headingDegrees(), MAX_RAY_METRES * option.gain() / most);
        nao.drawLine(seen(world.ball()), seen(world.ball().plus(ray)), kick ? KICK_COLOUR : DRIBBLE_COLOUR);
    }

    private Vector3 seen(Translation2d spot) {
        Translation2d here = spot.seenFrom(world.pose());
        return new Vector3(here.x(), here.y(), HEAD_METRES);
    }
}
