package org.robonewbie.learning.policy;

import java.util.List;
import java.util.Random;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.agent.walk.Stance;
import org.robonewbie.agent.walk.WalkVelocity;
import org.robonewbie.learning.motion.ScriptedMotors;
import org.robonewbie.learning.motion.ScriptedRobot;
import org.robonewbie.nao.Cycle;
import org.robonewbie.nao.geometry.Angles;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.nao.math.PortableMath;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Keyframe;
import org.robonewbie.nao.motion.Motion;
import org.robonewbie.simulator.soccer.SoccerParameters;
import org.robonewbie.trial.Controller;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;

/**
 * One lesson: from the stance a robot follows velocities that change every 3 s, with noise, while a hand pushes it once per second
 * into any direction. Each 0.4 s pay 1, less the error of the velocity (1 for 0.3 m/s, 0.9 m/s of a run, or 30°/s, together 1.5 at most) and a
 * little for a torso that leans. A fall ends the lesson; it costs 4, and 1 for each 0.4 s that are lost, so it never pays.
 */
final class WalkLesson {

    private static final int COMMAND_CYCLES = 150;
    private static final int WINDOW = 20;
    private static final int CYCLES_TO_SETTLE = 60;
    private static final double DEGREES_PER_SECOND = 30;
    private static final double MOST_ERROR = 1.5;
    private static final double FOR_A_FALL = 4;

    /** What a degree by which the torso leans costs in each window. */
    static final double FOR_A_DEGREE = 0.002;

    private static final Motion STANCE =
            new Motion("stance", List.of(new Keyframe(600, Stance.POSTURE), new Keyframe(300, Stance.POSTURE)));

    private final WalkCourse course;
    private final Random random;
    private final HandPushes pushes;
    private final boolean isLong;
    private final LessonFigures figures = new LessonFigures();
    private WalkVelocity aim = WalkVelocity.ZERO;
    private WalkVelocity wanted = WalkVelocity.ZERO;

    private WalkLesson(WalkCourse course, long seed, double newtons, double longShare) {
        this.course = course;
        this.random = new Random(31 * seed + 7);
        this.pushes = new HandPushes(random, newtons);
        random.nextLong();
        isLong = random.nextDouble() < longShare;
    }

    /** A world for lessons of a standard robot, one after the other. */
    static Trial room() {
        return room(RobotType.TYPE_0);
    }

    /** A world for lessons of a robot of some build. */
    static Trial room(RobotType type) {
        Scene scene = Scene.of(RobotStart.at(0, 0).withType(type).after(STANCE))
                .withParameters(SoccerParameters.league())
                .withBall(0, -9);
        return Trial.direct(scene, 0, Controller.ofSpeeds());
    }

    /** Gives a lesson and tells what came of it. */
    static LessonFigures give(
            Trial room, WalkCourse course, PolicyWalk walk, long seed, double newtons, double longShare, int cycles) {
        ScriptedRobot student = new ScriptedMotors(walk);
        room.reset(seed, student.controller());
        return new WalkLesson(course, seed, newtons, longShare).run(room, student, cycles);
    }

    private LessonFigures run(Trial room, ScriptedRobot student, int most) {
        WorldState before = room.now();
        for (int cycle = 0; cycle < most; cycle++) {
            if (cycle == 0 || (cycle % COMMAND_CYCLES == 0 && !isLong)) {
                aim = nextAim(cycle == 0);
            }
            wanted = course.commands().onTheWay(wanted, aim);
            student.walk(wanted);
            pushes.act(room, cycle);
            WorldState now = room.step();
            if (now.robot().isFallen()) {
                figures.fall(cycle + 1, FOR_A_FALL + (most - cycle) / (double) WINDOW);
                return figures;
            }
            if ((cycle + 1) % WINDOW == 0) {
                see(before, now, cycle % COMMAND_CYCLES >= CYCLES_TO_SETTLE + WINDOW - 1);
                before = now;
            }
        }
        figures.end(most);
        return figures;
    }

    private WalkVelocity nextAim(boolean isFirst) {
        if (isLong) {
            return course.longCommand(random);
        }
        return isFirst
                ? course.commands().first(course, random)
                : course.commands().later(course, random);
    }

    /** Compares how the robot has moved with what was wanted, seen from half-way between its headings. */
    private void see(WorldState before, WorldState now, boolean settled) {
        double seconds = WINDOW * Cycle.SECONDS;
        Pose2d place = before.place();
        double turned = Angles.wrap(now.place().degrees() - place.degrees());
        Pose2d middle = new Pose2d(place.x(), place.y(), place.degrees() + turned / 2);
        double error = PortableMath.hypot(
                middle.ahead(now.robot().position()) / seconds - wanted.forward(),
                middle.left(now.robot().position()) / seconds - wanted.left());
        double turnError = Math.abs(turned / seconds - wanted.turn());
        double lost = Math.min(MOST_ERROR, error / course.toleratedMetresPerSecond() + turnError / DEGREES_PER_SECOND);
        double forADegree = settled && wanted.isZero() ? course.commands().forADegreeAtRest() : FOR_A_DEGREE;
        figures.window(1 - lost - forADegree * now.robot().tiltDegrees());
        if (settled) {
            figures.settled(error, turnError);
        }
    }
}
