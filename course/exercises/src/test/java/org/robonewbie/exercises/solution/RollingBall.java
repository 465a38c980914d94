package org.robonewbie.exercises.solution;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;

/** Place and velocity of the ball as it was seen last; what rolls loses a share of its speed in each second. */
public final class RollingBall extends Agent {

    private static final double LOST_PER_SECOND = 1.04;
    private static final double WINDOW_SECONDS = 0.4;

    private final Deque<Sight> sights = new ArrayDeque<>();

    /** Creates the solution. */
    public RollingBall() {}

    private record Sight(double seconds, Vector3 place) {}

    @Override
    protected void think() {
        nao.setJointAngle(Joint.NECK_YAW, 0, 60);
        if (fieldView.ball().isVisible()) {
            remember(new Sight(nao.getTime(), fieldView.ball().position()));
        }
        if (!sights.isEmpty()) {
            Vector3 now = guess();
            nao.say(String.format(Locale.ROOT, "ball:%.2f:%.2f", now.x(), now.y()));
        }
    }

    private void remember(Sight sight) {
        sights.addLast(sight);
        while (sight.seconds() - sights.getFirst().seconds() > WINDOW_SECONDS) {
            sights.removeFirst();
        }
    }

    private Vector3 guess() {
        Sight first = sights.getFirst();
        Sight last = sights.getLast();
        double span = last.seconds() - first.seconds();
        if (span < WINDOW_SECONDS / 2) {
            return last.place();
        }
        Vector3 velocity = last.place().minus(first.place()).times(1 / span);
        double age = nao.getTime() - last.seconds() + span / 2;
        double way = (1 - Math.exp(-LOST_PER_SECOND * age)) / LOST_PER_SECOND - span / 2;
        return last.place().plus(velocity.times(Math.max(0, way)));
    }
}
