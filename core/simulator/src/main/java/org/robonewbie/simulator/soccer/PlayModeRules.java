package org.robonewbie.simulator.soccer;

import java.util.EnumMap;
import java.util.Map;
import org.robonewbie.nao.PlayMode;
import org.robonewbie.nao.TeamSide;
import org.robonewbie.nao.state.StateReader;
import org.robonewbie.nao.state.StateWriter;

/** Rules for all play modes. */
final class PlayModeRules implements Memory {

    private final Map<PlayMode, PlayModeRule> rules = new EnumMap<>(PlayMode.class);

    PlayModeRules(Match match) {
        PlayModeRule playOn = new PlayOnRule(match);
        for (PlayMode mode : PlayMode.values()) {
            rules.put(mode, playOn);
        }
        rules.put(PlayMode.BEFORE_KICK_OFF, new BeforeKickOffRule(match));
        rules.put(PlayMode.GAME_OVER, () -> {});
        rules.put(PlayMode.OFFSIDE_LEFT, () -> {});
        rules.put(PlayMode.OFFSIDE_RIGHT, () -> {});
        for (TeamSide side : TeamSide.values()) {
            rules.put(of(side, PlayMode.KICK_OFF_LEFT, PlayMode.KICK_OFF_RIGHT), new KickOffRule(match, side));
            rules.put(of(side, PlayMode.GOAL_LEFT, PlayMode.GOAL_RIGHT), new GoalRule(match, side));
            rules.put(of(side, PlayMode.GOAL_KICK_LEFT, PlayMode.GOAL_KICK_RIGHT), new GoalKickRule(match, side));
            rules.put(of(side, PlayMode.PASS_LEFT, PlayMode.PASS_RIGHT), new PassRule(match, side, playOn));
            addFreeKicks(match, side);
        }
    }

    PlayModeRule of(PlayMode playMode) {
        PlayModeRule rule = rules.get(playMode);
        if (rule == null) {
            throw new IllegalStateException("No rule for play mode " + playMode);
        }
        return rule;
    }

    private void addFreeKicks(Match match, TeamSide side) {
        rules.put(
                of(side, PlayMode.KICK_IN_LEFT, PlayMode.KICK_IN_RIGHT),
                new FreeKickRule(match, side, true, () -> Spots.kickIn(match)));
        rules.put(
                of(side, PlayMode.CORNER_KICK_LEFT, PlayMode.CORNER_KICK_RIGHT),
                new FreeKickRule(match, side, false, () -> Spots.corner(match, side)));
        rules.put(
                of(side, PlayMode.FREE_KICK_LEFT, PlayMode.FREE_KICK_RIGHT),
                new FreeKickRule(match, side, true, () -> Spots.freeKick(match)));
        rules.put(
                of(side, PlayMode.DIRECT_FREE_KICK_LEFT, PlayMode.DIRECT_FREE_KICK_RIGHT),
                new FreeKickRule(match, side, false, () -> Spots.freeKick(match)));
    }

    static PlayMode of(TeamSide side, PlayMode left, PlayMode right) {
        return side == TeamSide.LEFT ? left : right;
    }

    @Override
    public void save(StateWriter out, Roster roster) {
        rules.values().forEach(rule -> rule.save(out, roster));
    }

    @Override
    public void restore(StateReader in, Roster roster) {
        rules.values().forEach(rule -> rule.restore(in, roster));
    }
}
