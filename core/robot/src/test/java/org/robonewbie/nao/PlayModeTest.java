package org.robonewbie.nao;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PlayModeTest {

    @Test
    void namesTheTeamThatBringsTheBallIntoPlay() {
        assertThat(PlayMode.GOAL_KICK_RIGHT.kicker()).contains(TeamSide.RIGHT);
        assertThat(PlayMode.KICK_OFF_LEFT.kicker()).contains(TeamSide.LEFT);
        assertThat(PlayMode.FREE_KICK_LEFT.kicker()).contains(TeamSide.LEFT);
    }

    @Test
    void namesNoTeamWhileBothOrNobodyMayPlayTheBall() {
        assertThat(PlayMode.PLAY_ON.kicker()).isEmpty();
        assertThat(PlayMode.GOAL_LEFT.kicker()).isEmpty();
        assertThat(PlayMode.BEFORE_KICK_OFF.kicker()).isEmpty();
    }
}
