package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Writes the first list of a monitor message: the environment and the state of the match, the latter only where it has changed
 * since it was last written.
 *
 * <p>Source of the format: SimSpark's {@code gamestateitem.cpp} and {@code soccerruleitem.cpp}.
 */
final class GameStateWriter {

    private final Environment environment;
    private final SexpWriter out;
    private MonitoredGame told = MonitoredGame.UNKNOWN;
    private int lastFoul;

    GameStateWriter(Environment environment, SexpWriter out) {
        this.environment = environment;
        this.out = out;
    }

    /** Writes everything; it counts as known only if all monitors receive it. */
    void writeFull(MonitoredGame state, List<Foul> fouls, boolean toAll) {
        out.text("(");
        writeEnvironment();
        writeTime(state);
        writeName("team_left", state.teamLeft());
        writeName("team_right", state.teamRight());
        writeInteger("half", state.half());
        writeInteger("score_left", state.scoreLeft());
        writeInteger("score_right", state.scoreRight());
        writePlayMode(state.playMode());
        writePassWaits(state);
        if (toAll) {
            writeNewFouls(fouls);
            told = state;
        }
        out.text(")");
    }

    /** Writes time and changes. */
    void writePartial(MonitoredGame state, List<Foul> fouls) {
        out.text("(");
        writeTime(state);
        if (!state.teamLeft().equals(told.teamLeft())) {
            writeName("team_left", state.teamLeft());
        }
        if (!state.teamRight().equals(told.teamRight())) {
            writeName("team_right", state.teamRight());
        }
        writeChange("half", told.half(), state.half());
        writeChange("score_left", told.scoreLeft(), state.scoreLeft());
        writeChange("score_right", told.scoreRight(), state.scoreRight());
        if (!state.playMode().equals(told.playMode())) {
            writePlayMode(state.playMode());
        }
        writePassWaits(state);
        writeNewFouls(fouls);
        told = state;
        out.text(")");
    }

    private void writeEnvironment() {
        for (Environment.Measure measure : environment.measures()) {
            writeNumber(measure.name(), measure.value());
        }
        out.text("(play_modes");
        for (String playMode : environment.playModes()) {
            out.text(" ").text(playMode);
        }
        out.text(")");
    }

    private void writeTime(MonitoredGame state) {
        writeNumber("time", state.timeSeconds());
    }

    private void writeName(String name, Optional<String> value) {
        value.ifPresent(word -> out.text("(").text(name).text(" ").text(word).text(")"));
    }

    private void writeNumber(String name, double value) {
        out.text("(").text(name).text(" ").general(value).text(")");
    }

    private void writeInteger(String name, int value) {
        out.text("(").text(name).text(" ").integer(value).text(")");
    }

    private void writeChange(String name, int before, int now) {
        if (before != now) {
            writeInteger(name, now);
        }
    }

    private void writePlayMode(Optional<PlayMode> playMode) {
        playMode.map(mode -> environment.playModes().indexOf(mode.simSparkName()))
                .filter(index -> index >= 0)
                .ifPresent(index -> writeInteger("play_mode", index));
    }

    private void writePassWaits(MonitoredGame state) {
        if (state.passWaitLeftSeconds() > 0) {
            writeNumber("pass_mode_score_wait_left", state.passWaitLeftSeconds());
        }
        if (state.passWaitRightSeconds() > 0) {
            writeNumber("pass_mode_score_wait_right", state.passWaitRightSeconds());
        }
    }

    private void writeNewFouls(List<Foul> fouls) {
        for (Foul foul : fouls) {
            if (foul.index() > lastFoul) {
                lastFoul = foul.index();
                writeFoul(foul);
            }
        }
    }

    private void writeFoul(Foul foul) {
        out.text("(foul ").integer(foul.index());
        out.text(" ").integer(foul.type().simSparkNumber());
        out.text(" ").integer(1 + foul.player().side().ordinal());
        out.text(" ").integer(foul.player().number()).text(")");
    }
}
