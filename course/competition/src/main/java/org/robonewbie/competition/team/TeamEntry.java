package org.robonewbie.competition.team;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.competition.contest.Role;

/**
 * A team's entry in a contest.
 *
 * @param name name of the team, at most 20 ASCII letters, digits and underscores; the title may contain letters of any
 *     language
 * @param program the team's program, given as a folder, a jar, a Java file, a class name, or a command
 * @param settings the team's settings by name; see {@link TeamList}
 */
public record TeamEntry(String name, String program, Map<String, String> settings) {

    /** Makes the map unmodifiable. */
    public TeamEntry {
        settings = Map.copyOf(settings);
    }

    /** {@return the team's title, or its name if it has none} */
    public String title() {
        return settings.getOrDefault(TeamList.TITLE, name);
    }

    /** {@return the team's members as written in the list; empty if none are listed} */
    public String members() {
        return settings.getOrDefault(TeamList.MEMBERS, "");
    }

    /** {@return the team's own seed; empty if it uses the contest's seed} */
    public Optional<Long> seed() {
        return Optional.ofNullable(settings.get(TeamList.SEED)).map(Long::valueOf);
    }

    /** Returns whether one process runs all players. */
    boolean isTogether() {
        return settings.getOrDefault(TeamList.TOGETHER, "no").equals("yes");
    }

    /** Returns the main class configured for a role, or else the one configured for all roles. */
    Optional<String> mainClass(Role role) {
        return Optional.ofNullable(settings.get(role.key()))
                .or(() -> Optional.ofNullable(settings.get(Role.MAIN.key())));
    }
}
