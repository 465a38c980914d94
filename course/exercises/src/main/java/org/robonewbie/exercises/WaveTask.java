package org.robonewbie.exercises;

import java.util.List;
import java.util.Locale;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.WorldState;

/** Task: wave with either hand above the head. */
final class WaveTask implements Task {

    private static final double WAVED_METRES = 0.3;
    private static final double ENOUGH_METRES = 1.2;

    private final List<Hand> hands = List.of(new Hand("llowerarm"), new Hand("rlowerarm"));

    /** Height and path of one hand relative to the head. */
    private static final class Hand {
        private final String link;
        private Vector3 before = Vector3.ZERO;
        private double waved;
        private double highest = Double.NEGATIVE_INFINITY;

        Hand(String link) {
            this.link = link;
        }

        void see(BodyPoses robot) {
            Vector3 now = robot.link(link).position().minus(robot.camera().position());
            highest = Math.max(highest, now.z());
            if (now.z() > 0 && before.z() > 0) {
                waved += now.distanceTo(before);
            }
            before = now;
        }
    }

    @Override
    public Scene scene(RandomSource random) {
        return Scene.of(RobotStart.at(-1, 0).after("stand"));
    }

    @Override
    public void see(WorldState state) {
        BodyPoses robot = state.robot().limbs();
        hands.forEach(hand -> hand.see(robot));
    }

    @Override
    public boolean isDecided() {
        return hasWaved(ENOUGH_METRES);
    }

    private boolean hasWaved(double metres) {
        return hands.stream().anyMatch(hand -> hand.waved >= metres);
    }

    @Override
    public Score score() {
        if (hasWaved(WAVED_METRES)) {
            return Score.passed("the robot waved");
        }
        double highest = hands.stream().mapToDouble(hand -> hand.highest).max().orElse(0);
        return highest > 0
                ? Score.failed(5, "the hand was above the head", "Keep the hand moving up there.")
                : Score.failed(
                        0,
                        String.format(Locale.ROOT, "the hand stayed %.0f cm below the head", -100 * highest),
                        "A larger angle raises the arm higher.");
    }
}
