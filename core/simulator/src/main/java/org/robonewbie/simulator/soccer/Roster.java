package org.robonewbie.simulator.soccer;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiFunction;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/**
 * Indexes players, so that references to them can be saved and restored. Players on the pitch come first. Players that
 * have left but are still referenced, for example by the last touch of the ball, are appended with their team and
 * number.
 */
final class Roster {

    private final List<Team> teams;
    private final List<Player> known;
    private final BiFunction<String, TeamSide, Team> createTeam;

    Roster(List<Team> teams, List<Player> players, BiFunction<String, TeamSide, Team> createTeam) {
        this.teams = teams;
        this.createTeam = createTeam;
        this.known = new ArrayList<>(players);
    }

    void save(Player player, StateWriter out) {
        int index = known.indexOf(player);
        out.putInt(index < 0 ? known.size() : index);
        if (index < 0) {
            known.add(player);
            saveTeam(player.team(), out);
            out.putInt(player.number());
        }
    }

    private void saveTeam(Team team, StateWriter out) {
        int index = teams.indexOf(team);
        out.putInt(index < 0 ? teams.size() : index);
        if (index < 0) {
            out.putText(team.name());
            out.putEnum(team.side());
        }
    }

    private Team restoreTeam(StateReader in) {
        int index = in.getIndex(teams.size() + 1);
        return index < teams.size() ? teams.get(index) : createTeam.apply(in.getText(), in.getEnum(TeamSide.values()));
    }

    Player restore(StateReader in) {
        int index = in.getIndex(known.size() + 1);
        if (index == known.size()) {
            known.add(Player.departed(restoreTeam(in), in.getInt()));
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
