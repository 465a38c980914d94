package org.robonewbie.workshop.sparring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SparringLeagueTest {

    private final ByteArrayOutputStream out = new ByteArrayOutputStream();

    @TempDir
    private Path folder;

    @Test
    void tableShowsBothTeamsAndContinuesFromTheJournal() throws IOException {
        play(1, "team:team");
        play(2, "team:team");

        assertThat(Files.readAllLines(folder.resolve("journal")))
                .hasSize(3)
                .first()
                .asString()
                .isEqualTo("Halves of 2.0 s with 2 players");
        assertThat(out.toString(StandardCharsets.UTF_8))
                .contains("| team | team | 0, 2, 0 | 0 : 0 |")
                .contains("| team | +0 ± ");
    }

    @Test
    void refusesAnUnknownTeam() {
        assertThatThrownBy(() -> play(1, "team:nowhere"))
                .hasMessage("There is no team \"nowhere\". Use team, before, kickers, pack, wall, nobody.");
        assertThatThrownBy(() -> play(1, "team")).hasMessageContaining("Write it as team:kickers.");
        assertThatThrownBy(() -> play(1, "nobody:team")).hasMessageContaining("cannot be nobody");
    }

    private void play(int seeds, String pair) throws IOException {
        out.reset();
        PrintStream printed = new PrintStream(out, true, StandardCharsets.UTF_8);
        new SparringLeague(2, 2, 1, Optional.of(folder.resolve("journal")), printed)
                .play(List.of(pair), seeds, 1, folder);
    }
}
