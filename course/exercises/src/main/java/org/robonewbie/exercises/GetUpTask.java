package org.robonewbie.exercises;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.robonewbie.nao.geometry.Pose2d;
import org.robonewbie.trial.RandomSource;
import org.robonewbie.trial.RobotStart;
import org.robonewbie.trial.Scene;
import org.robonewbie.trial.Trial;
import org.robonewbie.trial.WorldState;
import org.robonewbie.trial.measure.SustainedCondition;

/**
 * Task: report whether the robot is lying on its back or its front, get up, and report that it is standing. For odd
 * seeds, it lies on its back; for even seeds, on its front.
 */
final class GetUpTask implements Task {

    private static final double HELD_SECONDS = 1;
    private static final double LIMIT_SECONDS = 12;
    private static final double QUICK_SECONDS = 7;
    private static final String UP = "up";
    private static final Set<String> WORDS = Set.of("back", "front", "left", "right", UP);

    private final SustainedCondition up =
            new SustainedCondition(HELD_SECONDS, state -> state.robot().isStanding());
    private boolean onBack;
    private Optional<String> said = Optional.empty();
    private Optional<String> firstWord = Optional.empty();
    private boolean saidUp;
    private boolean saidUpTooEarly;

    @Override
    public Scene scene(RandomSource random) {
        onBack = random.isSeedOdd();
        return Scene.of(RobotStart.at(new Pose2d(-1, 0, random.between(-180, 180)))
                .after("stand", onBack ? "fall-back" : "fall-forward"));
    }

    @Override
    public void act(Trial trial) {
        said = trial.said(0).filter(WORDS::contains);
    }

    @Override
    public void see(WorldState state) {
        up.see(state);
        if (said.isEmpty()) {
            return;
        }
        if (said.get().equals(UP)) {
            saidUp = true;
            saidUpTooEarly |= !state.robot().isStanding();
        } else if (firstWord.isEmpty()) {
            firstWord = said;
        }
    }

    @Override
    public boolean isDecided() {
        return up.isDecided() && saidUp;
    }

    @Override
    public Score score() {
        String lying = onBack ? "back" : "front";
        double upSeconds = up.value();
        boolean stood = up.isDecided() && upSeconds <= LIMIT_SECONDS;
        String finding = String.format(
                Locale.ROOT,
                "lay on its %s and said %s; %s",
                lying,
                firstWord.map(word -> '"' + word + '"').orElse("nothing"),
                stood ? String.format(Locale.ROOT, "stood after %.1f s", upSeconds) : "did not get up");
        if (!firstWord.equals(Optional.of(lying))) {
            return Score.failed(
                    stood ? 3 : 0,
                    finding,
                    "Use nao.getBodyPosition() to find out whether the robot is on its back or its front, and"
                            + " announce it: nao.say(\"back\") or nao.say(\"front\").");
        }
        if (!stood) {
            return Score.failed(4, finding, "Each lying position needs its own motion.");
        }
        return saidUp && !saidUpTooEarly
                ? Score.passed((int) Math.round(10 - Math.max(0, upSeconds - QUICK_SECONDS)), finding, "")
                : Score.failed(
                        6,
                        finding + (saidUp ? ", but said \"up\" while it was not standing" : ", but did not say \"up\""),
                        "Call nao.say(\"up\") when the sensors show that the robot is standing, not before.");
    }
}
