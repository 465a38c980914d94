package org.robonewbie.competition.team;

import java.util.Map;
import java.util.Optional;
import org.robonewbie.competition.contest.Role;

/**
 * A team as it has been entered.
 *
 * @param name letters of ASCII, digits and underscores, at most 20; the title has the letters of the team's language
 * @param program its program: a folder, a jar, a Java file, the name of a class, or a command
 * @param settings what else is said of it, by the words of {@link TeamList}
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

    /** {@return the team's members as written, empty if there are none} */
    public String members() {
        return settings.getOrDefault(TeamList.MEMBERS, "");
    }

    /** {@return the team's own seed; empty if it plays under the same conditions as the others} */
    public Optional<Long> seed() {
        return Optional.ofNullable(settings.get(TeamList.SEED)).map(Long::valueOf);
    }

    /** Whether one process runs all players. */
    boolean isTogether() {
        return settings.getOrDefault(TeamList.TOGETHER, "no").equals("yes");
    }

    /** The class that it wants for a role, or for all if it has none for this one. */
    Optional<String> mainClass(Role role) {
        return Optional.ofNullable(settings.get(role.key()))
                .or(() -> Optional.ofNullable(settings.get(Role.MAIN.key())));
    }
}
