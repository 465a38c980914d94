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

/**
 * Parses the state of the match ({@code gs}) and its constants ({@code ge}) of an RSMP message. Entries that a newer server adds are
 * skipped.
 */
final class RsmpGameReader {

    /** Names that the server sends for teams that have not joined yet. */
    private static final List<String> NO_TEAM = List.of("<LEFT>", "<RIGHT>");

    private static final int MAX_MEASURES = 200;
    private static final int MAX_FOULS = 100;
    private static final int MAX_GOALS = 255;
    private static final int MAX_NUMBER = 1000;

    private final SexpReader in;
    private final RsmpWords words;
    private final List<Foul> fouls = new ArrayList<>();
    private Environment environment = Environment.UNKNOWN;
    private double time;
    private Optional<String> teamLeft = Optional.empty();
    private Optional<String> teamRight = Optional.empty();
    private int half = 1;
    private int scoreLeft;
    private int scoreRight;
    private int playMode = -1;
    private int foulCount;

    RsmpGameReader(SexpReader in, RsmpWords words) {
        this.in = in;
        this.words = words;
    }

    /** Forgets the fouls of the last message. */
    void start() {
        fouls.clear();
    }

    Environment environment() {
        return environment;
    }

    /** Returns the state; the play mode is empty if no full message has listed the play modes yet, or if its name is unknown. */
    MonitoredGame gameState() {
        List<String> modes = environment.playModes();
        Optional<PlayMode> mode =
                playMode >= 0 && playMode < modes.size() ? PlayMode.ofName(modes.get(playMode)) : Optional.empty();
        return new MonitoredGame(time, teamLeft, teamRight, half, scoreLeft, scoreRight, mode, 0, 0);
    }

    List<Foul> fouls() {
        return List.copyOf(fouls);
    }

    /** Parses the entries of {@code gs} up to the end of the part. */
    void readState() throws MalformedMessageException {
        int inside = in.depth();
        while (nextEntry()) {
            switch (words.text()) {
                case "time" -> time = words.number("the time");
                case "half" -> half = words.integer("the half", 1, 2);
                case "score_left" -> scoreLeft = words.integer("a score", 0, MAX_GOALS);
                case "score_right" -> scoreRight = words.integer("a score", 0, MAX_GOALS);
                case "play_mode" -> playMode = words.integer("the index of a play mode", 0, MAX_NUMBER);
                case "team_left" -> teamLeft = team();
                case "team_right" -> teamRight = team();
                case "foul" -> readFoul();
                default -> {}
            }
            in.skipTo(inside);
        }
    }

    /** Parses the entries of {@code ge} up to the end of the part. */
    void readEnvironment() throws MalformedMessageException {
        Map<String, Double> measures = new LinkedHashMap<>();
        List<String> playModes = List.of();
        while (nextEntry()) {
            if (in.atomIs("play_modes")) {
                List<String> names = words.list();
                playModes = names.subList(1, names.size());
                continue;
            }
            String name = words.text();
            measures.put(name, words.number("\"" + name + "\""));
            words.close();
            if (measures.size() > MAX_MEASURES) {
                throw new MalformedMessageException("\"ge\" has more than " + MAX_MEASURES + " entries");
            }
        }
        List<Environment.Measure> list = measures.entrySet().stream()
                .map(entry -> new Environment.Measure(entry.getKey(), entry.getValue()))
                .toList();
        environment = new Environment(list, playModes);
    }

    private Optional<String> team() throws MalformedMessageException {
        String name = words.word("the name of a team");
        return NO_TEAM.contains(name) ? Optional.empty() : Optional.of(name);
    }

    private void readFoul() throws MalformedMessageException {
        int type = words.integer("the type of a foul", 0, MAX_NUMBER);
        TeamSide side = words.integer("the side of a foul", 1, 2) == 1 ? TeamSide.LEFT : TeamSide.RIGHT;
        PlayerNumber player = new PlayerNumber(side, words.integer("a player's number", 0, MAX_NUMBER));
        if (fouls.size() < MAX_FOULS) {
            FoulType.ofSimSparkNumber(type).ifPresent(known -> fouls.add(new Foul(++foulCount, known, player)));
        }
    }

    /** Advances to the name of the next entry; returns false at the end of the part. */
    private boolean nextEntry() throws MalformedMessageException {
        Token token = in.next();
        if (token == Token.CLOSE) {
            return false;
        }
        if (token != Token.OPEN || in.next() != Token.ATOM) {
            throw words.unexpected("an entry \"(NAME …)\" or \")\"");
        }
        return true;
    }
}
