package org.robonewbie.protocol.monitor;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.protocol.order.PlayerNumber;
import org.robonewbie.protocol.sexp.SexpReader;
import org.robonewbie.protocol.sexp.Token;

/** Parses the first list of a monitor message: the environment and the state of the match. */
final class GameStateReader {

    private final SexpReader in;
    private final Map<String, Double> measures = new LinkedHashMap<>();
    private List<String> playModes = List.of();
    private double time;
    private Optional<String> teamLeft = Optional.empty();
    private Optional<String> teamRight = Optional.empty();
    private int half = 1;
    private int scoreLeft;
    private int scoreRight;
    private Optional<PlayMode> playMode = Optional.empty();
    private double passWaitLeft;
    private double passWaitRight;
    private final List<Foul> fouls = new ArrayList<>();

    GameStateReader(SexpReader in) {
        this.in = in;
    }

    Environment environment() {
        List<Environment.Measure> list = measures.entrySet().stream()
                .map(entry -> new Environment.Measure(entry.getKey(), entry.getValue()))
                .toList();
        return new Environment(list, playModes);
    }

    MonitoredGame gameState() {
        return new MonitoredGame(
                time, teamLeft, teamRight, half, scoreLeft, scoreRight, playMode, passWaitLeft, passWaitRight);
    }

    /** Returns the fouls in the last message. */
    List<Foul> fouls() {
        return List.copyOf(fouls);
    }

    /** Parses the list after its opening parenthesis. */
    void read() throws MalformedMessageException {
        fouls.clear();
        passWaitLeft = 0;
        passWaitRight = 0;
        int inside = in.depth();
        while (in.nextList(inside)) {
            String name = in.text();
            readEntry(name, readWords());
        }
        SceneReader.require(in.token() == Token.CLOSE);
    }

    private void readEntry(String name, List<Word> words) {
        if (words.isEmpty()) {
            return;
        }
        Word first = words.get(0);
        switch (name) {
            case "time" -> time = first.number();
            case "team_left" -> teamLeft = Optional.of(first.text());
            case "team_right" -> teamRight = Optional.of(first.text());
            case "half" -> half = (int) first.number();
            case "score_left" -> scoreLeft = (int) first.number();
            case "score_right" -> scoreRight = (int) first.number();
            case "play_modes" -> playModes = words.stream().map(Word::text).toList();
            case "play_mode" -> playMode = playMode((int) first.number());
            case "pass_mode_score_wait_left" -> passWaitLeft = first.number();
            case "pass_mode_score_wait_right" -> passWaitRight = first.number();
            case "foul" -> readFoul(words);
            default -> readMeasure(name, first);
        }
    }

    private void readMeasure(String name, Word value) {
        if (value.isNumber()) {
            measures.put(name, value.number());
        }
    }

    private Optional<PlayMode> playMode(int index) {
        return index >= 0 && index < playModes.size()
                ? PlayMode.ofSimSparkName(playModes.get(index))
                : Optional.empty();
    }

    /** Reads one foul. Servers from version 0.7 on send index, type, team and shirt number; older ones omit the index. */
    private void readFoul(List<Word> words) {
        int start = words.size() == 3 ? -1 : 0;
        if (words.size() < 3) {
            return;
        }
        int index = start < 0 ? 0 : (int) words.get(0).number();
        int side = (int) words.get(start + 2).number();
        int number = (int) words.get(start + 3).number();
        FoulType.ofSimSparkNumber((int) words.get(start + 1).number())
                .filter(type -> side == 1 || side == 2)
                .ifPresent(type -> fouls.add(
                        new Foul(index, type, new PlayerNumber(side == 1 ? TeamSide.LEFT : TeamSide.RIGHT, number))));
    }

    private List<Word> readWords() {
        List<Word> words = new ArrayList<>();
        while (in.next() == Token.ATOM) {
            words.add(new Word(in.text(), in.number(), in.isNumber()));
        }
        return words;
    }

    private record Word(String text, double number, boolean isNumber) {}
}
