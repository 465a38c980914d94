package org.robonewbie.competition.team;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.competition.contest.Role;

/**
 * A team as it has been entered.
 *
 * @param name letters, digits and underscores, at most 20
 * @param program its program: a folder, a jar, a Java file, the name of a class, or a command
 * @param settings what else is said of it, by the words of {@link TeamList}
 */
public record TeamEntry(String name, String program, Map<String, String> settings) {

    /** Makes the map unmodifiable. */
    public TeamEntry {
        settings = Map.copyOf(settings);
    }

    /**
     * Names the team for people.
     *
     * @return its title, or its name if it has none
     */
    public String title() {
        return settings.getOrDefault(TeamList.TITLE, name);
    }

    /**
     * Names its members.
     *
     * @return as written, empty if nobody is named
     */
    public String members() {
        return settings.getOrDefault(TeamList.MEMBERS, "");
    }

    /**
     * Tells its own seed.
     *
     * @return the seed, or empty if it plays under the same conditions as the others
     */
    public Optional<Long> seed() {
        return Optional.ofNullable(settings.get(TeamList.SEED)).map(Long::valueOf);
    }

    /** Tells whether one process brings all players. */
    boolean isTogether() {
        return settings.getOrDefault(TeamList.TOGETHER, "no").equals("yes");
    }

    /** Tells which class it wants for a role, or for all if it has none for this one. */
    Optional<String> mainClass(Role role) {
        return Optional.ofNullable(settings.get(role.key()))
                .or(() -> Optional.ofNullable(settings.get(Role.MAIN.key())));
    }
}
