package org.robonewbie.workshop.sparring;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.robonewbie.agent.Agent;
import org.robonewbie.team.Agent_Team;

/** A team of the sparring league. */
enum SparringTeam {
    /** The example team as it is. */
    TEAM,
    /** The example team at the commit of {@link FrozenTeam}. */
    BEFORE,
    /** Players that kick the ball as soon as they reach it. */
    KICKERS,
    /** Three players dribble. */
    PACK,
    /** All players defend. */
    WALL,
    /** No opponents: the other team plays alone. */
    NOBODY;

    /** Returns the team with a name on the command line. */
    static SparringTeam of(String name) {
        return Arrays.stream(values())
                .filter(team -> team.label().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("There is no team \"" + name + "\". Use "
                        + Arrays.stream(values()).map(SparringTeam::label).collect(Collectors.joining(", ")) + "."));
    }

    /** Returns the name on the command line. */
    String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Returns whether the team needs the classes of {@link FrozenTeam}. */
    boolean isFrozen() {
        return this != TEAM && this != NOBODY;
    }

    /** Creates a player. */
    Agent player(int number, Supplier<FrozenTeam> frozen) {
        return switch (this) {
            case TEAM -> new Agent_Team(number);
            case BEFORE -> frozen.get().player(number);
            case KICKERS -> frozen.get().partner(number, SparringPlayer.Idea.KICKS_AT_ONCE);
            case PACK -> frozen.get().partner(number, SparringPlayer.Idea.DRIBBLES_IN_A_PACK);
            case WALL -> frozen.get().partner(number, SparringPlayer.Idea.DEFENDS);
            case NOBODY -> throw new IllegalStateException("This team has no players.");
        };
    }
}
