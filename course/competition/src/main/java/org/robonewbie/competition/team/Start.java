package org.robonewbie.competition.team;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.robonewbie.competition.contest.Role;
import org.robonewbie.competition.contest.StartPlace;

/**
 * Start arguments of a program.
 *
 * @param port TCP port of the simulator on this computer
 * @param team name of the program's team
 * @param role role of the program
 * @param places start poses of the program's robots; more than one only if one process runs all players
 */
public record Start(int port, String team, Role role, List<StartPlace> places) {

    static final String HOST = "127.0.0.1";

    /** Makes the list unmodifiable. */
    public Start {
        places = List.copyOf(places);
    }

    Start withPort(int other) {
        return new Start(other, team, role, places);
    }

    /** Returns the arguments in the format of RoboNewbie's agents. */
    List<String> options(boolean together) {
        List<String> basic = List.of("--host", HOST, "--port", String.valueOf(port), "--team", team);
        List<String> own = together
                ? List.of(String.valueOf(places.size()))
                : List.of(
                        "--number",
                        String.valueOf(places.get(0).number()),
                        "--pose",
                        places.get(0).pose());
        return together ? concat(own, basic) : concat(basic, own);
    }

    /** Replaces the placeholders in a command. Appends the options if there is no placeholder for the port. */
    List<String> fill(List<String> words, boolean together) {
        boolean open = words.stream().anyMatch(word -> word.contains("{port}"));
        return open ? words.stream().map(this::fill).toList() : concat(words, options(together));
    }

    private String fill(String word) {
        StartPlace first = places.get(0);
        Map<String, String> values = Map.of(
                "{host}", HOST,
                "{port}", String.valueOf(port),
                "{team}", team,
                "{number}", String.valueOf(first.number()),
                "{pose}", first.pose(),
                "{players}", String.valueOf(places.size()),
                "{role}", role.key());
        String filled = word;
        for (Map.Entry<String, String> value : values.entrySet()) {
            filled = filled.replace(value.getKey(), value.getValue());
        }
        return filled;
    }

    private static List<String> concat(List<String> one, List<String> other) {
        return Stream.concat(one.stream(), other.stream()).toList();
    }
}
