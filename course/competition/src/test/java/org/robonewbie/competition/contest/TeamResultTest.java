package org.robonewbie.competition.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class TeamResultTest {

    @Test
    void figuresAreReadWithTheirUnits() {
        TeamResult run = TeamResult.of("Red", Ending.PLAYED, Map.of("wayMetres", 3.0, "lineSeconds", 10.476));
        TeamResult other = TeamResult.of("Blue", Ending.PLAYED, Map.of("points", 8.0, "turnDegrees", -0.004));

        assertThat(run.inWords()).isEqualTo("Red: line 10.48 s, way 3 m");
        assertThat(other.inWords()).isEqualTo("Blue: points 8, turn 0°");
    }

    @Test
    void aLostTrialIsAWholeSentenceWithTheExitCode() {
        TeamResult crashed =
                TeamResult.of("Crash", Ending.STOPPED, Map.of("goals", 1.0)).withExitCode(OptionalInt.of(7));

        assertThat(new TrialResult("walk-Crash", 1, 0, List.of(crashed)).inWords())
                .isEqualTo("Crash: its program exited before the end of the trial (exit code 7)");
    }

    @Test
    void onlyAProgramThatHasEndedByItselfHasAnExitCode() {
        TeamResult played = TeamResult.of("Red", Ending.PLAYED, Map.of());
        TeamResult silent = TeamResult.of("Red", Ending.SILENT, Map.of());

        assertThat(played.withExitCode(OptionalInt.of(0))).isEqualTo(played);
        assertThat(silent.withExitCode(OptionalInt.of(137)).endingInWords())
                .isEqualTo("its program did not respond and was removed");
    }

    @Test
    void aTeamThatHasLostAllItsMatchesByItsProgramGetsNoCertificate() {
        TeamResult lost = TeamResult.of("Red", Ending.STOPPED, Map.of());
        TeamResult won = TeamResult.of("Blue", Ending.PLAYED, Map.of());
        Results results = id -> Optional.of(new TrialResult(id, 1, 1, List.of(lost, won)));

        assertThat(results.hasPlayed("Red", List.of("one", "two"))).isFalse();
        assertThat(results.hasPlayed("Blue", List.of("one"))).isTrue();
        assertThat(results.hasPlayed("Blue", List.of())).isFalse();
    }
}
