package org.robonewbie.team;

import java.util.List;
import org.robonewbie.agent.Robot;
import org.robonewbie.nao.Vector3;
import org.robonewbie.team.tactics.Plan;
import org.robonewbie.team.tactics.TeamRole;
import org.robonewbie.team.world.Spot;
import org.robonewbie.team.world.WorldModel;

/** Shows in the studio what a player believes and plans: its role, its way, the ball and how it rolls, and whom it passes to. */
final class Board {

    private static final double HEAD_METRES = -0.5;
    private static final double FOLLOWING_METRES = 0.677;

    private final Robot nao;
    private final WorldModel world;

    Board(Robot nao, WorldModel world) {
        this.nao = nao;
        this.world = world;
    }

    /** Draws the plan and the way of this cycle. */
    void show(Plan plan, List<Spot> way) {
        nao.tellPose(world.pose().x(), world.pose().y(), world.pose().headingDegrees());
        String colour = plan.role().colour();
        nao.drawText(new Vector3(0, 0, 0.3), plan.role() + " " + plan.action(), colour);
        Spot before = world.place();
        for (Spot bend : way) {
            nao.drawLine(seen(before), seen(bend), colour);
            before = bend;
        }
        nao.drawPoint(seen(plan.target()), colour);
        if (plan.role() == TeamRole.STRIKER) {
            nao.drawCircle(seen(world.ball()), 0.15, "orange");
            nao.drawLine(
                    seen(world.ball()),
                    seen(world.ball().plus(world.ballVelocity().times(FOLLOWING_METRES))),
                    "orange");
        }
        nao.plot("seconds since the ball was seen", Math.min(10, world.ballAgeSeconds()));
    }

    private Vector3 seen(Spot spot) {
        Spot here = spot.seenFrom(world.pose());
        return new Vector3(here.x(), here.y(), HEAD_METRES);
    }
}
