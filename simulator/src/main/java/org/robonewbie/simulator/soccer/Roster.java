package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Numbers the players while a game is saved or restored: those on the pitch in their order, then those that have left but are
 * still remembered, for having touched the ball last or for a collision. Of these it also notes team and number.
 */
final class Roster {

    private final List<Team> teams;
    private final List<Player> known;

    Roster(List<Team> teams, List<Player> players) {
        this.teams = teams;
        this.known = new ArrayList<>(players);
    }

    void save(Player player, StateWriter out) {
        int index = known.indexOf(player);
        out.putInt(index < 0 ? known.size() : index);
        if (index < 0) {
            known.add(player);
            out.putInt(teams.indexOf(player.team()));
            out.putInt(player.number());
        }
    }

    Player restore(StateReader in) {
        int index = in.getIndex(known.size() + 1);
        if (index == known.size()) {
            known.add(Player.departed(teams.get(in.getIndex(teams.size())), in.getInt()));
        }
        return known.get(index);
    }

    void saveAll(Collection<Player> players, StateWriter out) {
        out.putAll(players, player -> save(player, out));
    }

    Set<Player> restoreAll(StateReader in) {
        return new LinkedHashSet<>(in.getAll(() -> restore(in)));
    }
}
