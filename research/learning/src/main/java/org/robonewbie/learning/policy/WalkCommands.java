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
            return slowerOrFirst(course, random);
        }

        @Override
        WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted) {
            double least = now.forward() - SLOWING * Cycle.SECONDS;
            return wanted.forward() >= least ? wanted : new WalkVelocity(least, wanted.left(), wanted.turn());
        }
    },

    /** Ahead, in half of the cases straight, else in a bend; later also slower or a stop, as suddenly as a player changes its mind. */
    BENDS {

        @Override
        WalkVelocity first(WalkCourse course, Random random) {
            double forward = ahead(course, random.nextDouble());
            double kind = random.nextDouble();
            double turn = 2 * random.nextDouble() - 1;
            if (kind < 0.5) {
                return new WalkVelocity(forward, 0, 0);
            }
            return new WalkVelocity(forward, 0, turn * (kind < 0.8 ? STEERING : BEND));
        }

        @Override
        WalkVelocity later(WalkCourse course, Random random) {
            return slowerOrFirst(course, random);
        }

        @Override
        WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted) {
            return wanted;
        }

        @Override
        double forADegreeAtRest() {
            return FOR_A_DEGREE_OF_ROCKING;
        }
    };

    private static final double BEND_DEGREES_PER_SECOND = 20;

    /** How fast who keeps to a line turns at most, and how fast who bends; degrees per second. */
    private static final double STEERING = 15;

    private static final double BEND = 45;

    private static final double FOR_A_DEGREE_OF_ROCKING = 0.1;

    /** How fast a run is slowed down, metres per second in a second. */
    private static final double SLOWING = 0.6;

    /** Draws the first velocity of a lesson. */
    abstract WalkVelocity first(WalkCourse course, Random random);

    /** Draws a velocity for a robot that walks. */
    abstract WalkVelocity later(WalkCourse course, Random random);

    /** What is commanded in the next cycle on the way to a velocity. */
    abstract WalkVelocity onTheWay(WalkVelocity now, WalkVelocity wanted);

    /** What a degree by which the torso leans costs in each window of a robot that is to stand. */
    double forADegreeAtRest() {
        return WalkLesson.FOR_A_DEGREE;
    }

    /** Draws a stop, a velocity slower than usual, or one as at first. */
    WalkVelocity slowerOrFirst(WalkCourse course, Random random) {
        double kind = random.nextDouble();
        if (kind < course.slowShare() / 2) {
            return WalkVelocity.ZERO;
        }
        return kind < course.slowShare()
                ? new WalkVelocity(course.most().forward() * course.leastAhead() * random.nextDouble(), 0, 0)
                : first(course, random);
    }

    private static double ahead(WalkCourse course, double share) {
        return course.most().forward() * (course.leastAhead() + (1 - course.leastAhead()) * share);
    }
}
