package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** All exercises in the order of the course. */
public final class Exercises {

    private static final List<Exercise> ALL = List.of(
            new Exercise(
                    1,
                    "raise-arms",
                    "RaiseArms",
                    "Raise both arms",
                    15,
                    "Raise the left arm to 60° and the right arm to 45°.",
                    4,
                    RaiseArmsTask::new),
            new Exercise(
                    2,
                    "stop-at-30",
                    "StopAt30",
                    "Stop at 30 degrees",
                    30,
                    "Stop the left shoulder at 30° ± 1°, wherever it starts.",
                    5,
                    StopAt30Task::new),
            new Exercise(
                    3,
                    "arm-by-side",
                    "ArmBySide",
                    "The arm on the side of the other robot",
                    30,
                    "Raise the arm on the side where you see another robot; if you see none, keep both arms down.",
                    18,
                    ArmBySideTask::new),
            new Exercise(
                    4,
                    "find-the-ball",
                    "FindTheBall",
                    "Find the ball",
                    45,
                    "Look for the ball and face it within 8 s.",
                    9,
                    FindTheBallTask::new),
            new Exercise(
                    5,
                    "ball-direction",
                    "BallDirection",
                    "How accurate is the view?",
                    60,
                    "Say the ball's direction to within 0.5°, however the head and body lean.",
                    12,
                    BallDirectionTask::new),
            new Exercise(
                    6,
                    "smooth-motion",
                    "SmoothMotion",
                    "Motions without jerks",
                    60,
                    "Play a motion through all its keyframes without jerks.",
                    4,
                    SmoothMotionTask::new),
            new Exercise(
                    7,
                    "dance",
                    "MyDance",
                    "Dance",
                    60,
                    "Dance with at least three limbs to the beat of the ball, on the spot.",
                    15,
                    DanceTask::new),
            new Exercise(
                    8,
                    "get-up",
                    "GetUp",
                    "Get up",
                    30,
                    "Say whether you are on your back or your front, get up within 12 s, and say"
                            + " when you are standing.",
                    13,
                    GetUpTask::new),
            new Exercise(
                    9,
                    "two-behaviours",
                    "TwoBehaviours",
                    "Two behaviours at once",
                    45,
                    "Follow the ball with the head and swing the arm at the same time.",
                    12,
                    TwoBehavioursTask::new),
            new Exercise(
                    10,
                    "go-to-ball",
                    "GoToTheBall",
                    "Think in steps",
                    60,
                    "Walk to the ball, stop in front of it without touching it, and raise the left arm.",
                    45,
                    GoToTheBallTask::new),
            new Exercise(
                    11,
                    "around-the-ball",
                    "AroundTheBall",
                    "Once around the ball",
                    90,
                    "Walk once around the ball without touching it, within 0.9 m.",
                    90,
                    AroundTheBallTask::new),
            new Exercise(
                    12,
                    "kick",
                    "Kick",
                    "A kick of your own",
                    120,
                    "Kick the ball 2 m or more with a kick of your own, and stay on your feet.",
                    12,
                    KickTask::new),
            new Exercise(
                    13,
                    "where-am-i",
                    "WhereAmI",
                    "Where am I?",
                    120,
                    "Find out where you are on the pitch, to within 30 cm.",
                    24,
                    WhereAmITask::new),
            new Exercise(
                    14,
                    "goalkeeper",
                    "Goalkeeper",
                    "Goalkeeper",
                    90,
                    "Keep two shots out of the goal, one on each side.",
                    26,
                    GoalkeeperTask::new),
            new Exercise(
                    15,
                    "passing",
                    "Passing",
                    "Pass and receive",
                    90,
                    "Play the ball to a teammate, who comes to meet it.",
                    20,
                    PassingTask::new),
            new Exercise(
                    16,
                    "faster-walk",
                    "FasterWalk",
                    "Learn to walk faster",
                    120,
                    "Learn to walk 6.3 m in 10 s, straight and without falling.",
                    10,
                    FasterWalkTask::new),
            new Exercise(
                    17,
                    "score-a-goal",
                    "ScoreAGoal",
                    "Score a goal",
                    240,
                    "Score a goal past a wall of robots within 3 minutes.",
                    180,
                    ScoreAGoalTask::new),
            new Exercise(
                    18,
                    "unseen-ball",
                    "UnseenBall",
                    "Keep in mind what you do not see",
                    60,
                    "Turn away from the ball and keep saying where it is.",
                    14,
                    UnseenBallTask::new),
            new Exercise(
                    19,
                    "rolling-ball",
                    "RollingBall",
                    "A model of the ball",
                    90,
                    "Say where the ball is after it has rolled out of sight.",
                    15,
                    RollingBallTask::new),
            new Exercise(
                    20,
                    "team-eyes",
                    "TeamEyes",
                    "Eyes of a team",
                    45,
                    "Raise the arm on the side of a ball that only your teammate sees.",
                    24,
                    TeamEyesTask::new),
            new Exercise(
                    21,
                    "obstacle-course",
                    "ObstacleCourse",
                    "Round the obstacles",
                    60,
                    "Walk through two gates to the ball and touch nothing.",
                    75,
                    ObstacleCourseTask::new),
            new Exercise(
                    22,
                    "hill",
                    "Hill",
                    "Up the hill",
                    60,
                    "Walk up a slope and stand still at the top, in front of the steps.",
                    45,
                    HillTask::new),
            new Exercise(
                    23,
                    "push-together",
                    "PushTogether",
                    "Push together",
                    60,
                    "With two robots, push a wide box over a line without turning it.",
                    45,
                    PushTogetherTask::new),
            new Exercise(
                    24,
                    "better-pass",
                    "BetterPass",
                    "A better pass",
                    90,
                    "Pass to the teammate with a clear passing lane, twice.",
                    50,
                    BetterPassTask::new),
            new Exercise(
                    25,
                    "formation",
                    "MyFormation",
                    "A better formation",
                    120,
                    "Three players: one at the ball, one in front of the goal, one open for a pass.",
                    48,
                    FormationTask::new),
            new Exercise(
                    26,
                    "dribble-past",
                    "DribblePast",
                    "Past an opponent",
                    90,
                    "Dribble past the left side of an opponent that blocks the straight path," + " without pushing it.",
                    75,
                    DribblePastTask::new));

    private Exercises() {}

    /** {@return all exercises, in the order of the course} */
    public static List<Exercise> all() {
        return ALL;
    }

    /**
     * Finds an exercise.
     *
     * @param name name, number, or both, such as {@code kick}, {@code 12} or {@code 12-kick}
     * @return the exercise; empty if there is no such exercise
     */
    public static Optional<Exercise> find(String name) {
        String wanted = name.toLowerCase(Locale.ROOT);
        return ALL.stream()
                .filter(exercise -> wanted.equals(exercise.name())
                        || wanted.equals(exercise.fullName())
                        || wanted.equals(Integer.toString(exercise.number()))
                        || wanted.equalsIgnoreCase(exercise.className()))
                .findFirst();
    }
}
