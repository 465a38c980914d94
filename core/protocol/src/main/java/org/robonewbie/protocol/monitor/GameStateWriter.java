package org.robonewbie.protocol.monitor;

import java.util.List;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.protocol.sexp.SexpWriter;

/**
 * Writes the first list of a monitor message: the environment and the state of the match. Partial messages contain only what
 * has changed since the last message that was sent to all monitors.
 *
 * <p>Source of the format: SimSpark's {@code gamestateitem.cpp} and {@code soccerruleitem.cpp}.
 */
final class GameStateWriter {

    private final Environment environment;
    private final SexpWriter out;
    private MonitoredGame lastSent = MonitoredGame.UNKNOWN;
    private int lastFoul;

    GameStateWriter(Environment environment, SexpWriter out) {
        this.environment = environment;
        this.out = out;
    }

    /**
     * Writes the environment and the full state. If {@code toAll} is true, later partial messages are relative to this
     * one.
     */
    void writeFull(MonitoredGame state, List<Foul> fouls, boolean toAll) {
        out.text("(");
        writeEnvironment();
        writeState(state, true);
        if (toAll) {
            writeNewFouls(fouls);
            lastSent = state;
        }
        out.text(")");
    }

    /** Writes the time and the parts of the state that have changed. */
    void writePartial(MonitoredGame state, List<Foul> fouls) {
        out.text("(");
        writeState(state, false);
        writeNewFouls(fouls);
        lastSent = state;
        out.text(")");
    }

    private void writeState(MonitoredGame state, boolean full) {
        writeNumber("time", state.timeSeconds());
        if (full || !state.teamLeft().equals(lastSent.teamLeft())) {
            writeName("team_left", state.teamLeft());
        }
        if (full || !state.teamRight().equals(lastSent.teamRight())) {
            writeName("team_right", state.teamRight());
        }
        if (full || state.half() != lastSent.half()) {
            writeInteger("half", state.half());
        }
        if (full || state.scoreLeft() != lastSent.scoreLeft()) {
            writeInteger("score_left", state.scoreLeft());
        }
        if (full || state.scoreRight() != lastSent.scoreRight()) {
            writeInteger("score_right", state.scoreRight());
        }
        if (full || !state.playMode().equals(lastSent.playMode())) {
            writePlayMode(state.playMode());
        }
        if (state.passWaitLeftSeconds() > 0) {
            writeNumber("pass_mode_score_wait_left", state.passWaitLeftSeconds());
        }
        if (state.passWaitRightSeconds() > 0) {
            writeNumber("pass_mode_score_wait_right", state.passWaitRightSeconds());
        }
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

    private void writeName(String name, Optional<String> value) {
        value.ifPresent(word -> out.text("(").text(name).text(" ").text(word).text(")"));
    }

    private void writeNumber(String name, double value) {
        out.text("(").text(name).text(" ").general(value).text(")");
    }

    private void writeInteger(String name, int value) {
        out.text("(").text(name).text(" ").integer(value).text(")");
    }

    private void writePlayMode(Optional<PlayMode> playMode) {
        playMode.map(mode -> environment.playModes().indexOf(mode.simSparkName()))
                .filter(index -> index >= 0)
                .ifPresent(index -> writeInteger("play_mode", index));
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
