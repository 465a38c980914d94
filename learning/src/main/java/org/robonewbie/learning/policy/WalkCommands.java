package org.robonewbie.learning.policy;

import java.util.Random;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.nao.Cycle;

/** What kinds of velocities are commanded in lessons. */
public enum WalkCommands {
    /** Ahead, back, aside, around, nothing, or all at once within what is possible. */
    ANYWHERE {

        @Override
        WalkVelocity first(WalkCourse course, Random random) {
            return later(course, random);
        }

        @Override
        WalkVelocity later(WalkCourse course, Random random) {
            WalkVelocity most = course.most();
            double kind = random.nextDouble();
            double forward = random.nextDouble();
            double left = most.left() * (2 * random.nextDouble() - 1);
            double turn = most.turn() * (2 * random.nextDouble() - 1);
            if (kind < 0.35) {
                return new WalkVelocity(ahead(course, forward), 0, 0);
            } else if (kind < 0.5) {
                return new WalkVelocity(-course.backward() * forward, 0, 0);
            } else if (kind < 0.62) {
                return new WalkVelocity(0, left, 0);
            } else if (kind < 0.74) {
                return new WalkVelocity(0, 0, turn);
            } else if (kind < 0.78) {
                return WalkVelocity.ZERO;
            }
            double any = -course.backward() + (most.forward() + course.backward()) * forward;
            return new WalkVelocity(any, left, turn).within(most, course.backward());
        }

        @Override
        WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted) {
            return wanted;
        }
    },

    /** Ahead, in three of five cases straight; later also slower, down to a stop, but never suddenly. */
    AHEAD {

        @Override
        WalkVelocity first(WalkCourse course, Random random) {
            double forward = ahead(course, random.nextDouble());
            double turn = BEND_DEGREES_PER_SECOND * (2 * random.nextDouble() - 1);
            return new WalkVelocity(forward, 0, random.nextDouble() < 0.6 ? 0 : turn);
        }

        @Override
        WalkVelocity later(WalkCourse course, Random random) {
            double kind = random.nextDouble();
            if (kind < course.slowShare() / 2) {
                return WalkVelocity.ZERO;
            }
            return kind < course.slowShare()
                    ? new WalkVelocity(course.most().forward() * course.leastAhead() * random.nextDouble(), 0, 0)
                    : first(course, random);
        }

        @Override
        WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted) {
            double least = now.forward() - SLOWING * Cycle.SECONDS;
            return wanted.forward() >= least ? wanted : new WalkVelocity(least, wanted.left(), wanted.turn());
        }
    };

    private static final double BEND_DEGREES_PER_SECOND = 20;

    /** How fast a run is slowed down, metres per second in a second. */
    private static final double SLOWING = 0.6;

    /** Draws the first velocity of a lesson. */
    abstract WalkVelocity first(WalkCourse course, Random random);

    /** Draws a velocity for a robot that walks. */
    abstract WalkVelocity later(WalkCourse course, Random random);

    /** What is commanded in the next cycle on the way to a velocity. */
    abstract WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted);

    private static double ahead(WalkCourse course, double share) {
        return course.most().forward() * (course.leastAhead() + (1 - course.leastAhead()) * share);
    }
}
