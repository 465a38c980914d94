package org.robonewbie.exercises.solution;

import java.util.Locale;
import org.robonewbie.agent.Agent;
import org.robonewbie.agent.perception.CameraTransformation;
import org.robonewbie.agent.perception.FieldItem;
import org.robonewbie.nao.Landmark;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.nao.Vector3;

/** Two landmarks that are far apart: their distances give the place, which side of their line the order of bearings. */
public final class WhereAmI extends Agent {

    /** Creates the solution. */
    public WhereAmI() {}

    @Override
    protected void think() {
        fieldView.setTransformation(CameraTransformation.KINEMATICS);
        lookAround.look();
        double weights = 0;
        double x = 0;
        double y = 0;
        Landmark[] all = Landmark.values();
        for (int i = 0; i < all.length; i++) {
            for (int j = i + 1; j < all.length; j++) {
                FieldItem first = fieldView.landmark(all[i]);
                FieldItem second = fieldView.landmark(all[j]);
                if (first.ageSeconds() < 2.5 && second.ageSeconds() < 2.5) {
                    Vector3 here = place(all[i], all[j], first.position(), second.position());
                    double weight = 1 / (1 + first.distance() + second.distance());
                    weights += weight;
                    x += weight * here.x();
                    y += weight * here.y();
                }
            }
        }
        if (weights > 0) {
            nao.say(String.format(Locale.ROOT, "at:%.2f:%.2f", x / weights, y / weights));
        }
    }

    /** Turns and moves the robot's view until the two landmarks lie where they stand. */
    private static Vector3 place(Landmark first, Landmark second, Vector3 seenFirst, Vector3 seenSecond) {
        Vector3 trueFirst = SoccerField.BEGINNER.position(first);
        Vector3 trueSecond = SoccerField.BEGINNER.position(second);
        double heading = direction(trueFirst, trueSecond) - direction(seenFirst, seenSecond);
        double middleX = (seenFirst.x() + seenSecond.x()) / 2;
        double middleY = (seenFirst.y() + seenSecond.y()) / 2;
        return new Vector3(
                (trueFirst.x() + trueSecond.x()) / 2 - middleX * Math.cos(heading) + middleY * Math.sin(heading),
                (trueFirst.y() + trueSecond.y()) / 2 - middleX * Math.sin(heading) - middleY * Math.cos(heading),
                0);
    }

    private static double direction(Vector3 from, Vector3 to) {
        return Math.atan2(to.y() - from.y(), to.x() - from.x());
    }
}
