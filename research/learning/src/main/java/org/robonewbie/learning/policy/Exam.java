package org.robonewbie.learning.policy;

import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.robonewbie.agent.policy.Policy;
import org.robonewbie.agent.walk.PolicyWalk;
import org.robonewbie.nao.Cycle;
import org.robonewbie.trial.Trial;

/**
 * Examines what was learned, with seeds that no training has.
 *
 * <pre>{@code
 * LessonFigures figures = Exam.of(course, plan, 20, PolicyFile.shipped("stand"));
 * }</pre>
 */
public final class Exam {

    private Exam() {}

    /**
     * Gives lessons to a learner.
     *
     * @param course what was learned
     * @param plan what the lessons are like, and how many are given at the same time
     * @param lessons how many
     * @param policy what the learner knows
     * @return what came of them
     * @throws IllegalArgumentException if the policy was learned for something else
     */
    public static LessonFigures of(Course course, TrainingPlan plan, int lessons, Policy policy) {
        LessonFigures all = new LessonFigures();
        try (LessonRooms<Classroom> rooms = PolicyTraining.rooms(course, plan)) {
            rooms.give(lessons(lessons, seed -> room -> room.examine(seed, policy)))
                    .forEach(all::add);
        }
        return all;
    }

    /**
     * Lets a walk follow velocities that change every 3 s.
     *
     * @param course what is commanded
     * @param walk the walk
     * @param lessons how many
     * @param seconds length of each
     * @param newtons strength of the hardest pushes
     * @param threads how many at the same time; the result does not depend on it
     * @return how it did
     */
    public static LessonFigures walk(
            WalkCourse course, PolicyWalk walk, int lessons, double seconds, double newtons, int threads) {
        int cycles = (int) Math.round(seconds / Cycle.SECONDS);
        LessonFigures all = new LessonFigures();
        try (LessonRooms<Trial> rooms = walkRooms(threads)) {
            rooms.give(lessons(lessons, seed -> room -> WalkLesson.give(room, course, walk, seed, newtons, 0, cycles)))
                    .forEach(all::add);
        }
        return all;
    }

    /**
     * Lets a walk dash straight ahead with its largest speed, from the stance.
     *
     * @param walk the walk
     * @param metres how far
     * @param newtons strength of the hardest pushes
     * @param times how often, each time with another seed
     * @param threads how many at the same time; the result does not depend on it
     * @return the dashes
     */
    public static List<WalkDash> dash(PolicyWalk walk, double metres, double newtons, int times, int threads) {
        try (LessonRooms<Trial> rooms = walkRooms(threads)) {
            return rooms.give(lessons(times, seed -> room -> WalkDash.run(room, walk, seed, newtons, metres)));
        }
    }

    private static LessonRooms<Trial> walkRooms(int threads) {
        return new LessonRooms<>(threads, WalkLesson::room, Trial::close);
    }

    private static <R, T> List<Function<R, T>> lessons(int count, Function<Long, Function<R, T>> ofSeed) {
        return IntStream.range(0, count).mapToObj(i -> ofSeed.apply(-1L - i)).toList();
    }
}
