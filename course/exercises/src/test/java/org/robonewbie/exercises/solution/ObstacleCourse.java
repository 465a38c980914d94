package org.robonewbie.exercises.solution;

import org.robonewbie.agent.Agent;
import org.robonewbie.agent.localisation.SelfLocalisation;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.geometry.Pose2d;

/** A list of places to walk to, one after the other, by the robot's own idea of where it is. */
public final class ObstacleCourse extends Agent {

    private static final Vector3[] WAY = {
        new Vector3(-4.2, -0.78, 0),
        new Vector3(-3.2, -0.78, 0),
        new Vector3(-2.75, 0.78, 0),
        new Vector3(-1.7, 0.78, 0)
    };
    private static final double NEAR_METRES = 0.15;

    private final SelfLocalisation self = new SelfLocalisation();
    private int next;

    /** Creates the solution. */
    public ObstacleCourse() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        self.update(nao, fieldView);
        lookAround.look();
        if (nao.getTime() < 3 || !self.isKnown()) {
            walk.stop();
        } else if (next < WAY.length) {
            Vector3 place = self.pose().fromFrame(WAY[next]);
            next += Math.hypot(place.x(), place.y()) < NEAR_METRES ? 1 : 0;
            walkTo(place);
        } else {
            FieldItem ball = fieldView.ball();
            Pose2d here = self.pose();
            walkTo(ball.isKnown() ? ball.position() : here.fromFrame(Vector3.ZERO));
        }
    }

    private void walkTo(Vector3 place) {
        double bearing = Math.toDegrees(Math.atan2(place.y(), place.x()));
        double distance = Math.hypot(place.x(), place.y());
        walk.towards(Math.abs(bearing) < 25 ? Math.min(0.25, 0.1 + distance) : 0, 0, 1.5 * bearing);
    }
}
