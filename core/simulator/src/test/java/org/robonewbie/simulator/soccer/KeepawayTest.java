package org.robonewbie.simulator.soccer;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.PlayMode;

/** Keep-away: where the ball has to stay, and who must not touch it. */
class KeepawayTest {

    @ParameterizedTest
    @CsvSource({
        "KeepawayLength=4, 3, 0, true",
        "KeepawayLength=8, 3, 0, false",
        "KeepawayWidth=4, 0, 3, true",
        "KeepawayCenterX=5, -6, 0, true",
        "KeepawayCenterY=5, 0, -6, true",
        "KeepawayLengthReductionRate=500, 9.5, 0, true",
        "KeepawayWidthReductionRate=500, 0, 9.5, true",
        "KeepawayWidthReductionRate=4, 0, 9.5, false"
    })
    void areaOfKeepawayCanBeSet(String assignment, double x, double y, boolean over) {
        Game game = playing("Keepaway=true", assignment);

        game.roll(x, y, 0, 0);
        game.cycles(0.2);

        assertThat(game.playMode() == PlayMode.GAME_OVER).isEqualTo(over);
    }

    @Test
    void keepawayEndsWhenTheRightTeamHasTheBall() {
        Game game = playing("Keepaway=true");
        game.put(game.join("Stars", 2), -5, 5);
        Player hunter = game.join("Moons", 2);

        game.touch(hunter);

        assertThat(game.playMode()).isEqualTo(PlayMode.GAME_OVER);
    }

    private static Game playing(String... assignments) {
        Game game = new Game(SoccerParameters.league(), assignments);
        game.match.setPlayMode(PlayMode.PLAY_ON);
        return game;
    }
}
